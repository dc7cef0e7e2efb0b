#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs, shards and merges killed at random moments: the same commands again end with the bytes of a run that was not
killed. Usage: kill_test.py BEZIERBENCH [--kills N] [--seed S]"""
import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import ACCURACY, CONVERSION, FINE, PATIENCE, PROGRAM, SEARCH, ResumeCase  # noqa: E402

SHARDS = 3
NO_LEAK_CHECK = {"ASAN_OPTIONS": "detect_leaks=0"}  # it writes an error if the process is killed meanwhile


def options():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kills", type=int, default=30, help="how many processes are killed, at least")
    parser.add_argument("--seed", type=int, default=1, help="of the moments; the machine adds chance of its own")
    known, sys.argv[1:] = parser.parse_known_args()
    return known


class Kills(ResumeCase):
    def setUp(self):
        super().setUp()
        self.chance = random.Random(OPTIONS.seed)
        self.everything = self.suite(ACCURACY, CONVERSION, SEARCH)
        before = time.monotonic()
        self.bundle(self.everything, "--checkpoint", 0, name="whole")
        self.whole = time.monotonic() - before
        self.expected = self.results("whole")
        self.kills = self.resumed = self.completed = 0

    def command(self, out, *more):
        checkpoint = self.chance.choice([["--checkpoint", "0"], ["--checkpoint", "0.01"], []])
        return ["run", self.everything, "--quiet", "--out", out, *checkpoint, *more]

    def kill_all(self, commands, longest):
        """Starts the commands side by side and kills each at a moment of its own. Whether all came to their end."""
        running = [subprocess.Popen([PROGRAM, *command], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                    env={**os.environ, **NO_LEAK_CHECK}) for command in commands]
        moments = sorted(((self.chance.uniform(0, longest), process) for process in running), key=lambda one: one[0])
        start = time.monotonic()
        for moment, process in moments:
            try:
                process.wait(max(0, start + moment - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
        ends = [(process.communicate(timeout=PATIENCE)[1], process.returncode) for process in running]
        codes = [code for _, code in ends]
        for end in ends:
            self.assertIn(end, [(b"", FINE), (b"", -signal.SIGKILL)])
        self.kills += codes.count(-signal.SIGKILL)
        return set(codes) == {FINE}

    def assert_end(self, name):
        self.completed += 1
        self.assert_complete(name)
        self.assertEqual(self.results(name), self.expected)
        shutil.rmtree(self.folder / name)

    def assert_no_false_claim(self, name):
        """Only blocks/ may be there still where the bundle says that it is complete."""
        self.resumed += bool(self.block_files(name))
        if (self.folder / name / "bundle.json").exists() and self.manifest(name)["state"] == "complete":
            self.assertEqual(self.results(name), self.expected)

    def kill_often(self, share, commands_for, longest):
        """So many kills, and then until everything has come to its end."""
        while self.kills < share * OPTIONS.kills or not self.completed:
            name = f"b{self.completed}"
            if self.kill_all(commands_for(name), longest):
                self.assert_end(name)
            else:
                self.assert_no_false_claim(name)
        print(f"{self.id().split('.')[-1]}: seed {OPTIONS.seed}, {self.kills} kills, {self.resumed} times after blocks were "
              f"kept; {self.completed} bundles came to their end", flush=True)

    def test_runs(self):
        self.kill_often(0.5, lambda name: [self.command(name)], self.whole)
        self.assertGreater(self.resumed, 0)

    def test_shards_side_by_side(self):
        def commands(name):
            return [self.command(name, "--jobs", "1", "--shard", f"{number}/{SHARDS}") for number in range(1, SHARDS + 1)]

        self.kill_often(0.4, commands, 2 * self.whole)
        self.assertGreater(self.resumed, 0)

    def test_merges(self):
        parts = [f"s{number}" for number in range(1, SHARDS + 1)]
        for number, part in enumerate(parts, 1):
            self.fine(*self.command(part, "--shard", f"{number}/{SHARDS}"))
        before = [self.snapshot(part) for part in parts]
        start = time.monotonic()
        self.fine("merge", "--quiet", *parts, "--out", "timed")
        self.kill_often(0.1, lambda name: [["merge", "--quiet", *parts, "--out", name]], time.monotonic() - start)
        self.assertEqual([self.snapshot(part) for part in parts], before)


if __name__ == "__main__":
    OPTIONS = options()
    unittest.main()
