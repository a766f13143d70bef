"""The peer that is a Python program of its own: VTK, under a virtual X server."""

import json
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

from .matrix import Matrix
from .process import Programs, has, json_of, output_of
from .volumes import Scene

# Debian's python3-vtk9 belongs to the system's Python, whichever one runs the report.
SYSTEM_PYTHON = "/usr/bin/python3"


@cache
def missing() -> str:
    """Why VTK cannot run here, or an empty text."""
    if not (has("xvfb-run") and has("xauth")):
        return "xvfb-run or xauth is not installed"
    if not Path(SYSTEM_PYTHON).exists():
        return f"there is no {SYSTEM_PYTHON}"
    tried = subprocess.run([SYSTEM_PYTHON, "-c", "import numpy, vtk"], capture_output=True, check=False)
    return "" if tried.returncode == 0 else "python3-vtk9 is not installed"


@cache
def exported(programs: Programs, scene: Scene, stem: str, matrix: Matrix) -> tuple[Path, Path, Any]:
    """Levels, place and camera of a scene as VTK can read them."""
    levels, place = programs.work / f"{stem}_levels.raw", programs.work / f"{stem}_scene.json"
    text = output_of([programs.report / "report_scene", *scene.arguments(), "--size",
                      f"{matrix.picture[0]}x{matrix.picture[1]}", "--levels", levels])
    place.write_text(text, encoding="utf-8")
    return levels, place, json.loads(text)


def vtk_gap(programs: Programs, scene: Scene, stem: str, matrix: Matrix) -> str:
    """Why VTK cannot draw that scene here, or an empty text."""
    if missing():
        return missing()
    _, _, place = exported(programs, scene, stem, matrix)
    upright = [[float(row == column) for column in range(3)] for row in range(3)]
    return "" if place["axes"] == upright else "its volume mapper takes no turned grids"


def run_vtk(programs: Programs, scene: Scene, stem: str, matrix: Matrix, threads: int) -> Any:
    """What vtk_peer.py measures."""
    levels, place, _ = exported(programs, scene, stem, matrix)
    script = Path(__file__).with_name("vtk_peer.py")
    # llvmpipe and VTK's filters count cores by themselves; both are told.
    environment = {"LP_NUM_THREADS": str(threads), "VTK_SMP_MAX_THREADS": str(threads)}
    # Without -noreset the server starts anew when a window closes, and a new one may meet it while it does.
    command = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 1280x1024x24 -noreset",
               SYSTEM_PYTHON, script, levels, place, programs.work / f"{stem}_vtk_", str(matrix.runs),
               ",".join(map(str, matrix.kernels))]
    return json_of(command, threads, environment)


