"""The calibration file: what report_calibration says, rounded, one line per setting."""

import json
import unittest
from pathlib import Path

from report import calibration

SETTING = {"occlusion": "ordinates", "ordinates": 64, "refinement": 1, "seconds": 0.123456,
           "scenes": [{"scene": "corner", "rmse": 0.0123456, "bias": -1e-5}]}


class CalibrationTest(unittest.TestCase):
    def test_text_is_the_report_at_four_digits(self) -> None:
        # Whole numbers and names stay as they are; every setting stands on a line of its own.
        text = calibration.text_of({"size": 128, "settings": [SETTING, SETTING]})
        want = {**SETTING, "seconds": 0.1235, "scenes": [{"scene": "corner", "rmse": 0.01235, "bias": -1e-5}]}
        self.assertEqual(json.loads(text), {"size": 128, "settings": [want, want]})
        self.assertEqual([json.loads(line.rstrip(",")) for line in text.splitlines()[1:-1]], [want, want])

    def test_the_program_s_file_is_of_this_form(self) -> None:
        # The file in the tree is what text_of() makes of its own content: nobody has touched it by hand.
        path = Path(__file__).parents[2] / "src/jobs" / calibration.NAME
        text = path.read_text()
        self.assertEqual(calibration.text_of(json.loads(text)), text)


if __name__ == "__main__":
    unittest.main()
