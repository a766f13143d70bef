"""Runs the whole matrix and writes report.md with its tables, plots and CSV files."""

import argparse
import sys
from pathlib import Path

from . import calibration, distance, document, machine, occlusion, scaling, screen, table2
from .matrix import FULL, QUICK
from .process import CommandFailed, Programs


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="report", description=__doc__)
    parser.add_argument("--root", type=Path, required=True, help="the project's folder")
    parser.add_argument("--build", type=Path, required=True, help="where the programs were built")
    parser.add_argument("--quick", action="store_true", help="a test of the tool, within ten minutes")
    parser.add_argument("--out", type=Path, help="folder for report.md (default: docs; with --quick "
                        "build/report-quick)")
    return parser.parse_args(arguments)


def main(arguments: list[str]) -> int:
    options = parse(arguments)
    matrix = QUICK if options.quick else FULL
    out = options.out or options.root / ("build/report-quick" if options.quick else "docs")
    programs = Programs.of(options.root, options.build)
    try:
        description = machine.describe(programs)
        # The program that is measured below carries the calibration before this one; the next build takes the new one.
        calibration.write(matrix, programs, options.root / "src/jobs" if out == options.root / "docs" else out)
        sections = [measure(matrix, programs) for measure in (distance.measure, occlusion.measure, screen.measure,
                                                              scaling.measure, table2.measure)]
        document.write(out, description, matrix, sections)
    except CommandFailed as error:
        print(f"report: error: {error}", file=sys.stderr)
        return 1
    print(f"{out / 'report.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
