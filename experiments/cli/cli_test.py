#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The command line from outside: help, lists, one-line messages. Usage: cli_test.py BEZIERBENCH"""
import re
import shutil
import subprocess
import unittest

from program_case import (BERNSTEIN, CODE, ENVIRONMENT, FINDING, INPUT_OUTPUT, INTERRUPTED, METHOD_COLUMNS, POWER, PROGRAM, ROOT, TO_BERNSTEIN,
                          TO_POWER, USAGE, Case, rows)


class CommandLine(Case):
    def test_parser_says_one_line(self):
        suite = self.suite()
        for arguments, needle in [
                (["rnu"], "rnu: unknown command; did you mean \"run\"?"), (["list"], "subcommand"), (["complte"], "did you mean \"compare\"?"),
                (["list", "complte"], "unknown command; known are"), (["curve", "evl"], "did you mean \"eval\"?"),
                (["--nonsense"], "--help"), (["chose", "results/answers", "--degree", "3"], "chose: unknown command; did you mean \"choose\"?"),
                (["curve", "evl", "--curve=c", "--t", "0.5"], "evl: unknown command; did you mean \"eval\"?"), (["rnu", "--help"], "rnu: unknown command"), (["run", "--oot", "b", "--help"], "--oot"),
                (["run"], "SUITE is required; see `bezierbench run --help`"), (["run", suite], "--out"), (["run", suite, "--out"], "--out"),
                (["run", suite, "--oot=b"], "--oot: unknown option; did you mean \"--out\"?"),
                (["run", suite, "--out", ""], "--out"), (["run", suite, "--out", "b", "--out", "c"], "--out"),
                (["curve", "--path", "M0,0 1,1", "eval"], "--path: stands before its command; write it after `bezierbench curve eval`; see"),
                (["list", "--format", "csv", "methods"], "write it after `bezierbench list methods`"),
                (["--quiet", "run", "report"], "write it after `bezierbench run`"),
                (["verify", "b", "c"], "c: is one argument too many"), (["curve", "eval", "--curve", "c"], "--t"),
                (["list", "methods", "--format", "cvs"], "did you mean \"csv\"?")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, arguments, needle)

    def test_values_of_options(self):
        run = ["run", self.suite(), "--out", "b"]
        """One of each option; tests of what `--set` takes are beside the code that reads it."""
        for arguments, needle in [
                (["--jobs", "0"], "--jobs: 0 must be from 1 to 4096"), (["--jobs", "x"], "--jobs: x must be a whole number"),
                (["--seed", "-1"], "--seed -1"), (["--seed", "99999999999999999999"], "--seed 99999999999999999999"),
                (["--trials", "0"], "--trials 0"), (["--reference", "guess"], "guess"), (["--only", "z*"], "--only z*"),
                (["--set", "degre=3"], "did you mean \"degree\"?"), (["--checkpoint", "1e-999"], "--checkpoint 1e-999"),
                (["--checkpoint", "nan"], "--checkpoint nan")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, run + arguments, needle)

    def test_doctor(self):
        """Warnings do not fail: few machines are free of them."""
        lines = [line.split(maxsplit=1) for line in self.fine("doctor").replace("floating point", "arithmetic").splitlines()]
        self.assertEqual([aspect for aspect, _ in lines],
                         ["arithmetic", "clock", "governor", "boost", "load", "virtualised", "counters"])
        for aspect, text in lines:
            self.assertIn(text.split()[0], ("fine", "warning"), aspect)

    @unittest.skipUnless(shutil.which("qemu-x86_64") and b"-DBEZIERBENCH_X86_64_V3=OFF" in CODE,
                         "qemu-user is not installed, or the program runs on any processor")
    def test_lesser_processor(self):
        result = subprocess.run(["qemu-x86_64", "-cpu", "Nehalem", PROGRAM, "doctor"], capture_output=True, check=False)
        self.assertEqual((result.returncode, result.stdout), (ENVIRONMENT, b""))
        self.assertIn(b"this processor has no AVX2 or FMA", result.stderr)

    def test_help_and_version(self):
        self.assertIn("run", self.fine("--help"))
        self.assertIn("--out", self.fine("run", "--help"))
        self.assertRegex(self.fine("choose", "--help"), r"--mode one_shot\|point\|latency\|batch\n +[^\n]*default point\n")
        self.assertTrue(self.fine("--version").startswith("bezierbench "))

    def test_exit_codes_are_those_of_the_documentation(self):
        printed = dict(re.findall(r"(?m)^  (\d+) +(.*)$", self.fine("--help")))
        documented = dict(re.findall(r"(?m)^\| (\d+) \| (.*) \|$", (ROOT / "docs/terminal.md").read_text(encoding="utf-8")))
        self.assertEqual(printed, documented)
        self.assertEqual(list(map(int, printed)), [0, FINDING, USAGE, ENVIRONMENT, INPUT_OUTPUT, INTERRUPTED])


