"""The screen-space estimators beside the sweeps: milliseconds per frame against the error of the openness."""

from typing import Any

from . import volumes
from .matrix import Matrix
from .plots import screen_plot
from .process import Programs, json_of
from .section import Plot, Row, Section, table
from .stats import digits

INTRODUCTION = """\
Every estimator that reads the picture alone (`isolume render --occlusion NAME`, [usage](usage.md)),
by `report_screen` on {scenes}: {samples} samples per pixel unless said otherwise, radius a tenth of the
solid's longest side, interleaved 4 x 4 and filtered, surface by the z-buffer or by the volume (`implicit`). Frames are
{time} pixels with everything drawn anew, the median of {runs}; errors are those of {width} x {height} pixels over
those that hit, by {rays} exact rays each, whose noise is within them: to the integral that an estimator approximates,
with its radius and membership function (`own`), and to ambient occlusion without a limit (`ambient`). Sweeps take their
time once for all views; their frames need no more than that."""

LIGHT = """\
Under a sky of two coloured halves, RMSE of E / pi over the three colours; `over occlusion` is the frame's time beyond
that of the same source's plain openness, timed in turn in the same process. `none` lights by openness alone, `normal`
and `cone` as in [Klehm11], `cap` with the exact angle of a cap."""


def name_of(row: Row) -> str:
    """What was asked for, in few words."""
    name = row["occlusion"]
    if "ordinates" in row:
        return f"{row['ordinates']} ordinates" + (", refined" if row.get("refinement", 1) > 1 else "")
    if row.get("octant-terms", "published") != "published":
        name += f", {row['octant-terms']}"
    if "bent-from" in row:
        name += f", {row['bent-from']}"
    if row.get("surface") == "implicit":
        name += ", implicit"
    if row.get("ao-normalisation") == "exact":
        name += ", exact volume"
    return name


def estimators(rows: list[Row]) -> str:
    lines = [[name_of(row), str(row.get("ao-samples", "")), digits(row["milliseconds"]), row.get("integral", ""),
              *(digits(row[key]) if key in row else "" for key in ("rmse", "bias", "rmse_ambient", "bias_ambient"))]
             for row in rows]
    header = ["estimator", "samples", "ms", "own integral", "own RMSE", "own bias", "ambient RMSE", "ambient bias"]
    return table(header, lines)


def sweeps(rows: list[Row]) -> str:
    lines = [[name_of(row), *(digits(row[key]) for key in ("sweep_milliseconds", "milliseconds", "rmse_ambient",
                                                           "bias_ambient"))] for row in rows]
    return table(["sweep", "ms once", "ms per frame", "ambient RMSE", "ambient bias"], lines)


def light(rows: list[Row]) -> str:
    lines = [[name_of(row), row.get("bent", ""), digits(row["milliseconds"]), f"{100 * row['over_occlusion']:.0f} %",
              digits(row["rmse"]), digits(row["bias"])] for row in rows if row["sky"] != "even"]
    return table(["light", "lookup", "ms", "over occlusion", "RMSE", "bias"], lines)


def flat(name: str, report: Any) -> list[Row]:
    """All rows of a volume, with what they are of."""
    return [{"volume": name, "kind": kind, **row} for kind in ("rows", "sweeps", "light") for row in report[kind]]


def measure(matrix: Matrix, programs: Programs) -> Section:
    """Stage by stage for each volume of the matrix that is there."""
    width, height = matrix.screen_picture
    time = f"{matrix.screen_time[0]}x{matrix.screen_time[1]}"
    scenes = [volumes.sample(programs, matrix.screen_scene, matrix.screen_size)]
    section = Section("Occlusion from the screen", "")
    for volume in matrix.screen_volumes:
        scene = volumes.shared(programs, volume)
        if scene is None:
            section.gaps.append((f"screen-space estimators on {volume.name}", f"{volume.file} is not on this machine"))
        else:
            scenes.append(scene)
    section.introduction = INTRODUCTION.format(
        scenes=" and ".join(scene.name for scene in scenes), samples=matrix.screen_samples,
        time=time.replace("x", " x "), runs=matrix.runs, width=width, height=height, rays=matrix.screen_rays)
    everything: list[Row] = []
    for scene in scenes:
        report = json_of([programs.report / "report_screen", *scene.arguments(), "--size", f"{width}x{height}",
                          "--time-size", time, "--samples", matrix.screen_samples, "--rays", matrix.screen_rays,
                          "--runs", matrix.runs, "--threads", matrix.threads[-1]])
        head_light = next(row["milliseconds"] for row in report["rows"] if row["occlusion"] == "none")
        judged = [row for row in report["rows"] if row["occlusion"] != "none"]
        section.tables += [f"### {scene.name}\n\nThe head light alone takes {digits(head_light)} ms a frame.",
                           estimators(judged), sweeps(report["sweeps"]), LIGHT, light(report["light"])]
        stem = scene.name.split()[0]
        section.plots.append(Plot(
            f"screen_{stem}", f"{scene.name}: a frame's time against the error to ambient occlusion; below and to the "
            "left is better.", lambda path, name=scene.name, rows=judged, swept=report["sweeps"]: screen_plot(
                [(name_of(row), row) for row in rows], [(name_of(row), row) for row in swept], name, path)))
        section.findings.append(finding(scene.name, judged, report["sweeps"]))
        everything += flat(scene.name, report)
    section.data["screen"] = everything
    return section


def finding(name: str, rows: list[Row], swept: list[Row]) -> str:
    best = min(rows, key=lambda row: row["rmse_ambient"])
    openness = next(row for row in swept if row.get("ordinates") == 512)
    return (f"On {name} the estimator closest to ambient occlusion is {name_of(best)}: RMSE "
            f"{digits(best['rmse_ambient'])} in {digits(best['milliseconds'])} ms a frame. 512 ordinates have "
            f"{digits(openness['rmse_ambient'])} in {digits(openness['milliseconds'])} ms, after a sweep of "
            f"{digits(openness['sweep_milliseconds'])} ms that serves every view.")
