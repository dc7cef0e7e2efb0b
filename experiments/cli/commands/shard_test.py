#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs in parts: side by side, one after the other, in one folder or in several that are merged, by hand and by the
launchers that people use. Usage: shard_test.py BEZIERBENCH"""
import os
import re
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import (  # noqa: E402
    ACCURACY, CONVERSION, FINDING, FINE, INPUT_OUTPUT, PATIENCE, PROGRAM, SEARCH, STUDY, TIMING, USAGE, ResumeCase)

# What launchers set, and none of it may leak from where the tests run.
PLAIN = {name: value for name, value in os.environ.items() if not re.match("OMPI_|PMI|SLURM_|PARALLEL", name)}
FAST_TIMING = {**TIMING, "modes": '["point"]', "methods": '["direct", "de_casteljau"]'}


class ShardCase(ResumeCase):
    def setUp(self):
        super().setUp()
        self.everything = self.suite(ACCURACY, CONVERSION, SEARCH)

    def whole(self, suite=None):
        self.bundle(suite or self.everything, name="whole")
        return self.results("whole")

    def shard(self, number, count, out, suite=None):
        """Runs to its end, quietly; the state that the bundle then has."""
        self.fine("run", suite or self.everything, "--quiet", "--out", out, "--shard", f"{number}/{count}")
        return self.manifest(out)["state"]

    def apart(self, count, suite=None):
        """Shards in folders of their own."""
        for number in range(1, count + 1):
            self.assertEqual(self.shard(number, count, f"s{number}", suite), "complete" if count == 1 else "partial")
        return [f"s{number}" for number in range(1, count + 1)]


class OneFolder(ShardCase):
    def test_one_after_the_other(self):
        expected = self.whole()
        self.assertEqual([self.shard(number, 3, "b") for number in (3, 1, 2)], ["partial", "partial", "complete"])
        self.assert_complete("b")
        self.assertEqual(self.results("b"), expected)
        self.assertEqual(self.shard(2, 3, "b"), "complete")

    def test_side_by_side(self):
        expected = self.whole()
        for count in (2, 5):
            with self.subTest(count=count):
                command = [PROGRAM, "run", self.everything, "--quiet", "--jobs", "1", "--out", f"b{count}", "--shard"]
                shards = [subprocess.Popen([*command, f"{number}/{count}"], cwd=self.folder, stderr=subprocess.PIPE)
                          for number in range(1, count + 1)]
                self.assertEqual([(shard.communicate(timeout=PATIENCE)[1], shard.returncode) for shard in shards],
                                 [(b"", FINE)] * count)
                self.assert_complete(f"b{count}")
                self.assertEqual(self.results(f"b{count}"), expected)

    def test_a_finished_shard_says_what_is_missing(self):
        result = self.run_program("run", self.everything, "--out", "b", "--shard", "2/2")
        self.assertEqual((result.returncode, result.stdout), (FINE, b""))
        self.assertIn("b: shard 2/2 is done, others are not\n", result.stderr.decode())
        text = self.fine("run", self.everything, "--out", "b", "--shard", "2/2", "--dry-run")
        blocks, done = re.search(r"blocks +(\d+) of shard 2/2, (\d+) of them done", text).groups()
        self.assertEqual(blocks, done)
        text = self.fine("run", self.everything, "--out", "b", "--shard", "1/2", "--dry-run")
        self.assertRegex(text, r"blocks +\d+ of shard 1/2, 0 of them done")

    def test_a_run_goes_on_where_shards_stopped(self):
        expected = self.whole()
        self.shard(2, 3, "b")
        self.shard(1, 2, "b")  # cut otherwise: what both did counts once
        self.bundle(self.everything, name="b")
        self.assertEqual(self.results("b"), expected)

    def test_whoever_comes_next_completes(self):
        """The last shard died when all blocks were done and the tables were not written."""
        expected = self.whole()
        for finisher in (["run", self.everything, "--quiet"], ["run", self.everything, "--quiet", "--shard", "1/3"],
                         ["merge", "--quiet", "b"]):
            with self.subTest(finisher=finisher):
                self.apart(3)
                shutil.copytree(self.folder / "s1", self.folder / "b")
                for number in (2, 3):
                    for path in self.block_files(f"s{number}"):
                        shutil.copy(path, self.folder / "b/blocks")
                self.fine(*finisher, "--out", "b")
                self.assert_complete("b")
                self.assertEqual(self.results("b"), expected)
                for name in ("b", "s1", "s2", "s3"):
                    shutil.rmtree(self.folder / name)

    def test_who_may_be_there_at_the_same_time(self):
        suite = self.suite({**ACCURACY, "trials": "2000000000"})
        run = ["run", suite, "--quiet", "--jobs", "1", "--out", "b"]
        with self.at_work("b", *run, "--shard", "1/2"):
            self.refused(INPUT_OUTPUT, [*run, "--shard", "1/2"], "b: the same shard 1/2 is at work", alone=False)
            self.refused(INPUT_OUTPUT, run, "b: another run is at work", alone=False)
            self.refused(INPUT_OUTPUT, ["merge", "b", "--out", "m"], "b: a run is at work", alone=False)
            self.assertEqual(self.stop(0.3, signal.SIGINT, *run, "--shard", "2/2").returncode, 130)
        self.assertEqual(self.stop(0.3, signal.SIGINT, *run, "--shard", "1/2").returncode, 130)  # no stale lock


class Merge(ShardCase):
    def test_any_order_gives_the_single_run(self):
        expected = self.whole()
        shards = self.apart(3)
        before = self.snapshot()
        for number, order in enumerate((shards, shards[::-1], [shards[1], shards[2], shards[0]])):
            self.assertEqual(self.fine("merge", "--quiet", *order, "--out", f"m{number}"), "")
            self.assert_complete(f"m{number}")
            self.assertEqual(self.results(f"m{number}"), expected)
            self.assertEqual((self.folder / f"m{number}/machine.json").read_bytes(),
                             (self.folder / "m0/machine.json").read_bytes())
        self.assertEqual({name: before[name] for name in before},
                         {name: value for name, value in self.snapshot().items() if name in before})

    def test_gaps_and_overlaps(self):
        shards = self.apart(3)
        self.refused(FINDING, ["merge", "s1", "s3", "--out", "m"], "blocks are missing", "study")
        self.refused(FINDING, ["merge", *shards, "s2", "--out", "m"], "s2: named twice")
        shutil.copytree(self.folder / "s2", self.folder / "copy")
        self.refused(FINDING, ["merge", *shards, "copy", "--out", "m"], "copy: ", "another of the bundles")
        path = self.block_files("s2")[0]
        path.write_bytes(path.read_bytes()[:-1])
        result = self.run_program("merge", *shards, "--out", "m")
        self.assertEqual(result.returncode, FINDING)
        self.assertIn("damaged", result.stderr.decode())
        self.assertFalse((self.folder / "m").exists())
        for name in ("machine.json", "suite.toml", "methods.csv"):
            path = self.folder / "s1" / name
            path.write_bytes(path.read_bytes()[:-1])
            self.refused(INPUT_OUTPUT, ["merge", "s1", "s3", "--out", "m"], f"s1/{name}: is not what SHA256SUMS lists")
            path.write_bytes(path.read_bytes() + b"\n")

    def test_other_runs_are_refused(self):
        self.apart(2)
        for name, arguments, *needles in [("seed", ["--seed", "7"], "seed 7", "has 1"),
                                          ("suite", ["--trials", "30"], "resolved suite tiny"),
                                          ("tier", ["--reference", "exact"], "reference")]:
            with self.subTest(name=name):
                self.fine("run", self.everything, "--quiet", "--out", name, "--shard", "2/2", *arguments)
                self.refused(FINDING, ["merge", "s1", name, "--out", "m"], f"{name}", *needles)

    def test_bundles_that_are_none_of_it(self):
        self.apart(2)
        self.bundle(self.everything)
        self.refused(FINDING, ["merge", "b", "--out", "m"], "b: is complete already")
        self.refused(INPUT_OUTPUT, ["merge", "absent", "--out", "m"], "absent")
        self.refused(USAGE, ["merge", "--out", "m"], "BUNDLE is required")
        self.refused(USAGE, ["merge", "s1", "s2"], "--out")
        shutil.copytree(self.folder / "s2", self.folder / "m")
        self.refused(FINDING, ["merge", "s1", "s2", "--out", "m"], "m: holds blocks of its own")
        self.write("other/file", "x")
        self.refused(INPUT_OUTPUT, ["merge", "s1", "s2", "--out", "other"], "other: is not empty")

    def test_what_is_there_is_not_written_over(self):
        self.apart(2)
        self.bundle(self.everything, "--seed", "7", name="theirs")
        self.refused(USAGE, ["merge", "s1", "s2", "--out", "theirs"], "theirs: holds results of seed 7, this run has 1")
        self.fine("run", self.everything, "--seed", "7", "--quiet", "--out", "begun", "--shard", "1/9")
        self.refused(USAGE, ["merge", "s1", "s2", "--out", "begun"], "begun: holds results of seed 7")
        self.fine("merge", "--quiet", "s1", "s2", "--out", "m")
        before = self.snapshot("m")
        self.fine("merge", "--quiet", "s2", "s1", "--out", "m")  # the very same
        self.assertEqual(self.snapshot("m"), before)
        self.pretend_another_machine("m")
        self.refused(USAGE, ["merge", "s1", "s2", "--out", "m"], "m: is complete already, with another machine.json")

    def test_no_table_of_another_run_gets_into_the_digest(self):
        self.apart(2)
        for name in ("fitting.csv", "notes.txt"):
            with self.subTest(name=name):
                shutil.copytree(self.folder / "s1", self.folder / "m")
                self.write(f"m/{name}", "study\nx\n")
                self.refused(INPUT_OUTPUT, ["merge", "m", "s2", "--out", "m"], f"m/{name}: is not a file that this run writes")
                self.refused(INPUT_OUTPUT, ["run", self.everything, "--quiet", "--out", "m"], f"m/{name}: is not a file that",
                             unchanged=False)
                (self.folder / f"m/{name}").unlink()
                self.bundle(self.everything, name="m")
                shutil.rmtree(self.folder / "m")

    def test_a_shard_that_has_every_block(self):
        """A study of one block: the others have nothing, and that one is complete at once."""
        one = self.suite({**STUDY, "trials": "5"}, name="one.toml")
        expected = self.whole(one)
        states = [self.shard(number, 3, f"s{number}", one) for number in (1, 2, 3)]
        self.assertEqual(sorted(states), ["complete", "partial", "partial"])
        for order in (["s1", "s2", "s3"], ["s3", "s2", "s1"]):
            full = f"s{states.index('complete') + 1}"
            told = self.run_program("merge", *order, "--out", "m").stderr.decode()
            self.assertEqual(told, f"m: {full} was the whole bundle already\n")
            self.assert_complete("m")
            self.assertEqual(self.results("m"), expected)
            shutil.rmtree(self.folder / "m")
        path = self.folder / full / "accuracy.csv"
        path.write_text(path.read_text() + "\n")
        self.refused(INPUT_OUTPUT, ["merge", "s1", "s2", "s3", "--out", "m"], f"{full}/accuracy.csv", "SHA256SUMS")

    def test_into_one_of_them(self):
        expected = self.whole()
        self.apart(2)
        self.fine("merge", "--quiet", "s2", "s1", "--out", "s1")
        self.assert_complete("s1")
        self.assertEqual(self.results("s1"), expected)


class TimesOfShards(ShardCase):
    def test_are_all_of_the_first(self):
        suite = self.suite(ACCURACY, {**FAST_TIMING, "degree": "[2, 3, 4]"})
        self.apart(2, suite)
        self.fine("merge", "--quiet", "s2", "s1", "--out", "m")
        self.assert_complete("m")
        self.assertEqual((self.folder / "m/machine.json").read_bytes(), (self.folder / "s1/machine.json").read_bytes())
        self.assertEqual(len(self.table("m/timing.csv")), 7)  # and the sentinel
        text = self.fine("run", self.suite(FAST_TIMING, name="t.toml"), "--out", "t", "--shard", "2/2", "--dry-run")
        self.assertIn("blocks       0 of shard 2/2", text)

    def test_of_another_machine_are_not_mixed(self):
        """A bundle that came to another machine: its times do not count there."""
        suite = self.suite(ACCURACY, FAST_TIMING)
        self.apart(2, suite)
        self.pretend_another_machine("s1")
        self.refused(FINDING, ["merge", "s1", "s2", "--out", "m"], "missing", 'study "t"')


class Launchers(ShardCase):
    def launched(self, *command, **options):
        result = subprocess.run([*map(str, command)], cwd=self.folder, env=PLAIN, check=False, timeout=PATIENCE,
                                capture_output=True, **options)
        self.assertEqual(result.returncode, FINE, result)

    def need(self, *tools):
        for tool in tools:
            if not shutil.which(tool):
                self.skipTest(f"{tool} is not installed")

    def test_variables(self):
        expected = self.whole()
        for rank in ("0", "1"):
            self.fine("run", self.everything, "--quiet", "--out", "pmi", "--shard", "auto",
                      env={**PLAIN, "PMI_RANK": rank, "PMI_SIZE": "2"})
        self.assert_complete("pmi")
        self.assertEqual(self.results("pmi"), expected)
        self.refused(USAGE, ["run", self.everything, "--out", "b", "--shard", "auto"], "--shard auto", env=PLAIN)

    def test_mpirun(self):
        self.need("mpirun")
        expected = self.whole()
        self.launched("mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "4", PROGRAM, "run", self.everything,
                      "--quiet", "--jobs", "1", "--out", "b", "--shard", "auto")
        self.assert_complete("b")
        self.assertEqual(self.results("b"), expected)


if __name__ == "__main__":
    unittest.main()
