#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Which loads are refused, and that a new baseline is refused before anything is built or run."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree may be read-only
import load  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent


class Load(unittest.TestCase):
    def test_is_that_of_the_last_minute_for_each_processor(self):
        with tempfile.TemporaryDirectory() as place:
            file = Path(place) / "loadavg"
            file.write_text("1.50 9.00 9.00 2/300 4711\n")
            self.assertEqual(load.load_per_processor(file) * len(os.sched_getaffinity(0)), 1.5)
            for text in ("", "none\n"):
                file.write_text(text)
                self.assertIsNone(load.load_per_processor(file))
        self.assertIsNone(load.load_per_processor(file))

    def test_is_refused_above_the_most(self):
        self.assertIsNone(load.fault(0.3, read=lambda: 0.3))
        self.assertIn("0.31 for each processor", load.fault(0.3, read=lambda: 0.31))
        self.assertIn("cannot be read", load.fault(0.3, read=lambda: None))

    def test_of_what_ran_before_is_waited_for(self):
        readings, slept = [0.9, 0.6, 0.2], []
        self.assertIsNone(load.fault(0.3, wait=60, read=lambda: readings.pop(0), sleep=slept.append))
        self.assertEqual(len(slept), 2)
        self.assertIn("other processes are running", load.fault(0.3, wait=60, read=lambda: 0.9, sleep=slept.append))
        self.assertEqual(sum(slept[2:]), 60)


class Golden(unittest.TestCase):
    """A copy of the check in a tree whose load is made up and where builds leave a trace."""

    def run_check(self, exit_code, *arguments):
        with tempfile.TemporaryDirectory(prefix="bezierbench-load-") as place:
            scripts = Path(place) / "scripts"
            (scripts / "checks").mkdir(parents=True)
            (scripts / "checks/golden").write_bytes((ROOT / "scripts/checks/golden").read_bytes())
            for name, text in (("load.py", f'echo "load.py $*" >> log; exit {exit_code}'), ("build", "echo build >> log; exit 1")):
                (scripts / name).write_text(f"#!/bin/sh\n{text}\n")
                (scripts / name).chmod(0o755)
            done = subprocess.run(["bash", scripts / "checks/golden", *arguments], capture_output=True, text=True)
            log = Path(place) / "log"
            return done.returncode, log.read_text().splitlines() if log.exists() else []

    def test_refuses_a_new_baseline_on_a_busy_machine_before_it_builds(self):
        self.assertEqual(self.run_check(3, "--update"), (3, ["load.py --most 0.3"]))

    def test_goes_on_where_the_load_is_its_own_or_any_will_do(self):
        self.assertEqual(self.run_check(0, "--update"), (1, ["load.py --most 0.3", "build"]))
        self.assertEqual(self.run_check(3, "--update", "--any-load"), (1, ["build"]))

    def test_asks_nobody_where_nothing_is_timed(self):
        self.assertEqual(self.run_check(3), (1, ["build"]))

    def test_knows_its_options(self):
        for wrong in (("--any-load",), ("--any-load", "--update"), ("--update", "--quiet")):
            self.assertEqual(self.run_check(0, *wrong)[0], 2, wrong)


if __name__ == "__main__":
    unittest.main()
