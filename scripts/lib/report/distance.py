"""Distance solvers: seconds against error, on shapes and on a scan, judged by a brute-force closest point."""

from typing import Any

from . import volumes
from .matrix import Matrix
from .plots import distance_plot
from .process import Programs, json_of
from .section import Plot, Row, Section, table
from .stats import Timing, digits, range_text, seconds_text

INTRODUCTION = """\
Every solver gets the same samples and fills the whole grid with signed distances. Reading a file, and handing the
samples to a library in its own form, are not timed; each solver runs once before it is timed, and then all take turns.
Errors are in voxels, against the distance to the trilinear isosurface itself, found by a branch-and-bound search in double precision that
stops when the true distance is known to {tolerance} voxel (`tests/bench/report/closest_distance.h`), at {anywhere}
voxels drawn from the whole grid (mean) and {near} more drawn from around the surface (with the others: maximum, and
the errors within {reach} voxels of the surface). A maximum is thus that of the drawn voxels.

How each is used:

{calls}

ITK's transform sees a mask, so its surface lies at voxel centres: that is what it is made
for, and most of its error."""


def inputs(matrix: Matrix, programs: Programs, section: Section) -> list[tuple[str, list[str]]]:
    """Names and arguments of what is solved; a volume that is not here is a gap."""
    found = [(f"{shape} {size}³", ["--shape", shape, "--size", str(size)])
             for size in matrix.distance_sizes for shape in matrix.distance_shapes]
    for volume in matrix.distance_volumes:
        scene = volumes.shared(programs, volume)
        if scene:
            found.append((scene.name, scene.arguments()))
        else:
            section.gaps.append((f"distance, {volume.name}", f"this machine does not have {volume.file}"))
    return found


def rows_of(name: str, report: Any) -> list[Row]:
    rows = []
    for solver in report["solvers"]:
        time = Timing.of(solver["seconds"])
        rows.append({"scene": name, "voxels": report["voxels"], "threads": report["threads"],
                     "solver": solver["solver"], "version": solver["version"], "seconds": time.median,
                     "seconds_least": time.least, "seconds_most": time.most,
                     **{key: solver[key] for key in ("mean_error", "max_error", "mean_error_near", "max_error_near",
                                                     "wrong_sign")}})
    return rows


def timing(row: Row) -> Timing:
    return Timing(row["seconds"], row["seconds_least"], row["seconds_most"])


def table_of(rows: list[Row], threads: tuple[int, ...]) -> str:
    """One line for each scene and solver, a column of seconds for each number of threads."""
    lines, seen = [], set()
    for row in rows:
        key = (row["scene"], row["solver"])
        if key in seen:
            continue
        seen.add(key)
        times = [next((timing(other) for other in rows if (other["scene"], other["solver"]) == key
                       and other["threads"] == count), None) for count in threads]
        lines.append([f"{row['scene']}, {row['solver']}", *map(seconds_text, times),
                      *(digits(row[key]) if row[key] is not None else "–" for key in ("mean_error", "max_error", "mean_error_near", "max_error_near"))])
    header = ["scene, solver", *(f"s, {count} thread{'s' if count > 1 else ''}" for count in threads), "mean error",
              "max error", "mean within 3", "max within 3"]
    return table(header, lines)


def findings(rows: list[Row]) -> list[str]:
    """Ratios of times and errors of the same scene and number of threads."""
    sentences = []
    for mine in ("Isolume closest", "Isolume sweep"):
        ours = {(row["scene"], row["threads"]): row for row in rows if row["solver"] == mine}
        for solver in dict.fromkeys(row["solver"] for row in rows if not row["solver"].startswith("Isolume")):
            pairs = [(row, ours[row["scene"], row["threads"]]) for row in rows if row["solver"] == solver]
            times = range_text((theirs["seconds"] / our["seconds"] for theirs, our in pairs), " times")
            errors = range_text((theirs["mean_error"] / our["mean_error"] for theirs, our in pairs), " times")
            near = range_text((theirs["mean_error_near"] / our["mean_error_near"] for theirs, our in pairs), " times")
            sentences.append(f"{solver} takes {times} as long as {mine} with as many threads; its mean error is "
                             f"{errors} ours, within 3 voxels of the surface {near}.")
        shares = []
        for part in ("band", "picture"):
            partly = {(row["scene"], row["threads"]): row for row in rows if row["solver"] == f"{mine}, {part}"}
            shares.append(range_text(partly[key]["seconds"] / row["seconds"] for key, row in ours.items()))
        sentences.append(f"A band of 3 voxels takes {shares[0]} of the time of {mine} over the whole grid, the voxel that "
                         f"a picture needs {shares[1]}.")
    return sentences


def measure(matrix: Matrix, programs: Programs) -> Section:
    section = Section("Distance solvers", "")
    rows: list[Row] = []
    report: Any = None
    for name, arguments in inputs(matrix, programs, section):
        for threads in matrix.distance_threads:
            report = json_of([programs.report / "report_distance", *arguments, "--threads", threads, "--runs",
                              matrix.runs, "--judged", matrix.judged], threads)
            rows += rows_of(name, report)
            section.gaps += [(f"distance, {name}, {gap['solver']}", gap["reason"]) for gap in report["gaps"]]
    section.gaps = list(dict.fromkeys(section.gaps))
    calls = "\n".join(f"- **{solver['solver']}** ({solver['version']}): {solver['call']}"
                      for solver in report["solvers"])
    section.introduction = INTRODUCTION.format(tolerance=report["truth_tolerance"], anywhere=matrix.judged,
                                               near=matrix.judged, reach=f"{report['near']:g}", calls=calls)
    section.tables.append(table_of(rows, matrix.distance_threads))
    section.findings = findings(rows)
    section.data["distance"] = rows
    last = [row for row in rows if row["threads"] == matrix.distance_threads[-1]]
    section.plots.append(Plot("distance", "Distance solvers: to the left is faster, below is more accurate; left "
                              "over the whole grid, right next to the surface.",
                              lambda path: distance_plot(last, path)))
    return section