class Lists(Case):
    def test_methods(self):
        found = {(row["id"], row["problem"], row["form"]): row for row in self.our_methods()}
        self.assertEqual(list(next(iter(found.values()))), METHOD_COLUMNS)
        expected = ([(method, "evaluation", "bernstein") for method in BERNSTEIN]
                    + [(method, "evaluation", "power") for method in POWER]
                    + [(f"{step}:{method}", "evaluation", "bernstein") for step in TO_POWER for method in POWER]
                    + [(f"{step}:{method}", "evaluation", "power") for step in TO_BERNSTEIN for method in BERNSTEIN]
                    + [(step, "conversion", "bernstein") for step in TO_POWER]
                    + [(step, "conversion", "power") for step in TO_BERNSTEIN])
        self.assertEqual([key for key in expected if key not in found], [])
        for row in found.values():
            if row["problem"] in ("evaluation", "conversion"):
                self.assertEqual(row["min_degree"], "0")
                self.assertGreaterEqual(int(row["max_degree"]), 170)
            self.assertIn(row["bit_stable"], ("yes", "no"))
            self.assertTrue(row["citation"] and row["flops"], row)

    def test_methods_are_filtered(self):
        every = rows(self.fine("list", "methods", "--format", "csv"))
        def keeps(row, guarantee):
            return guarantee in [word.split(":")[0] for word in row["guarantees"].split()]
        for options, passes in [
                (["--problem", "subdivision"], lambda row: row["problem"] == "subdivision"),
                (["--form", "rational"], lambda row: row["form"] == "rational"),
                (["--guarantee", "in_hull"], lambda row: keeps(row, "in_hull")),
                (["compensated_*"], lambda row: row["id"].startswith("compensated_")),
                (["*horner*", "--form", "bernstein", "--guarantee", "finite"],
                 lambda row: "horner" in row["id"] and row["form"] == "bernstein" and keeps(row, "finite"))]:
            with self.subTest(options=options):
                wanted = [row for row in every if passes(row)]
                self.assertTrue(0 < len(wanted) < len(every))
                self.assertEqual(rows(self.fine("list", "methods", *options, "--format", "csv")), wanted)
                words = self.fine("list", "methods", *options).split()
                self.assertEqual([row["id"] for row in wanted if row["id"] not in words], [])
        for filters in (["no_such_*"], ["horner", "--problem", "subdivision"]):
            self.refused(USAGE, ["list", "methods", *filters], "no method passes all of these filters")
        self.refused(USAGE, ["list", "methods", "de_casteljo"], 'de_casteljo: no such method; did you mean "de_casteljau"?')
        self.refused(USAGE, ["list", "methods", "--guarantee", "in_hul"], "did you mean \"in_hull\"?")
        self.assertIn("in_hull:1", self.fine("list", "methods", "--guarantee", "in_hull"))  # kept up to degree 1 only

    def test_others(self):
        shipped = rows(self.fine("list", "suites", "--format", "csv"))
        suites = {row["id"] for row in shipped}
        self.assertIn("report", suites)
        for row in shipped:
            self.assertRegex(row["question"], r"^(Which|How|Is) .*\?$", row["id"])
            self.assertIn(row["question"].split()[-1], self.fine("list", "suites"))
            if not row["id"].endswith("peers"):  # whose time is that of other libraries
                self.assertGreater(int(row["seconds"]), 0, row["id"])
        studies = rows(self.fine("list", "studies", "--format", "csv"))
        self.assertLessEqual({row["suite"] for row in studies}, suites)
        self.assertLessEqual({"2.2", "2.3.1-bezier", "2.4-polynomial"}, {row["id"] for row in studies})
        generators = {row["id"]: row for row in rows(self.fine("list", "generators", "--format", "csv"))}
        self.assertLessEqual({"continuous", "dyadic", "integer", "report"}, set(generators))
        self.assertLessEqual({"weights_mild", "weights_wild"}, {k for k, row in generators.items() if row["weights"]})
        for row in rows(self.fine("list", "worked", "--format", "csv")):  # the printed column is right
            self.assertEqual((row["printed_correct"], row["correct"]), ("yes", "yes"))
            for count in (row["to_power"], row["to_bernstein"]):
                self.assertRegex(count, r"^(\d+) of \1$")
        for topic in ("methods", "suites", "studies", "generators", "worked"):
            self.assertNotEqual(self.fine("list", topic), self.fine("list", topic, "--format", "csv"))


if __name__ == "__main__":
    unittest.main()
