#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Outputs and folders that cannot be written or read: exit codes, no file half-written. Usage: places_test.py BEZIERBENCH"""
import os
import resource
import shutil
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import CONVERSION, FINE, HAS_THREAD_SANITIZER, INPUT_OUTPUT, STUDY, Case, ResumeCase  # noqa: E402


class StandardStreams(Case):
    def commands(self):
        self.write("c.csv", "x\n1\n2\n")
        return [["curve", "eval", "--curve", "c.csv", "--t", "0.5"], ["curve", "convert", "--curve", "c.csv", "--method",
                "exact"], ["list", "methods"], ["list", "methods", "--format", "csv"], ["--help"], ["--version"],
                ["run", self.suite(), "--out", "b", "--dry-run"]]

    def test_full_output(self):
        for command in self.commands():
            with self.subTest(command=command), open("/dev/full", "wb") as full:
                self.refused(INPUT_OUTPUT, command, "standard output", stdout=full)


class Places(ResumeCase):
    """Where results go, and where they cannot."""

    def test_places_that_are_none(self):
        self.suite()
        self.write("file", "mine")
        self.write("full/mine.txt", "mine")
        self.write("full/suite.toml", "mine")
        for out in ("file", "file/deep/b", "full", "/proc/b", "n" * 300):
            with self.subTest(out=out):
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", out], f"bezierbench: {out}: ", "choose")

    def test_locks_are_made_in_the_bundle_only(self):
        self.suite()
        self.write("away/kept", "mine")
        (self.folder / "p").mkdir()
        self.write("p/suite.toml", "x")
        (self.folder / "p/blocks").symlink_to("../away")
        self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", "p"], "p/blocks: is not a folder")
        self.assertEqual(os.listdir(self.folder / "away"), ["kept"])

    def test_existing_and_deep_folders(self):
        (self.folder / "empty").mkdir()
        self.bundle(self.suite(), name="empty")
        self.bundle("s.toml", name="deep/deeper/b")

    def test_no_room(self):
        self.suite(degree="[" + ", ".join(map(str, range(40))) + "]", methods=None, trials="1", dimension="[1, 2]")
        self.bundle("s.toml", name="good")
        sizes = {path.name: path.stat().st_size for path in (self.folder / "good").iterdir()}
        inputs = max(sizes[name] for name in ("suite.toml", "machine.json", "methods.csv"))
        self.assertGreater(sizes["accuracy.csv"], inputs + 1)
        nothing = 1 if HAS_THREAD_SANITIZER else 0
        for limit in (nothing, 100, sizes["suite.toml"], inputs, sizes["accuracy.csv"] - 1):
            with self.subTest(limit=limit):
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", f"b{limit}"], f"b{limit}/", "choose another --out",
                             unchanged=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assert_not_complete(f"b{limit}")
                self.bundle("s.toml", name=f"b{limit}")  # once there is room
                self.assertEqual(self.manifest(f"b{limit}"), self.manifest("good"))

    def test_a_full_disk_loses_no_block(self):
        """A write fails at the size of each file: earlier blocks stay, and the same command ends with the bytes of a run
        that was not disturbed."""
        studies = {**STUDY, "trials": "20", "replicates": "2"}, CONVERSION
        run = ["run", self.suite(*studies), "--quiet", "--jobs", "1", "--checkpoint", "0", "--out", "b"]
        self.bundle("s.toml", name="whole")
        self.fine("run", "s.toml", "--quiet", "--out", "start", "--shard", "1/2")
        sizes = {path.stat().st_size for name in ("whole", "start") for path in (self.folder / name).rglob("*") if path.is_file()}
        refusals = 0
        for limit in sorted({size - 1 for size in sizes if size > 1}):
            with self.subTest(limit=limit):
                shutil.rmtree(self.folder / "b", ignore_errors=True)
                shutil.copytree(self.folder / "start", self.folder / "b")
                result = self.run_program(*run, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assertEqual([name for name in self.snapshot("b") if name.endswith(".tmp")], [])
                if result.returncode != FINE:
                    refusals += 1
                    self.assertEqual(result.returncode, INPUT_OUTPUT, result)
                    self.assert_one_line(result, "b/", "choose another --out")
                    for path in self.block_files("start"):
                        self.assertEqual((self.folder / "b/blocks" / path.name).read_bytes(), path.read_bytes())
                self.fine(*run)
                self.assert_complete("b")
                self.assertEqual(self.results("b"), self.results("whole"))
        self.assertGreater(refusals, 5)


if __name__ == "__main__":
    unittest.main()
