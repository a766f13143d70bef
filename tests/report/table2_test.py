"""The paper's Table 2 from what google-benchmark prints."""

import unittest
from dataclasses import replace

from report import table2
from report.matrix import FULL, PAPER_SIZES

SIZE = PAPER_SIZES[0]


def entry(kernel: str, threads: int, time: float, unit: str = "ms") -> dict:
    name = f"{kernel}/{'/'.join(map(str, SIZE))}/{threads}/real_time"
    return {"run_name": name, "run_type": "iteration", "real_time": time, "time_unit": unit}


class Table2Test(unittest.TestCase):
    def test_times_are_seconds_by_kernel_size_and_threads(self) -> None:
        # Repetitions of the same benchmark are gathered, and units are converted.
        times = table2.times_of([entry("distanceAlone", 1, 4), entry("distanceAlone", 1, 2),
                                 entry("distanceAlone", 1, 3), entry("eightOctants", 0, 5e6, "ns")])
        self.assertAlmostEqual(times["distanceAlone", SIZE, 1].median, 0.003)
        self.assertAlmostEqual(times["eightOctants", SIZE, 0].median, 0.005)

    def test_rows_hold_the_least_time(self) -> None:
        # What else the machine did in some repetitions is no part of a kernel's time.
        matrix = replace(FULL, table_sizes=(SIZE,))
        entries = [entry(kernel, threads, milliseconds) for milliseconds in (7, 4, 9)
                   for kernel in ("distanceAlone", "oneNumber", "eightOctants") for threads in (1, 0)]
        (row,) = table2.rows_of(matrix, table2.times_of(entries))
        for label in ("one", "all"):
            for kernel in ("without", "combined", "octants"):
                self.assertAlmostEqual(row[f"{kernel}_{label}"], 0.004)

    def test_every_size_of_the_full_report_is_published(self) -> None:
        # The report's rows are those of the paper, all of them.
        self.assertEqual(set(FULL.table_sizes), set(table2.PUBLISHED))

    def test_published_overhead_is_as_the_paper_says(self) -> None:
        # The typed numbers agree with the paper's text: occlusion adds from 30 % to 100 %, with its outlier of 145 %.
        overheads = [octants / alone - 1 for alone, _, octants in table2.PUBLISHED.values()]
        self.assertTrue(all(0.3 < overhead < 1.46 for overhead in overheads))
        self.assertEqual(sum(overhead > 1.02 for overhead in overheads), 1)

    def test_findings_are_ratios_of_the_rows(self) -> None:
        # The sentence speaks of the rows' own ratios.
        row = {"without_one": 1.0, "combined_one": 1.25, "octants_one": 1.5, "published_without": 2.0, "published_octants": 3.0}
        self.assertIn("add 50 %", table2.findings([row])[0])
        self.assertIn("(combined here 25 %)", table2.findings([row])[0])
        self.assertIn("2.0 times as fast", table2.findings([row])[0])


if __name__ == "__main__":
    unittest.main()
