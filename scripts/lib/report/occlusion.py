"""Ambient occlusion: seconds to the first and to every further picture against the error of the openness."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from . import equal_error, peers, volumes
from .matrix import Matrix
from .plots import occlusion_plot
from .process import Programs, json_of, output_of
from .section import Plot, Row, Section, table
from .stats import Timing, digits, range_text, seconds_text, sums
from .volumes import Scene

INTRODUCTION = """\
Truth: `isolume reference` with {rays} rays per pixel, {picture} pixels, the same view for all; error: RMSE of
the layer `ambient` over the pixels that both hit, by `isolume compare`, with the reference's own noise in it (its
size, and the RMSE without it, are in the CSV file). Openness is 1 for an open point and 0 for a closed one. Files are
read, and processes started, before the clock starts; everything runs once before it is timed. The first picture of a
method holds its preparation: distance and octants, context, shaders and textures for Isolume; mesh and BVH for Embree;
window, upload and, for the mesh, flying edges for VTK.

How each is used:

- **Isolume, octants**: `isolume render --occlusion octants --occlusion-offset` {offsets} (how far above the surface the
  octants are read; 0 is the published method).
- **Isolume, ordinates**: `isolume render --ordinates` {ordinates}, with `--refinement 2` from {refined} on.
- **Embree {embree}**: the quads of OpenVDB's `volumeToMesh` as triangles, default build quality, single rays,
  flush-to-zero; {knob} cosine-weighted stratified directions per pixel, turned by a random offset for each pixel; rays
  start {offset} of the scene's diagonal above the surface.
- **VTK {vtk}** under Xvfb on the same software OpenGL: `vtkOpenGLGPUVolumeRayCastMapper` in isosurface mode with
  samples one voxel apart (it gives a lit picture and no openness: time alone), and `vtkFlyingEdges3D` with
  `vtkSSAOPass`, radius a tenth of the scene's diagonal, {kernels} samples, blurred. Its openness is the picture of an
  unlit white surface with the pass divided by the one without, in 8 bits; it sees only what is on the screen and
  within its radius, so it answers an easier question than the others.

