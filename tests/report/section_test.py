"""Tables, CSV files and the document."""

import csv
import tempfile
import unittest
from pathlib import Path

from report.document import text_of
from report.matrix import FULL, QUICK
from report.section import Section, table, write_csv


class SectionTest(unittest.TestCase):
    def test_table_is_markdown(self) -> None:
        # The first column is text and the others are numbers.
        self.assertEqual(table(["a", "b"], [["x", "1"]]), "| a | b |\n| :-- | --: |\n| x | 1 |")

    def test_csv_holds_the_columns_of_every_row(self) -> None:
        # A column that only a later row has is there, and empty where it is missing.
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "rows.csv"
            write_csv(path, [{"a": 1}, {"a": 2, "b": "x,y"}])
            with path.open(newline="", encoding="utf-8") as file:
                self.assertEqual(list(csv.DictReader(file)), [{"a": "1", "b": ""}, {"a": "2", "b": "x,y"}])

    def test_document_names_every_gap(self) -> None:
        # What is missing stands in the report with its reason.
        section = Section("Part", "Introduction.", gaps=[("a peer", "not installed")], data={"part": []})
        text = text_of([("Processor", "one")], FULL, [section], "report")
        self.assertIn("| a peer | not installed |", text)
        self.assertIn("| Processor | one |", text)
        self.assertIn("(report/part.csv)", text)

    def test_quick_report_says_that_it_is_one(self) -> None:
        # A quick run must never be taken for a measurement.
        section = Section("Part", "Introduction.")
        self.assertIn("quick run", text_of([], QUICK, [section], "report"))
        self.assertNotIn("quick run", text_of([], FULL, [section], "report"))


if __name__ == "__main__":
    unittest.main()
