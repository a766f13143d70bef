"""Medians, spreads and numbers as text."""

import unittest

from report.stats import Timing, digits, range_text, seconds_text, sums


class StatsTest(unittest.TestCase):
    def test_timing_is_the_median_with_its_spread(self) -> None:
        # One slow run moves the spread and not the median.
        self.assertEqual(Timing.of([1.0, 9.0, 2.0]), Timing(2.0, 1.0, 9.0))

    def test_sums_go_run_by_run(self) -> None:
        # Stages of the same run are added, never those of different runs.
        self.assertEqual(sums([1.0, 2.0], [10.0, 20.0]), [11.0, 22.0])
        with self.assertRaises(ValueError):
            sums([1.0], [1.0, 2.0])

    def test_digits_keep_three_and_no_exponent(self) -> None:
        # Three significant digits, whatever the size.
        for value, text in ((0.012345, "0.0123"), (1234.6, "1230"), (9.999, "10.0"), (0, "0"), (-0.5, "-0.500"),
                            (1e-5, "0.0000100")):
            self.assertEqual(digits(value), text)

    def test_digits_of_nothing_are_a_dash(self) -> None:
        # What was not measured is a dash and not a number.
        self.assertEqual([digits(None), digits(float("nan")), digits(float("inf"))], ["–", "–", "∞"])

    def test_seconds_name_the_spread_where_there_is_one(self) -> None:
        # A single run has no spread to tell.
        self.assertEqual(seconds_text(Timing(2, 1, 3)), "2.00 (1.00 to 3.00)")
        self.assertEqual(seconds_text(Timing(2, 2, 2)), "2.00")

    def test_ranges_collapse_where_both_ends_read_the_same(self) -> None:
        # Two ends that print alike are one number.
        self.assertEqual(range_text([3.0, 1.0], " times"), "1.0 to 3.0 times")
        self.assertEqual(range_text([1.001, 1.002]), "1.0")


if __name__ == "__main__":
    unittest.main()
