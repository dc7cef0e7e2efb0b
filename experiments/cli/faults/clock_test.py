#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A clock that stands still, goes back or takes coarse steps: `doctor` says so, and no time is taken by it.
Usage: clock_test.py BEZIERBENCH FALSE_CLOCK.so"""
import os
import sys
import unittest
from pathlib import Path

FALSE_CLOCK = os.path.abspath(sys.argv.pop(2))
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import ENVIRONMENT, FINE, STUDY, TIMING, Case  # noqa: E402

FAULTS = {"stands": "stands still", "back": "goes back", "coarse": "steps by 10000000 ns"}


class FalseClock(Case):
    def run_by(self, fault, *arguments):
        return self.run_program(*arguments, env={**os.environ, "LD_PRELOAD": FALSE_CLOCK, "FALSE_CLOCK": fault,
                                                 "ASAN_OPTIONS": "verify_asan_link_order=0"})

    def test_doctor_calls_it_unfit(self):
        for fault, words in FAULTS.items():
            with self.subTest(fault=fault):
                result = self.run_by(fault, "doctor")
                self.assertEqual(result.returncode, ENVIRONMENT, result)
                self.assertRegex(result.stdout.decode(), f"(?m)^clock +unfit +{words}")

    def test_no_time_is_taken(self):
        """Nor is anything else done first."""
        suite = self.suite({**STUDY, "trials": "20"}, TIMING)
        for fault, words in FAULTS.items():
            with self.subTest(fault=fault):
                result = self.run_by(fault, "run", suite, "--out", fault)
                self.assertEqual(result.returncode, ENVIRONMENT, result)
                self.assert_one_line(result, "clock: ", words, "--no-timing")
                self.assertFalse((self.folder / fault / "timing.csv").exists())
                self.assertEqual(list((self.folder / fault / "blocks").glob("*.blocks")), [])

    def test_what_needs_no_clock_is_done(self):
        suite = self.suite({**STUDY, "trials": "20"}, TIMING)
        for fault in FAULTS:
            with self.subTest(fault=fault):
                result = self.run_by(fault, "run", suite, "--out", fault, "--no-timing", "--quiet")
                self.assertEqual(result.returncode, FINE, result)
                self.fine("verify", fault)

    def test_a_right_clock_is_no_fault(self):
        """What is preloaded does no harm by itself."""
        self.assertNotRegex(self.run_by("", "doctor").stdout.decode(), "(?m)^clock +unfit")


if __name__ == "__main__":
    unittest.main()
