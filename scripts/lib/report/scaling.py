"""Time and memory of a whole job against the number of voxels."""

import json

from . import volumes
from .matrix import Matrix
from .plots import scaling_plot
from .process import Programs, output_of
from .section import Plot, Row, Section, table
from .stats import Timing, digits, seconds_text

INTRODUCTION = """\
`isolume render` on `{scene}`, {width} x {height} pixels, from a VDB file to an EXR with all layers: what `--report`
says of a whole process, reading and writing included; distance and visibility by default, that is about the surface,
and visibility swept through it."""

MIB = 2**20
STAGES = {"read": "read", "distance": "distance", "visibility": "visibility", "upload": "upload", "frame": "frame", "write": "write"}


def run(programs: Programs, scene: volumes.Scene, matrix: Matrix, threads: int) -> Row:
    """Medians over the runs, stage by stage."""
    record, picture = programs.work / "scaling.json", programs.work / "scaling.exr"
    reports = []
    for _ in range(matrix.runs):
        output_of([programs.isolume, "render", *scene.arguments(), "--size",
                   f"{matrix.picture[0]}x{matrix.picture[1]}", "--layers", "all", "--threads", threads, "--report",
                   record, "-o", picture], threads)
        reports.append(json.loads(record.read_text(encoding="utf-8")))
    whole = Timing.of(report["seconds"] for report in reports)
    row: Row = {"scene": scene.name, "voxels": reports[0]["voxels"], "threads": threads, "seconds": whole.median,
                "seconds_least": whole.least, "seconds_most": whole.most,
                "peak_rss_mib": Timing.of(report["peak_rss_bytes"] / MIB for report in reports).median}
    for stage, name in STAGES.items():
        row[name] = Timing.of(next(entry["seconds"] for entry in report["stages"] if entry["name"] == stage)
                              for report in reports).median
    return row


def table_of(rows: list[Row]) -> str:
    lines = [[row["scene"], str(row["threads"]),
              seconds_text(Timing(row["seconds"], row["seconds_least"], row["seconds_most"])),
              *(digits(row[name]) for name in STAGES.values()), digits(row["peak_rss_mib"]),
              digits(row["peak_rss_mib"] * MIB / row["voxels"])] for row in rows]
    return table(["scene", "threads", "whole job, s", *(f"{name}, s" for name in STAGES.values()), "peak, MiB",
                  "bytes per voxel"], lines)


def findings(rows: list[Row]) -> list[str]:
    """How the sweep and the memory grow from the smallest to the largest."""
    threads = max(row["threads"] for row in rows)
    here = [row for row in rows if row["threads"] == threads]
    small, large = here[0], here[-1]
    return [f"From {small['scene']} to {large['scene']} voxels grow {digits(large['voxels'] / small['voxels'])} times, "
            f"the time of the distance {digits(large['distance'] / small['distance'])} times, of the visibility "
            f"{digits(large['visibility'] / small['visibility'])} times, of the whole job "
            f"{digits(large['seconds'] / small['seconds'])} times and peak memory "
            f"{digits(large['peak_rss_mib'] / small['peak_rss_mib'])} times ({threads} threads)."]


def measure(matrix: Matrix, programs: Programs) -> Section:
    section = Section("Scaling", INTRODUCTION.format(scene=matrix.scaling_scene, width=matrix.picture[0],
                                                     height=matrix.picture[1]))
    scenes = [volumes.sample(programs, matrix.scaling_scene, size) for size in matrix.scaling_sizes]
    rows = [run(programs, scene, matrix, threads) for threads in matrix.threads for scene in scenes]
    section.tables.append(table_of(rows))
    section.findings = findings(rows)
    section.data["scaling"] = rows
    last = [row for row in rows if row["threads"] == matrix.threads[-1]]
    section.plots.append(Plot("scaling", "How the stages of a job and its memory grow with the number of voxels.",
                              lambda path: scaling_plot(last, list(STAGES.values()), path)))
    return section
