"""The error of every setting of openness on the reference scenes: the file that `isolume render --quality` goes by."""

import json
from pathlib import Path
from typing import Any

from .matrix import Matrix
from .process import Programs, json_of

NAME = "occlusion_calibration.json"


def write(matrix: Matrix, programs: Programs, folder: Path) -> Path:
    """Measures, and writes NAME into the folder."""
    size, points, rays = matrix.calibration
    report = json_of([programs.report / "report_calibration", "--size", size, "--points", points, "--rays", rays,
                      "--runs", matrix.runs])
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / NAME
    path.write_text(text_of(report))
    return path


def text_of(report: Any) -> str:
    """One line per setting, four digits: differences between two files can be read."""
    settings = ",\n".join(json.dumps(rounded(setting)) for setting in report["settings"])
    head = json.dumps({key: value for key, value in report.items() if key != "settings"})
    return f'{head[:-1]}, "settings": [\n{settings}\n]}}\n'


def rounded(value: Any) -> Any:
    """Every float of a value at four digits."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, list):
        return [rounded(each) for each in value]
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    return value
