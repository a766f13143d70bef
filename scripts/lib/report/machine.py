"""The machine and the libraries of a run."""

import json
import math
import os
import platform
import re
from pathlib import Path

from .process import CommandFailed, Programs, output_of

# Debian packages whose versions decide on speed.
PACKAGES = ("libgl1-mesa-dri", "libosmesa6", "libopenvdb-dev", "libinsighttoolkit5-dev", "libembree-dev",
            "python3-vtk9", "libtbb-dev", "libhwy-dev", "g++")


def processor() -> str:
    """The model's name as the kernel gives it."""
    text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    found = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
    return found.group(1).strip() if found else platform.machine()


def vector_extensions() -> str:
    """The widest instruction sets that libraries may choose at run time."""
    flags = set(re.findall(r"\b(?:avx512f|avx2|sse4_2)\b", Path("/proc/cpuinfo").read_text(encoding="utf-8")))
    return ", ".join(name for name in ("avx512f", "avx2", "sse4_2") if name in flags) or "none known"


def memory_gib() -> float:
    found = re.search(r"^MemTotal:\s+(\d+) kB", Path("/proc/meminfo").read_text(encoding="utf-8"), re.MULTILINE)
    return int(found.group(1)) / 2**20 if found else math.nan


def package_versions() -> list[tuple[str, str]]:
    """Those that are installed; an empty list where there is no dpkg."""
    versions = []
    for package in PACKAGES:
        try:
            text = output_of(["dpkg-query", "-W", "-f=${db:Status-Status} ${Version}", package])
        except CommandFailed:
            continue
        status, _, version = text.partition(" ")
        if status == "installed":
            versions.append((package, version))
    return versions


def graphics(programs: Programs) -> str:
    """What draws Isolume's pictures, from a small one."""
    volume, picture = programs.work / "probe.vdb", programs.work / "probe.png"
    record = programs.work / "probe.json"
    output_of([programs.isolume, "sample", "capsules", "--size", "16", "--quiet", "-o", volume])
    output_of([programs.isolume, "render", volume, "--size", "16x16", "--quiet", "--report", record, "-o", picture])
    settings = json.loads(record.read_text(encoding="utf-8"))["settings"]
    return f"{settings['gl']} ({settings['backend']})"


def describe(programs: Programs) -> list[tuple[str, str]]:
    """Facts, in order."""
    facts = [
        ("Processor", f"{processor()}; {vector_extensions()}"),
        ("Cores that the run may use", str(len(os.sched_getaffinity(0)))),
        ("Memory", f"{memory_gib():.1f} GiB"),
        ("Kernel", f"{platform.system()} {platform.release()}"),
        ("Isolume", output_of([programs.isolume, "--version"]).strip()),
        ("OpenGL", graphics(programs)),
    ]
    return facts + package_versions()
