"""Table 2 of the paper in its layout, with this run's seconds beside the published ones."""

from typing import Any

from .matrix import Matrix
from .process import Programs, json_of
from .section import Row, Section, table
from .stats import Timing, digits, range_text

# The only numbers here that no run produced. Seconds as printed in Table 2 of [Singh10] (Singh, Yuksel, House: Fast
# Occlusion Sweeping, 2010): one thread of an Intel Core 2 at 2.66 GHz. Without occlusion, combined occlusion, eight
# octants.
PUBLISHED: dict[tuple[int, int, int], tuple[float, float, float]] = {
    (101, 101, 61): (0.72, 0.91, 1.01),
    (100, 100, 100): (1.06, 1.386, 1.52),
    (150, 150, 150): (3.86, 6.52, 7.78),
    (200, 200, 200): (9.56, 17.12, 23.43),
    (250, 250, 250): (23.26, 39.66, 46.64),
}
PUBLISHED_SOURCE = "[Singh10], Table 2: Intel Core 2, 2.66 GHz, 4 GB"

INTRODUCTION = """\
Seconds for sweeping a data set, in the layout of the paper's Table 2; the published column is that of {source}. The
sizes are the paper's; its data sets are not published, so here a ball of .31 of the shortest side is swept, which
changes nothing: every sweep visits every voxel whatever the data. Every kernel is timed with its own distance sweep;
"combined occlusion" is one field for all octants. The kernels take turns, in a random order, and each time is the least
of {repetitions}: what one adds to another would else be lost in what else the machine does."""


def bench_rows(matrix: Matrix, programs: Programs) -> list[Any]:
    """Every repetition that tests/bench/sweep_bench.cpp times at the paper's sizes."""
    sizes = "|".join("/".join(map(str, size)) for size in matrix.table_sizes)
    report = json_of([programs.sweep_bench, f"--benchmark_filter=^(distanceAlone|oneNumber|eightOctants)/({sizes})/",
                      "--benchmark_format=json", f"--benchmark_repetitions={matrix.table_repetitions}",
                      "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.05"])
    return [entry for entry in report["benchmarks"] if entry["run_type"] == "iteration"]


def times_of(entries: list[Any]) -> dict[tuple[str, tuple[int, int, int], int], Timing]:
    """Kernel, size and threads (0: all cores) to seconds."""
    found: dict[tuple[str, tuple[int, int, int], int], list[float]] = {}
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
    for entry in entries:
        kernel, nx, ny, nz, threads, *_ = entry["run_name"].split("/")
        key = (kernel, (int(nx), int(ny), int(nz)), int(threads))
        found.setdefault(key, []).append(entry["real_time"] * units[entry["time_unit"]])
    return {key: Timing.of(seconds) for key, seconds in found.items()}


def rows_of(matrix: Matrix, times: dict[tuple[str, tuple[int, int, int], int], Timing]) -> list[Row]:
    rows = []
    for size in matrix.table_sizes:
        alone, combined, octants = PUBLISHED[size]
        row: Row = {"nx": size[0], "ny": size[1], "nz": size[2], "published_without": alone,
                    "published_combined": combined, "published_octants": octants}
        for threads, label in ((1, "one"), (0, "all")):
            row[f"without_{label}"] = times["distanceAlone", size, threads].least
            row[f"combined_{label}"] = times["oneNumber", size, threads].least
            row[f"octants_{label}"] = times["eightOctants", size, threads].least
        rows.append(row)
    return rows


def table_of(rows: list[Row], cores: int) -> str:
    here = ["here, 1 thread", f"here, {cores} threads"]
    header = ["NX NY NZ", "without occlusion: published", *here, "combined occlusion: published", *here,
              "8 octant occlusion: published", *here]
    lines = [[f"{row['nx']} {row['ny']} {row['nz']}", str(row["published_without"]), digits(row["without_one"]),
              digits(row["without_all"]), str(row["published_combined"]), digits(row["combined_one"]),
              digits(row["combined_all"]), str(row["published_octants"]),
              digits(row["octants_one"]), digits(row["octants_all"])] for row in rows]
    return table(header, lines)


def findings(rows: list[Row]) -> list[str]:
    ours = range_text((100 * (row["octants_one"] / row["without_one"] - 1) for row in rows), " %")
    combined = range_text((100 * (row["combined_one"] / row["without_one"] - 1) for row in rows), " %")
    theirs = range_text((100 * (row["published_octants"] / row["published_without"] - 1) for row in rows), " %")
    faster = range_text((row["published_octants"] / row["octants_one"] for row in rows), " times")
    return [f"Eight octants add {ours} to the distance sweep alone here, {theirs} as published (combined here {combined}); one "
            f"thread here is {faster} as fast as the published runs with eight octants, which an older machine made."]


def measure(matrix: Matrix, programs: Programs) -> Section:
    introduction = INTRODUCTION.format(source=PUBLISHED_SOURCE, repetitions=matrix.table_repetitions)
    section = Section("Table 2 of the paper", introduction)
    rows = rows_of(matrix, times_of(bench_rows(matrix, programs)))
    section.tables.append(table_of(rows, matrix.threads[-1]))
    section.findings = findings(rows)
    section.data["table2"] = rows
    return section
