"""Rows of the screen-space estimators as tables."""

import importlib.util
import unittest

if importlib.util.find_spec("matplotlib") is None:
    raise unittest.SkipTest("python3-matplotlib is not installed")

from report.screen import estimators, finding, light, name_of, sweeps  # noqa: E402

ROW = {"occlusion": "gtao", "ao-samples": 12, "milliseconds": 41.26, "integral": "cosine", "rmse": 0.0512,
       "bias": -0.01, "rmse_ambient": 0.2, "bias_ambient": 0.15}
SWEPT = {"occlusion": "ordinates", "ordinates": 512, "refinement": 1, "sweep_milliseconds": 90.0, "milliseconds": 20.0,
         "rmse_ambient": 0.03, "bias_ambient": 0.001}


class ScreenTest(unittest.TestCase):
    def test_names_tell_what_differs(self) -> None:
        # What was asked for beside the estimator's name is in the name, and defaults are not.
        self.assertEqual(name_of(ROW), "gtao")
        self.assertEqual(name_of({**ROW, "surface": "zbuffer", "ao-normalisation": "sampled"}), "gtao")
        self.assertEqual(name_of({"occlusion": "loos10-line", "surface": "implicit", "ao-normalisation": "exact"}),
                         "loos10-line, implicit, exact volume")
        self.assertEqual(name_of({"occlusion": "klehm11", "bent-from": "hbao"}), "klehm11, hbao")
        self.assertEqual(name_of(SWEPT), "512 ordinates")
        self.assertEqual(name_of({**SWEPT, "ordinates": 1024, "refinement": 2}), "1024 ordinates, refined")
        self.assertEqual(name_of({"occlusion": "octants", "octant-terms": "open-plane"}), "octants, open-plane")

    def test_tables_hold_every_number(self) -> None:
        # Time and both errors stand in a row; an even sky has no row of light.
        self.assertIn("| gtao | 12 | 41.3 | cosine | 0.0512 |", estimators([ROW]))
        self.assertIn("| 512 ordinates | 90.0 | 20.0 | 0.0300 |", sweeps([SWEPT]))
        lit = {"occlusion": "klehm11", "bent-from": "sweep", "bent": "cone", "sky": "two colours", "milliseconds": 30.0,
               "over_occlusion": 0.12, "rmse": 0.04, "bias": 0.002}
        text = light([{**lit, "sky": "even"}, lit])
        self.assertEqual(text.count("klehm11"), 1)
        self.assertIn("| klehm11, sweep | cone | 30.0 | 12 % |", text)

    def test_the_best_is_found(self) -> None:
        # The sentence names the least error to ambient occlusion.
        worse = {**ROW, "occlusion": "hbao", "rmse_ambient": 0.3}
        self.assertIn("is gtao: RMSE 0.200 in 41.3 ms", finding("corner", [worse, ROW], [SWEPT]))


if __name__ == "__main__":
    unittest.main()