At equal error: for each setting of Isolume the fewest rays with which Embree's picture is no worse, RMSE without the
reference's noise. Where the largest number that was measured is still worse, its times stand behind a >: equal error
takes longer, or is not to be had, since its mesh is not the surface of the data. Pictures of {large} pixels have a
truth of {large_rays} rays per pixel, and Embree draws them once, after one to warm up."""

OCTANTS = "Isolume, octants"
ORDINATES = "Isolume, ordinates"
EMBREE = "Embree rays"


def reference(matrix: Matrix, programs: Programs, scene: Scene, stem: str) -> Path:
    """The truth, with all layers."""
    picture = programs.work / f"{stem}_reference.exr"
    output_of([programs.isolume, "reference", *scene.arguments(), "--size", size_text(matrix), "--rays",
               matrix.reference_rays, "-o", picture])
    return picture


def size_text(matrix: Matrix) -> str:
    return f"{matrix.picture[0]}x{matrix.picture[1]}"


def pixels_text(size: tuple[int, int]) -> str:
    return f"{size[0]} x {size[1]}"


def error_of(programs: Programs, picture: Path, truth: Path) -> Row:
    """What `isolume compare` says of the layer `ambient`."""
    report = json_of([programs.isolume, "compare", picture, truth, "--layer", "ambient", "--json"])
    return error_row(report)


def error_row(report: Any) -> Row:
    measures = report["measures"][0]
    row = {key: measures[key] for key in ("rmse", "bias", "mean", "p95", "max")}
    return {**row, "rmse_without_noise": measures["rmse_without_noise"], "reference_noise": measures["reference_noise"],
            "ssim": report["ssim"], "miss": report["miss"]}


def row_of(scene: Scene, threads: int, method: str, knob: float | None, first: list[float], further: list[float],
           error: Row) -> Row:
    a, b = Timing.of(first), Timing.of(further)
    return {"scene": scene.name, "threads": threads, "method": method, "knob": knob,
            "first_seconds": a.median, "first_least": a.least, "first_most": a.most,
            "further_seconds": b.median, "further_least": b.least, "further_most": b.most, **error}


def our_rows(matrix: Matrix, programs: Programs, scene: Scene, stem: str, truth: Path, threads: int) -> list[Row]:
    report = json_of([programs.report / "report_frames", *scene.arguments(), "--size", size_text(matrix), "--offsets",
                      ",".join(map(str, matrix.offsets)), "--ordinates",
                      ",".join(f"{count}:{refinement}" for count, refinement in matrix.ordinates), "--runs",
                      matrix.runs, "--threads", threads], threads)
    rows = []
    for entry in report["pictures"]:
        by_octants = entry["occlusion"] == "octants"
        knob = entry["occlusion-offset"] if by_octants else entry["ordinates"]
        picture = programs.work / f"{stem}_{entry['occlusion']}_{knob:g}.exr"
        output_of([programs.isolume, "render", *scene.arguments(), "--size", size_text(matrix),
                   *occlusion_options(entry), "--layers", "all", "-o", picture])
        first = sums(entry["sweep"], entry["upload"], entry["first_frame"])
        rows.append(row_of(scene, threads, OCTANTS if by_octants else ORDINATES, knob, first, entry["seconds"],
                           error_of(programs, picture, truth)))
    return rows


def occlusion_options(entry: Any) -> list[str]:
    """The command line of a setting as report_frames tells it."""
    keys = ("occlusion", "occlusion-offset", "ordinates", "refinement")
    return [word for key in keys if key in entry for word in (f"--{key}", str(entry[key]))]


def embree_rows(matrix: Matrix, programs: Programs, scene: Scene, stem: str, truth: Path,
                threads: int) -> tuple[list[Row], Any]:
    report = json_of([programs.report / "peer_embree", *scene.arguments(), "--size", size_text(matrix), "--rays",
                      ",".join(map(str, matrix.rays)), "--runs", matrix.runs, "--threads", threads, "-o",
                      programs.work / f"{stem}_embree_"], threads)
    rows = []
    for entry in report["pictures"]:
        error = error_of(programs, Path(entry["picture"]), truth)
        first = sums(report["mesh"], report["bvh"], entry["seconds"])
        rows.append(row_of(scene, threads, EMBREE, entry["rays"], first, entry["seconds"], error))
    return rows, report


def vtk_rows(matrix: Matrix, programs: Programs, scene: Scene, stem: str, truth: Path,
             threads: int) -> tuple[list[Row], Any]:
    report = peers.run_vtk(programs, scene, stem, matrix, threads)
    rows = []
    for entry in report["pictures"]:
        error = error_of(programs, Path(entry["picture"]), truth) if entry.get("picture") else {}
        rows.append(row_of(scene, threads, entry["method"], entry.get("knob"), entry["first"], entry["further"], error))
    return rows, report


def scenes_of(matrix: Matrix, programs: Programs, section: Section) -> list[Scene]:
    found = [volumes.sample(programs, name, size) for size in matrix.occlusion_sizes
             for name in matrix.occlusion_scenes]
    for volume in matrix.occlusion_volumes:
        scene = volumes.shared(programs, volume)
        if scene:
            found.append(scene)
        else:
            section.gaps.append((f"occlusion, {volume.name}", f"this machine does not have {volume.file}"))
    return found


def table_of(rows: list[Row]) -> str:
    lines = []
    for row in rows:
        knob = "" if row["knob"] is None else f" {row['knob']:g}"
        first = Timing(row["first_seconds"], row["first_least"], row["first_most"])
        further = Timing(row["further_seconds"], row["further_least"], row["further_most"])
        lines.append([f"{row['method']}{knob}", str(row["threads"]), seconds_text(first), seconds_text(further),
                      *(digits(row.get(key)) for key in ("rmse", "bias", "ssim", "miss"))])
    return table(["method, knob", "threads", "first picture, s", "further picture, s", "RMSE", "bias", "SSIM",
                  "miss"], lines)


def findings(scene: Scene, rows: list[Row]) -> list[str]:
    """Isolume's best picture against Embree's, with most threads."""
    threads = max(row["threads"] for row in rows)
    here = [row for row in rows if row["threads"] == threads]
    ours = min((row for row in here if row["method"] == ORDINATES), key=lambda row: row["rmse"])
    published = next((row for row in here if row["method"] == OCTANTS and row["knob"] == 0), None)
    text = f"**{scene.name}**: Isolume's RMSE is {digits(ours['rmse'])} with {ours['knob']:g} ordinates"
    if published:
        text += f" ({digits(published['rmse'])} as published)"
    rays = [row for row in here if row["method"] == EMBREE]
    if rays:
        times = range_text((row["further_seconds"] / ours["further_seconds"] for row in rays), " times")
        errors = range_text((row["rmse"] for row in rays))
        text += (f"; Embree's is {errors} over {rays[0]['knob']:g} to {rays[-1]['knob']:g} rays per pixel, "
                 f"at {times} the time of a further picture")
    return [text + "."]


def large_rows(matrix: Matrix, programs: Programs, scene: Scene, stem: str, threads: int) -> list[Row]:
    """The same view in more pixels: Isolume and Embree."""
    large = replace(matrix, picture=matrix.large_picture, reference_rays=matrix.large_reference_rays,
                    ordinates=matrix.large_ordinates, rays=matrix.large_rays, offsets=matrix.offsets[-1:])
    stem = f"{stem}_large"
    truth = reference(large, programs, scene, stem)
    rows = our_rows(large, programs, scene, stem, truth, threads)
    return rows + embree_rows(replace(large, runs=1), programs, scene, stem, truth, threads)[0]


def add_equal_error(section: Section, name: str, rows: list[Row]) -> None:
    found = equal_error.compare([row for row in rows if row["method"] == ORDINATES],
                                [row for row in rows if row["method"] == EMBREE])
    section.tables.append(f"**{name}, at equal error**\n\n" + equal_error.table_of(found, EMBREE))
    section.findings.append(equal_error.finding(name, found, EMBREE))
    section.data.setdefault("equal_error", []).extend({"scene": name, **row} for row in found)


def measure(matrix: Matrix, programs: Programs) -> Section:
    section = Section("Occlusion", "")
    versions = dict.fromkeys(("embree", "offset", "vtk"), "(not in this run)")
    all_rows: list[Row] = []
    for scene in scenes_of(matrix, programs, section):
        stem = scene.path.name.partition(".")[0]
        truth = reference(matrix, programs, scene, stem)
        threads = matrix.threads[-1]
        rows = our_rows(matrix, programs, scene, stem, truth, threads)
        has_embree = (programs.report / "peer_embree").exists()
        if has_embree:
            peer, report = embree_rows(matrix, programs, scene, stem, truth, threads)
            rows += peer
            versions |= {"embree": report["version"], "offset": digits(report["ray_offset_of_diagonal"])}
        else:
            section.gaps.append(("occlusion, Embree", "Embree was not found by the build"))
        gap = peers.vtk_gap(programs, scene, stem, matrix)
        if gap:
            section.gaps.append((f"occlusion, {scene.name}, VTK", gap))
        else:
            peer, report = vtk_rows(matrix, programs, scene, stem, truth, threads)
            rows += peer
            versions["vtk"] = report["version"]
        section.tables.append(f"### {scene.name}\n\n" + table_of(rows))
        section.findings += findings(scene, rows)
        if has_embree:
            add_equal_error(section, scene.name, rows)
            if scene.name.startswith(matrix.large_scenes):
                larger = large_rows(matrix, programs, scene, stem, threads)
                name = f"{scene.name}, {pixels_text(matrix.large_picture)} pixels"
                section.tables.append(f"### {name}\n\n" + table_of(larger))
                add_equal_error(section, name, larger)
                all_rows += [{**row, "scene": name} for row in larger]
        section.plots.append(Plot(f"occlusion_{stem}", f"{scene.name}, {matrix.threads[-1]} threads: to the left is "
                                  "faster, below is closer to the truth; labels are each method's knob.",
                                  lambda path, shown=rows, title=scene.name: occlusion_plot(shown, title, path)))
        all_rows += rows
    section.gaps = list(dict.fromkeys(section.gaps))
    section.data["occlusion"] = all_rows
    section.introduction = INTRODUCTION.format(
        large=pixels_text(matrix.large_picture), large_rays=matrix.large_reference_rays,
        rays=matrix.reference_rays, picture=pixels_text(matrix.picture),
        offsets=", ".join(map(str, matrix.offsets)), ordinates=", ".join(str(count) for count, _ in matrix.ordinates),
        refined=min((count for count, refinement in matrix.ordinates if refinement > 1), default=0), knob=", ".join(map(str, matrix.rays)),
        kernels=", ".join(map(str, matrix.kernels)), **versions)
    return section
