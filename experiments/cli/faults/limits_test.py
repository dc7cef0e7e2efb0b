#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The program where memory, stack and the length of words end: one line, never a crash. Usage: limits_test.py BEZIERBENCH"""
import pathlib
import resource
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program_case import FINE, HAS_SANITIZER, INPUT_OUTPUT, PROGRAM, STUDY, USAGE, Case  # noqa: E402

ENVIRONMENT = 3
MEGABYTE = 1 << 20
LONGEST_LINE = 500  # characters of a message about what is in these tests


def limited(which, size):
    return {"preexec_fn": lambda: resource.setrlimit(which, (size, size))}


class Limits(Case):
    def assert_short_line(self, result, *needles):
        self.assert_one_line(result, *needles)
        self.assertLess(len(result.stderr), LONGEST_LINE)

    @unittest.skipIf(HAS_SANITIZER, "a sanitizer takes more memory than the limit")
    def test_memory(self):
        """Whatever the limit, the run does its work or says that memory is exhausted; so does one that starts threads."""
        run = ["run", self.suite({**STUDY, "degree": "[3, 40]", "methods": None, "trials": "300"}), "--quiet"]
        exhausted = 0
        for megabytes in (30, 40, 50, 60, 80, 120):
            for jobs in ("1", "4"):
                with self.subTest(megabytes=megabytes, jobs=jobs):
                    result = self.run_program(*run, "--jobs", jobs, "--out", f"b{megabytes}-{jobs}",
                                              **limited(resource.RLIMIT_AS, megabytes * MEGABYTE))
                    if b"shared librar" in result.stderr:  # the loader's word: the program did not begin
                        continue
                    if result.returncode == FINE:
                        continue
                    self.assertEqual(result.returncode, ENVIRONMENT, result)
                    self.assert_short_line(result, "ulimit")
                    exhausted += 1
        self.assertGreater(exhausted, 0)

    @unittest.skipIf(HAS_SANITIZER, "a sanitizer takes more memory than the limit")
    def test_memory_that_no_run_fits(self):
        """Is refused before a library waits for it forever."""
        for megabytes in (40, 63):
            result = self.run_program("list", "suites", **limited(resource.RLIMIT_AS, megabytes * MEGABYTE))
            if b"shared librar" not in result.stderr:
                self.assertEqual(result.returncode, ENVIRONMENT, result)
                self.assert_short_line(result, "memory", f"{megabytes << 10} KiB", "ulimit -v")

    def test_stack(self):
        """Too small a one is refused before anything overflows it; a soft limit is raised."""
        self.refused(ENVIRONMENT, ["list", "suites"], "stack", "256 KiB", "ulimit -s",
                     **limited(resource.RLIMIT_STACK, 256 << 10))
        hard = resource.getrlimit(resource.RLIMIT_STACK)[1]
        suite = self.suite({**STUDY, "degree": "[1000]", "methods": None, "trials": "1"})
        for soft in (256 << 10, 1 << 20, 4 << 20):
            with self.subTest(soft=soft):
                self.bundle(suite, name=f"b{soft}", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, (soft, hard)))

    def test_fields_of_megabytes(self):
        """Of what is in a file a message shows enough to find it."""
        long = "7x" * 2_500_000
        self.write("c.csv", f"x\n{long}\n")
        self.assert_short_line(self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", "c.csv", "--t", "0"]),
                               "c.csv:2: ", "7x7x7x")
        self.write("c.csv", f"{long}\n1\n")
        self.assert_short_line(self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", "c.csv", "--t", "0"]), "c.csv:1: ")
        for changes in ({"methods": f'["{long}"]'}, {"generator": f'["{long}"]'}, {"baseline": f'["{long}"]'},
                        {long: "1"}, {"id": f'"{long}"'}, {"kind": f'"{long}"'}, {"scalar": f'["{long}"]'}):
            with self.subTest(key=next(iter(changes))[:10]):
                self.assert_short_line(self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"]), "s.toml:")

    def test_ids_name_files(self):
        self.bundle(self.suite(id='"' + "n" * 100 + '"'))
        self.refused(USAGE, ["run", self.suite(id='"' + "n" * 101 + '"'), "--out", "b"], "s.toml:7:", "101 characters")
        self.suite()
        self.write("s.toml", (self.folder / "s.toml").read_text().replace('id = "tiny"', f'id = "{"n" * 300}"'))
        self.refused(USAGE, ["run", "s.toml", "--out", "b"], "s.toml:3:", "300 characters")

    def test_axes_of_many_values(self):
        """Values that are all compared with each other would take minutes."""
        values = ", ".join(f"{1 + k}.5" for k in range(100_000))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.refused(USAGE, ["run", self.suite(coordinate_range=f"[{values}, 100000.5]"), "--out", "b"], "s.toml:11:", "twice")
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 5)
        self.refused(USAGE, ["run", self.suite(degree="[" + "3, " * 100_000 + "4]"), "--out", "b"], "s.toml:10:", "twice")

    def test_numbers_that_no_double_holds(self):
        """1e-999 is no number: 0 would be another one."""
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
                ([*run, "--checkpoint", "inf"], USAGE, "--checkpoint inf"),
                ([*run, "--checkpoint", "-1"], USAGE, "--checkpoint -1"),
                (["run", self.suite(coordinate_range="[1e-999]", name="small.toml"), "--out", "b"], USAGE, "small.toml:11:"),
                (["run", self.suite(coordinate_range='["1e-999"]', name="text.toml"), "--out", "b"], USAGE, "text.toml:11:")]:
            with self.subTest(arguments=arguments):
                self.assert_short_line(self.refused(code, arguments, needle))

    def test_words_that_say_nothing(self):
        run = ["run", self.suite(), "--out", "b"]
        for arguments, needle in [
                (["--only", ""], "--only: is empty"), (["--shard", "1/4294967298"], "--shard 1/4294967298"),
                (["--shard", "4294967297/4294967298"], "<= N <= 1000000"),
                (["--shard", "1/99999999999999999999999"], "<= N <= 1000000")]:
            with self.subTest(arguments=arguments):
                self.assert_short_line(self.refused(USAGE, run + arguments, needle))


if __name__ == "__main__":
    unittest.main()
