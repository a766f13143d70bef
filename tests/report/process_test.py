"""Commands: their output, their errors, and the cores that they run on."""

import os
import unittest

from report.process import CommandFailed, json_of, output_of, pinned


class ProcessTest(unittest.TestCase):
    def test_a_failing_command_gives_its_last_line(self) -> None:
        # The report stops with the line in which the command says what is wrong.
        with self.assertRaisesRegex(CommandFailed, "^sh: no volume$"):
            output_of(["sh", "-c", "echo warning >&2; echo no volume >&2; exit 3"])

    def test_a_missing_command_is_named(self) -> None:
        # A program that is not there is an error of one line.
        with self.assertRaisesRegex(CommandFailed, "no-such-program"):
            output_of(["no-such-program"])

    def test_output_that_is_no_json_is_refused(self) -> None:
        # What cannot be read is never taken for a measurement.
        with self.assertRaisesRegex(CommandFailed, "expected JSON"):
            json_of(["echo", "seconds: 3"])

    def test_pinned_commands_see_as_many_cores_as_threads(self) -> None:
        # One thread runs on one core, the first that this process may use.
        first = min(os.sched_getaffinity(0))
        self.assertEqual(pinned(["true"], 1), ["taskset", "--cpu-list", str(first), "true"])
        self.assertEqual(output_of(["nproc"], 1).strip(), "1")


if __name__ == "__main__":
    unittest.main()
