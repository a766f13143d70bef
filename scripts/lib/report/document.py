"""The report as a file: Markdown, with plots and CSV files in a folder beside it."""

from pathlib import Path

from .matrix import Matrix
from .section import Section, table, write_csv

HEAD = """\
# Run time against error

Made by `scripts/report{quick}`: every number below comes from that run, except the column `published` of the last
table, which cites its source. Times are wall time, the median of {runs} run{plural} (least to most in brackets), of one
process at a time on as many cores as it has threads. Where methods take turns, 16 bytes per voxel are touched and freed
before each: a virtual machine's host takes back memory that rests, and is slow to give it again. Absolute times belong
to this machine and its load; what carries over are ratios within the run.
{caution}"""

CAUTION = """
**This was a quick run: small volumes, few runs. It tests the report, and says nothing about speed.**
"""


def gaps_text(sections: list[Section]) -> str:
    gaps = [gap for section in sections for gap in section.gaps]
    if not gaps:
        return "Nothing is missing: every method ran on every scene."
    return table(["missing", "why"], [[what, why] for what, why in gaps])


def section_text(section: Section, folder: str) -> str:
    parts = [f"## {section.title}", section.introduction]
    if section.findings:
        parts.append("\n".join(f"- {sentence}" for sentence in section.findings))
    for plot in section.plots:
        parts.append(f"![{plot.message}]({folder}/{plot.name}.svg)\n\n*{plot.message}*")
    parts += section.tables
    parts.append("Data: " + ", ".join(f"[{name}.csv]({folder}/{name}.csv)" for name in section.data) + ".")
    return "\n\n".join(parts)


def text_of(description: list[tuple[str, str]], matrix: Matrix, sections: list[Section], folder: str) -> str:
    quick = matrix.name == "quick"
    head = HEAD.format(quick=" --quick" if quick else "", runs=matrix.runs, plural="" if matrix.runs == 1 else "s",
                       caution=CAUTION if quick else "")
    parts = [head.strip(), "## The machine", table(["what", "value"], [[f"{a}", b] for a, b in description]),
             *(section_text(section, folder) for section in sections), "## Gaps", gaps_text(sections)]
    return "\n\n".join(parts) + "\n"


def write(out: Path, description: list[tuple[str, str]], matrix: Matrix, sections: list[Section]) -> None:
    """report.md is written last: a report that exists is whole."""
    folder = out / "report"
    folder.mkdir(parents=True, exist_ok=True)
    for section in sections:
        for name, rows in section.data.items():
            write_csv(folder / f"{name}.csv", rows)
        for plot in section.plots:
            plot.draw(folder / plot.name)
    partial = out / "report.md.partial"
    partial.write_text(text_of(description, matrix, sections, folder.name), encoding="utf-8")
    partial.replace(out / "report.md")
