"""Rows and sentences of the occlusion report, and the EXR files of the peer that is Python."""

import importlib.util
import struct
import tempfile
import unittest
from pathlib import Path

for needed in ("matplotlib", "numpy"):
    if importlib.util.find_spec(needed) is None:
        raise unittest.SkipTest(f"python3-{needed} is not installed")

import numpy as np  # noqa: E402

from report import equal_error, occlusion  # noqa: E402
from report.exr import write_exr  # noqa: E402
from report.volumes import Scene  # noqa: E402

SCENE = Scene("a scene", Path("a.vdb"), ())


def row(method: str, knob: float, seconds: float, rmse: float, threads: int = 2) -> dict:
    return occlusion.row_of(SCENE, threads, method, knob, [seconds], [seconds], {"rmse": rmse})


class OcclusionTest(unittest.TestCase):
    def test_error_row_takes_the_first_measure(self) -> None:
        # The limits' own measure is the one reported, with the share of misses beside it.
        measure = {"rmse": 0.1, "bias": -0.05, "mean": 0.06, "p95": 0.2, "max": 0.5, "rmse_without_noise": 0.09,
                   "reference_noise": 0.01}
        found = occlusion.error_row({"measures": [measure, {}], "ssim": 0.9, "miss": 0.001})
        self.assertEqual(found, {**measure, "ssim": 0.9, "miss": 0.001})

    def test_findings_compare_with_the_same_threads(self) -> None:
        # Ratios are taken at the largest number of threads, and the published error is named.
        rows = [row(occlusion.OCTANTS, 0, 1, 0.3), row(occlusion.ORDINATES, 64, 1, 0.07),
                row(occlusion.ORDINATES, 64, 9, 0.07, 1), row(occlusion.ORDINATES, 8, 1, 0.2),
                row(occlusion.EMBREE, 4, 2, 0.1), row(occlusion.EMBREE, 16, 8, 0.05)]
        text = occlusion.findings(SCENE, rows)[0]
        self.assertIn("RMSE is 0.0700 with 64 ordinates (0.300 as published)", text)
        self.assertIn("at 2.0 to 8.0 times the time", text)

    def test_equal_error_takes_the_fewest_rays_that_are_no_worse(self) -> None:
        # The first setting of the peer whose error is no larger counts, however its rows are ordered; where none is as
        # good, the last, marked: equal error takes longer.
        ours = [row(occlusion.ORDINATES, 64, 2, 0.06), row(occlusion.ORDINATES, 512, 4, 0.02)]
        peer = [row(occlusion.EMBREE, 256, 80, 0.03), row(occlusion.EMBREE, 4, 1, 0.2),
                row(occlusion.EMBREE, 64, 20, 0.06), row(occlusion.EMBREE, 128, 40, 0.04)]
        found = equal_error.compare(ours, peer)
        self.assertEqual([(each["peer_knob"], each["reached"], each["first"], each["further"]) for each in found],
                         [(64, True, 10, 10), (256, False, 20, 20)])
        text = equal_error.table_of(found, "rays")
        self.assertIn("| 64 ordinates | 0.0600 | 64 | 0.0600 | 10 | 10 |", text)
        self.assertIn("| 512 ordinates | 0.0200 | > 256 | 0.0300 | > 20 | > 20 |", text)
        self.assertIn("it takes more than 256 rays (0.0300): more than 20 times as long",
                      equal_error.finding("a scene", found, "rays"))

    def test_equal_error_leaves_out_the_noise_of_the_truth(self) -> None:
        # Errors are compared without the reference's noise where that is known.
        self.assertEqual(equal_error.error({"rmse": 0.05, "rmse_without_noise": 0.04}), 0.04)
        self.assertEqual(equal_error.error({"rmse": 0.05}), 0.05)

    def test_options_are_those_of_the_setting(self) -> None:
        # What report_frames tells of a setting becomes its command line, and nothing else.
        entry = {"occlusion": "ordinates", "ordinates": 64, "refinement": 2, "seconds": [1]}
        self.assertEqual(occlusion.occlusion_options(entry),
                         ["--occlusion", "ordinates", "--ordinates", "64", "--refinement", "2"])

    def test_exr_holds_the_values_row_by_row(self) -> None:
        # Every scan line holds its number, its size, and its channels in the order of their names.
        ambient = np.arange(6, dtype="f4").reshape(2, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.exr"
            write_exr(path, {"ambient.Y": ambient, "Z": -ambient})
            data = path.read_bytes()
        self.assertEqual(struct.unpack("<i", data[:4])[0], 20000630)
        line = struct.pack("<ii", 1, 24) + (-ambient[1]).tobytes() + ambient[1].tobytes()  # "Z" before "a"
        self.assertTrue(data.endswith(line))
        start = struct.unpack("<Q", data[-2 * len(line) - 8:-2 * len(line)])[0]
        self.assertEqual(start, len(data) - len(line))


if __name__ == "__main__":
    unittest.main()
