"""The figures: log-log axes, direct labels, the colours of Okabe and Ito, SVG for the report and PNG to look at."""

from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")  # no window
import matplotlib.pyplot as plt  # noqa: E402  the backend has to be chosen before
from matplotlib.ticker import FuncFormatter, NullFormatter  # noqa: E402

from .section import Row  # noqa: E402
from .stats import digits  # noqa: E402
from .styles import BLUE, GREY, MARKERS, OTHERS, VERMILION, style_of  # noqa: E402

PANEL_INCHES = (4.6, 3.7)
# The same bytes for the same numbers.
matplotlib.rcParams.update({"svg.hashsalt": "isolume", "svg.fonttype": "none", "font.size": 10,
                            "axes.spines.top": False, "axes.spines.right": False})


def new_figure(panels: int, title: str) -> tuple[Any, list[Any]]:
    figure, axes = plt.subplots(1, panels, figsize=(PANEL_INCHES[0] * panels, PANEL_INCHES[1]), squeeze=False)
    figure.suptitle(title, fontsize=11, x=0.01, ha="left")
    return figure, list(axes[0])


def log_axis(axis: Any) -> None:
    """Plain numbers at 1, 2 and 5 times each power of ten, thinned where there are many."""
    low, high = axis.get_view_interval()
    steps = (1, 2, 5) if high / low < 200 else (1,)
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=steps))
    axis.set_major_formatter(FuncFormatter(lambda value, _: digits(value, 1)))
    axis.set_minor_formatter(NullFormatter())


def finish(axes: Any, x: str, y: str, log_x: bool = True, log_y: bool = True) -> None:
    if log_x:
        axes.set_xscale("log")
        axes.margins(x=0.15)
        log_axis(axes.xaxis)
    if log_y:
        axes.set_yscale("log")
        log_axis(axes.yaxis)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True, which="major", color="#e6e6e6", linewidth=0.8)
    axes.set_axisbelow(True)


def legend_below(figure: Any, axes: Any) -> None:
    """One legend for all panels, under them."""
    handles, labels = axes.get_legend_handles_labels()
    columns = 4
    rows = -(-len(labels) // columns)
    figure.tight_layout(rect=(0, 0.03 + 0.05 * rows, 1, 0.97))
    figure.legend(handles, labels, loc="lower left", ncol=min(len(labels), columns), frameon=False, fontsize=9)


def save(figure: Any, path: Path) -> None:
    figure.savefig(path.with_suffix(".svg"), metadata={"Date": None})
    figure.savefig(path.with_suffix(".png"), dpi=110)
    plt.close(figure)


def distance_plot(rows: list[Row], path: Path) -> None:
    """Every scene a point, every solver a colour."""
    threads = rows[0]["threads"]
    figure, panels = new_figure(2, f"Distance: seconds against error, {threads} threads; each point is a scene")
    judged = [row for row in rows if row["mean_error_near"] is not None]  # what a picture needs is too narrow for it
    styles = style_of(list(dict.fromkeys(row["solver"] for row in judged)))
    for axes, key, label in zip(panels, ("mean_error", "mean_error_near"),
                                ("mean error, whole grid, voxels", "mean error within 3 voxels, voxels")):
        for solver, (color, marker) in styles.items():
            mine = [row for row in rows if row["solver"] == solver and row[key] is not None]
            axes.scatter([row["seconds"] for row in mine], [row[key] for row in mine], color=color, marker=marker,
                         s=42, label=solver)
        finish(axes, "seconds", label)
    legend_below(figure, panels[0])
    save(figure, path)


def occlusion_plot(rows: list[Row], scene: str, path: Path) -> None:
    """One curve per method over its knob; methods without openness are not drawn."""
    shown = [row for row in rows if row.get("rmse") is not None]
    figure, panels = new_figure(2, f"{scene}: ambient occlusion, {rows[0]['threads']} threads")
    styles = style_of(list(dict.fromkeys(row["method"] for row in shown)))
    for axes, key, label in zip(panels, ("first_seconds", "further_seconds"),
                                ("seconds to the first picture", "seconds per further picture")):
        for method, (color, marker) in styles.items():
            mine = [row for row in shown if row["method"] == method]
            x, y = [row[key] for row in mine], [row["rmse"] for row in mine]
            axes.plot(x, y, color=color, marker=marker, markersize=6, linewidth=1.6, label=method)
            for row, left, height in zip(mine, x, y):
                axes.annotate(f"{row['knob']:g}", (left, height), textcoords="offset points", xytext=(6, 4),
                              fontsize=8, color=color)
        finish(axes, label, "RMSE of openness")
    legend_below(figure, panels[0])
    save(figure, path)


def screen_plot(estimators: list[tuple[str, Row]], sweeps: list[tuple[str, Row]], scene: str, path: Path) -> None:
    """Each estimator a point with its name; a sweep's frame a point, its sweep on top of that a line to the right."""
    figure, (axes,) = new_figure(1, f"{scene}: from the screen, and by sweeps")
    figure.set_size_inches(2 * PANEL_INCHES[0], 1.6 * PANEL_INCHES[1])
    for color, marker, rows in ((BLUE, "s", estimators), (VERMILION, "o", sweeps)):
        for name, row in rows:
            x, y = row["milliseconds"], row["rmse_ambient"]
            axes.scatter([x], [y], color=color, marker=marker, s=30)
            if "sweep_milliseconds" in row:
                axes.plot([x, x + row["sweep_milliseconds"]], [y, y], color=color, linewidth=1)
            axes.annotate(name, (x, y), textcoords="offset points", xytext=(5, 3), fontsize=7, color=color)
    finish(axes, "milliseconds per frame (line: with the sweep)", "RMSE to ambient occlusion")
    figure.tight_layout()
    save(figure, path)


def scaling_plot(rows: list[Row], stages: list[str], path: Path) -> None:
    """Left: each stage and the whole; right: peak memory, with the size of the samples."""
    figure, (times, memory) = new_figure(2, f"One picture by `isolume render`, {rows[0]['threads']} threads")
    voxels = [row["voxels"] for row in rows]
    for series, color, marker in zip(["seconds", *stages], (VERMILION, *OTHERS), ("o", *MARKERS)):
        y = [row[series] for row in rows]
        label = "whole job" if series == "seconds" else series
        times.plot(voxels, y, color=color, marker=marker, linewidth=1.6, markersize=5, label=label)
    finish(times, "voxels", "seconds")
    memory.plot(voxels, [row["peak_rss_mib"] for row in rows], color=VERMILION, marker="o", linewidth=1.6,
                label="peak resident memory")
    memory.plot(voxels, [row["voxels"] * 4 / 2**20 for row in rows], color=GREY, linestyle="--", linewidth=1.2,
                label="the samples alone, 4 bytes each")
    memory.margins(y=0.2)
    finish(memory, "voxels", "MiB")
    memory.legend(loc="best", frameon=False, fontsize=9)
    for axes in (times, memory):
        axes.set_xticks(voxels, [f"{round(count ** (1 / 3))}³" for count in voxels])
    legend_below(figure, times)
    save(figure, path)
