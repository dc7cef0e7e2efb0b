#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs that were stopped go on, and end with the bytes of a run that was not. Usage: resume_test.py BEZIERBENCH"""
import re
import shutil
import signal
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import (ACCURACY, CONVERSION, FINDING, FINE, INPUT_OUTPUT,  # noqa: E402
                          SEARCH, TIMING, USAGE, ResumeCase)


class Resume(ResumeCase):
    def test_interrupted(self):
        suite = self.suite(ACCURACY, SEARCH)
        self.bundle(suite, name="whole")
        for which in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=which):
                name = f"b{which}"
                self.start_and_stop(name, suite, which=which)
                self.bundle(suite, name=name)
                self.assertEqual(self.results(name), self.results("whole"))

    def test_blocks_that_are_done_are_not_done_again(self):
        suite = self.suite({**ACCURACY, "trials": "20000"})
        self.start_and_stop("b", suite)
        text = self.fine("run", suite, "--out", "b", "--dry-run")
        blocks, done = map(int, re.search(r"blocks +(\d+), (\d+) of them done", text).groups())
        self.assertEqual(blocks, 4 * 2 * 20)
        self.assertGreater(done, 0)
        self.assertLess(done, blocks)
        self.bundle(suite, name="b")
        text = self.fine("run", suite, "--out", "b", "--dry-run")
        self.assertIn(f"blocks       {blocks}, {blocks} of them done", text)
        self.assertIn("already complete", text)

    def test_damage_is_computed_again(self):
        suite = self.suite(ACCURACY, CONVERSION)
        self.bundle(suite, name="whole")
        self.start_and_stop("start", suite)
        good = self.block_files("start")[0].read_bytes()
        damages = [good[:size] for size in (0, len(good) // 2, len(good) - 1)]
        damages += [good[:place] + bytes([good[place] ^ 0x55]) + good[place + 1:] for place in (10, len(good) // 2, len(good) - 1)]
        damages.append(good + b"\0")
        for number, damaged in enumerate(damages):
            with self.subTest(number=number):
                shutil.copytree(self.folder / "start", self.folder / "b")
                path = self.folder / "b/blocks" / self.block_files("start")[0].name
                path.write_bytes(damaged)
                result = self.run_program("run", suite, "--quiet", "--out", "b")
                self.assertEqual(result.returncode, FINE, result)
                self.assertIn(f"{path.name}: damaged; what it held is computed again", result.stderr.decode())
                self.assert_complete("b")
                self.assertEqual(self.results("b"), self.results("whole"))
                shutil.rmtree(self.folder / "b")

    def test_damage_of_what_a_run_goes_by(self):
        """The machine is described again, and nothing else is."""
        suite = self.suite(ACCURACY)
        self.bundle(suite, name="whole")
        self.start_and_stop("start", suite, which=signal.SIGINT)
        for name in ("suite.toml", "methods.csv", "generators.csv", "machine.json"):
            for damage in (lambda path: path.write_bytes(path.read_bytes()[:-1]), lambda path: path.unlink()):
                shutil.copytree(self.folder / "start", self.folder / "b")
                damage(self.folder / "b" / name)
                if name != "machine.json":
                    self.refused(INPUT_OUTPUT, ["run", suite, "--quiet", "--out", "b"], f"b/{name}: is ", "restore", unchanged=False)
                else:
                    self.assertEqual(self.run_program("run", suite, "--quiet", "--out", "b").returncode, FINE)
                    self.assert_complete("b")
                    self.assertEqual(self.results("b"), self.results("whole"))
                shutil.rmtree(self.folder / "b")

    def test_damage_of_what_is_complete(self):
        """What a killed run left is removed, and no checksum is written again."""
        suite = self.suite()
        for name in ("accuracy.csv", "SHA256SUMS"):
            bundle = self.bundle(suite, name=f"of_{name}")
            self.write(f"{bundle}/blocks/whole.000001.blocks", "x")
            path = self.folder / bundle / name
            path.write_bytes(path.read_bytes()[:-1])
            for _ in ("with blocks/", "without"):
                result = self.run_program("run", suite, "--quiet", "--out", bundle)
                self.assertEqual(result.returncode, FINDING, result)
                self.assertIn(b"restore it, or remove it and run the command again", result.stderr)
                self.assertFalse((self.folder / bundle / "blocks").exists())
            self.assertEqual(self.run_program("verify", bundle).returncode, FINDING)

    def test_blocks_of_another_run_are_refused(self):
        suite = self.suite(ACCURACY)
        self.start_and_stop("theirs", suite, "--seed", "2", which=signal.SIGINT)
        self.start_and_stop("b", suite, which=signal.SIGINT)
        shutil.copy(self.block_files("theirs")[0], self.folder / "b/blocks/whole.000099.blocks")
        self.refused(USAGE, ["run", suite, "--out", "b", "--quiet"], "b/blocks/whole.000099.blocks", "seed 2", "has 1")
        self.refused(USAGE, ["run", suite, "--out", "b", "--dry-run"], "seed 2")

    def test_another_reference_is_refused(self):
        suite = self.suite(ACCURACY)
        self.start_and_stop("b", suite, which=signal.SIGINT)
        self.refused(USAGE, ["run", suite, "--out", "b", "--quiet", "--reference", "exact"], "certified", "exact")

    def test_another_program_is_refused(self):
        suite = self.suite(ACCURACY)
        self.start_and_stop("b", suite, which=signal.SIGINT)
        self.change("b", "methods.csv", "id\n")
        self.refused(USAGE, ["run", suite, "--out", "b", "--quiet"], "b/methods.csv", "other methods")

    def test_leftovers_of_a_killed_end(self):
        """Killed between the last write and the removal of blocks/."""
        suite = self.suite()
        self.bundle(suite)
        self.write("b/blocks/whole.000001.blocks", "x")
        self.assertEqual(self.run_program("run", suite, "--out", "b").stderr, b"b: already complete, nothing to do\n")
        self.assert_complete("b")

    def test_one_run_at_a_time(self):
        suite = self.suite({**ACCURACY, "trials": "2000000000"})
        with self.at_work("b", "run", suite, "--quiet", "--out", "b"):
            for arguments in ([], ["--shard", "1/2"]):
                self.refused(INPUT_OUTPUT, ["run", suite, "--quiet", "--out", "b", *arguments], "b: ", "run is at work",
                             alone=False)


class Timings(ResumeCase):
    TWO = {**TIMING, "degree": "[2, 3, 4, 5]", "modes": '["point"]', "methods": '["direct", "de_casteljau"]'}

    def test_kept_on_this_machine(self):
        suite = self.suite(self.TWO)
        self.start_and_stop("b", suite)
        machine = (self.folder / "b/machine.json").read_bytes()
        text = self.fine("run", suite, "--out", "b", "--dry-run")
        self.assertNotIn(", 0 of them done", text)
        self.bundle(suite, name="b")
        self.assertEqual((self.folder / "b/machine.json").read_bytes(), machine)
        self.assertEqual(len(self.table("b/timing.csv")), 9)  # and the sentinel

    def test_taken_again_on_another_machine(self):
        suite = self.suite(self.TWO)
        self.start_and_stop("b", suite)
        self.pretend_another_machine("b")
        self.assertIn("blocks       48, 0 of them done", self.fine("run", suite, "--out", "b", "--dry-run"))
        self.bundle(suite, name="b")
        self.assertNotIn("Other", (self.folder / "b/machine.json").read_text())


if __name__ == "__main__":
    unittest.main()
