#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The program where the range of numbers ends: one line, never a crash. Usage: limits_test.py BEZIERBENCH"""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program_case import INPUT_OUTPUT, USAGE, Case  # noqa: E402

LONGEST_LINE = 500  # characters of a message about what is in these tests


class Limits(Case):
    def assert_short_line(self, result, *needles):
        self.assert_one_line(result, *needles)
        self.assertLess(len(result.stderr), LONGEST_LINE)

    def test_ids_name_files(self):
        self.bundle(self.suite(id='"' + "n" * 100 + '"'))
        self.refused(USAGE, ["run", self.suite(id='"' + "n" * 101 + '"'), "--out", "b"], "s.toml:7:", "101 characters")
        self.suite()
        self.write("s.toml", (self.folder / "s.toml").read_text().replace('id = "tiny"', f'id = "{"n" * 300}"'))
        self.refused(USAGE, ["run", "s.toml", "--out", "b"], "s.toml:3:", "300 characters")

    def test_numbers_that_no_double_holds(self):
        """1e-999 is not a double: 0 would be another number."""
        self.write("c.csv", "x,y\n0,0\n1,2\n")
        self.write("small.csv", "x,y\n0,0\n1,1e-999\n")
        run = ["run", self.suite(), "--out", "b"]
        for arguments, code, needle in [
                (["curve", "eval", "--curve", "c.csv", "--t", "1e-999"], USAGE, "--t 1e-999"),
                (["curve", "eval", "--curve", "small.csv", "--t", "0"], INPUT_OUTPUT, "small.csv:3: row 2, column y"),
                (["curve", "length", "--curve", "c.csv", "--tolerance", "1e-999"], USAGE, "--tolerance 1e-999"),
                ([*run, "--set", "coordinate_range=1e-999"], USAGE, "coordinate_range=1e-999"),
                ([*run, "--checkpoint", "1e-999"], USAGE, "--checkpoint 1e-999"),
                ([*run, "--checkpoint", "nan"], USAGE, "--checkpoint nan"),
                (["run", self.suite(coordinate_range='["1e-999"]', name="text.toml"), "--out", "b"], USAGE, "text.toml:11:")]:
            with self.subTest(arguments=arguments):
                self.assert_short_line(self.refused(code, arguments, needle))

    def test_words_that_say_nothing(self):
        run = ["run", self.suite(), "--out", "b"]
        for arguments, needle in [
                (["--only", ""], "--only: is empty"), (["--shard", "1/4294967298"], "--shard 1/4294967298")]:
            with self.subTest(arguments=arguments):
                self.assert_short_line(self.refused(USAGE, run + arguments, needle))


if __name__ == "__main__":
    unittest.main()
