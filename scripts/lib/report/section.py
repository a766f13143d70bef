"""A part of the report: its text, its plots, and the numbers behind them."""

import csv
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable

Row = dict[str, Any]


@dataclass
class Plot:
    """A figure, drawn when the report is written. `draw` takes the path without an ending."""

    name: str
    message: str  # what it shows, in one sentence
    draw: Callable[[Path], None]


@dataclass
class Section:
    title: str
    introduction: str
    tables: list[str] = field(default_factory=list)  # Markdown, captions included
    findings: list[str] = field(default_factory=list)  # sentences made of this run's ratios
    plots: list[Plot] = field(default_factory=list)
    data: dict[str, list[Row]] = field(default_factory=dict)  # CSV file without ending: rows
    gaps: list[tuple[str, str]] = field(default_factory=list)  # what is missing, and why


def table(header: list[str], rows: list[list[str]]) -> str:
    """Markdown; the first column is text, the others are numbers."""
    rule = [":--", *["--:"] * (len(header) - 1)]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, rule, *rows])


def write_csv(path: Path, rows: list[Row]) -> None:
    """Columns in the order in which the rows name them."""
    columns: dict[str, None] = {}
    for row in rows:
        columns.update(dict.fromkeys(row))
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(columns), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
