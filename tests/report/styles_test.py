"""How series are told apart in the figures."""

import unittest

from report.styles import OTHERS, OURS, VERMILION, style_of


class StylesTest(unittest.TestCase):
    def test_no_two_series_look_alike(self) -> None:
        # As many as there are styles, in any order: every one has its own, Isolume's in one colour.
        ours, others = [f"Isolume {i}" for i in range(len(OURS))], [f"peer {i}" for i in range(len(OTHERS))]
        names = [name for pair in zip(ours, others) for name in pair] + ours[len(others):]
        styles = style_of(names)
        self.assertEqual(set(styles), set(names))
        self.assertEqual(len(set(styles.values())), len(names))
        for name, (color, _) in styles.items():
            self.assertEqual(color == VERMILION, name.startswith("Isolume"))

    def test_too_many_series_are_an_error(self) -> None:
        # A style is never given twice in silence.
        with self.assertRaisesRegex(ValueError, "found 9 and 0"):
            style_of([f"Isolume {i}" for i in range(len(OURS) + 1)])


if __name__ == "__main__":
    unittest.main()
