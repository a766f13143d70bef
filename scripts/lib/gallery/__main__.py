"""Draws the gallery: see scripts/gallery."""

import argparse
import json
import os
import subprocess
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import OpenImageIO as oiio  # noqa: E402

from report.exr import write_exr  # noqa: E402

from .figures import VOLUMES, Figure, Panel, Row, Volume, figures  # noqa: E402

PIXELS = 360
RAYS = "128"  # of references: a standard error of .045 per pixel at the most, which the RMSE holds
INCHES = 1.9


class Gallery:
    def __init__(self, program: Path, data: Path | None, out: Path, work: Path) -> None:
        self.program, self.data, self.out, self.work = program, data, out, work
        self.made = 0

    def run(self, *arguments: object) -> str:
        done = subprocess.run([str(self.program), *map(str, arguments)], capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, arguments))}: {done.stderr.strip()}")
        return done.stdout

    def volume(self, volume: Volume) -> Path | None:
        """The file, made if it is a sample; None if it is not on this machine."""
        if volume.sample == 0:
            path = self.data / volume.name if self.data else None
            return path if path and path.exists() else None
        path = self.work / f"{volume.name}_{volume.sample}.vdb"
        if not path.exists():
            self.run("sample", volume.name, "--size", volume.sample, "--quiet", "-o", path)
        return path

    def draw(self, row: Row, path: Path, panel: Panel) -> Path:
        volume = VOLUMES[row.volume]
        self.made += 1
        exr = self.work / f"{self.made}.exr"
        common = [path, *volume.surface, *volume.view, "--size", f"{PIXELS}x{PIXELS}", "--quiet", "-o", exr]
        if panel.truth:
            self.run("reference", *common, *panel.options, *([] if "shadow" in panel.options else ["--rays", RAYS]))
        else:
            layer = panel.channel.split(".")[0] or "irradiance"
            self.run("render", *common, *panel.options, "--layers", f"{layer},depth")
        return exr

    def error(self, got: Path, panel: Panel, want: Path, truth: Panel) -> str:
        same = panel.channel == truth.channel
        options = ["--layer", panel.channel, *([] if same else ["--against", truth.channel])]
        measures = json.loads(self.run("compare", got, want, *options, "--json"))["measures"][0]
        return f"RMSE {measures['rmse']:.3f}, bias {measures['bias']:+.3f}"

    def figure(self, figure: Figure) -> str | None:
        rows = [(row, path) for row in figure.rows if (path := self.volume(VOLUMES[row.volume]))]
        if not rows:
            return None
        columns = max(len(row.panels) for row, _ in rows)
        canvas, axes = plt.subplots(len(rows), columns, figsize=(INCHES * columns, 1.18 * INCHES * len(rows)),
                                    squeeze=False, dpi=150)
        for axis in axes.flat:
            axis.axis("off")
        for line, (row, path) in zip(axes, rows):
            pictures = [self.draw(row, path, panel) for panel in row.panels]
            truth = next((i for i, panel in enumerate(row.panels) if panel.truth), None)
            for i, (axis, panel, picture) in enumerate(zip(line, row.panels, pictures)):
                below = ""
                if truth is not None and i != truth:
                    below = "\n" + self.error(picture, panel, pictures[truth], row.panels[truth])
                axis.imshow(shown(picture, panel.scale), interpolation="nearest")
                axis.set_title(f"{panel.caption}{below}", fontsize=6)
            print(f"{figure.name}: {row.volume}", flush=True)
        canvas.tight_layout(pad=0.3)
        folder = self.out / "gallery"
        folder.mkdir(parents=True, exist_ok=True)
        canvas.savefig(folder / f"{figure.name}.png")
        plt.close(canvas)
        names = ", ".join(dict.fromkeys(VOLUMES[row.volume].name for row, _ in rows))
        return (f"## {figure.title}\n\n{figure.text} Volumes: {names}.\n\n"
                f"![{figure.title}](gallery/{figure.name}.png)\n")


def channels(path: Path) -> dict[str, np.ndarray]:
    image = oiio.ImageInput.open(str(path))
    names = image.spec().channelnames
    pixels = image.read_image("float")
    image.close()
    return {name: pixels[:, :, i] for i, name in enumerate(names)}


def shown(path: Path, scale: float) -> np.ndarray:
    """As a screen shows it: sRGB."""
    image = channels(path)
    rgb = np.stack([image[name] for name in "RGB"], axis=2)
    hit = np.isfinite(image["Z"])[:, :, None]
    linear = np.clip(np.where(hit, rgb * scale, rgb), 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def write_skies(work: Path) -> tuple[Path, Path, Path]:
    """White above the horizon; a sky with a sun of 3 degrees, 30 above the horizon, to the right; and two halves, warm
    and blue."""
    rows, columns = 256, 512
    fall = (np.arange(rows) + 0.5)[:, None] * np.pi / rows
    turn = ((np.arange(columns) + 0.5)[None, :] / columns - 0.5) * 2 * np.pi
    up = np.cos(fall) + 0 * turn
    half = (up > 0).astype(np.float32)
    write_exr(work / "half.exr", {"R": half, "G": half, "B": half})
    sun = (0.6, -0.6, 0.53)
    towards = np.sin(fall) * np.sin(turn) * sun[0] + np.sin(fall) * np.cos(turn) * sun[1] + up * sun[2]
    bright = (towards > np.cos(np.radians(3))) * 120.0
    colors = {}
    for name, zenith, horizon, ground, tint in (("R", .25, .7, .18, 1), ("G", .4, .75, .14, .9), ("B", .8, .85, .1, .75)):
        sky = np.where(up > 0, horizon + (zenith - horizon) * np.maximum(up, 0)**.5, ground)
        colors[name] = (sky + tint * bright).astype(np.float32)
    write_exr(work / "sky.exr", colors)
    side = np.sin(fall) * np.sin(turn) * .8 - np.sin(fall) * np.cos(turn) * .4 + up * .35 > 0
    halves = {name: np.where(side, warm, blue).astype(np.float32)
              for name, warm, blue in (("R", .95, .05), ("G", .45, .1), ("B", .05, .85))}
    write_exr(work / "halves.exr", halves)
    return work / "half.exr", work / "sky.exr", work / "halves.exr"


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/gallery")
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--program", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--data", type=Path, help="folder of the real volumes")
    parser.add_argument("--out", type=Path, help="where to write (default: docs)")
    parser.add_argument("--only", help="one figure, by name; the page is not written")
    options = parser.parse_args()
    shared = Path(os.environ.get("ISOLUME_SHARED_DATA", options.root.parent / "shared" / "data"))
    with tempfile.TemporaryDirectory() as folder:
        gallery = Gallery(options.program, options.data or shared, options.out or options.root / "docs", Path(folder))
        wanted = [each for each in figures(*write_skies(Path(folder))) if options.only in (None, each.name)]
        parts = [part for each in wanted if (part := gallery.figure(each))]
        if options.only is None:
            head = ("# Gallery\n\nMade by `scripts/gallery`. Each picture stands beside its Monte Carlo reference; below "
                    f"the name is the error of the light, before albedo and gamma, over the pixels that hit. "
                    f"References have {RAYS} rays per pixel, whose noise is part of the RMSE.\n\n")
            (gallery.out / "gallery.md").write_text(head + "\n".join(parts))


main()
