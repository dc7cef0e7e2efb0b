#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Outputs and folders that cannot be written or read: exit codes, no file half-written. Usage: places_test.py BEZIERBENCH"""
import os
import resource
import signal
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINE, HAS_THREAD_SANITIZER, INPUT_OUTPUT, USAGE, Case  # noqa: E402


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

    def test_closed_output(self):
        for command in self.commands():
            with self.subTest(command=command):
                self.refused(INPUT_OUTPUT, command, "standard output", preexec_fn=lambda: os.close(1))

    def test_broken_pipe(self):
        for command in self.commands():
            for restore_signals in (True, False):  # False: SIGPIPE ignored, as Python does
                with self.subTest(command=command, restore_signals=restore_signals):
                    reader, writer = os.pipe()
                    os.close(reader)
                    result = self.run_program(*command, stdout=writer, restore_signals=restore_signals)
                    os.close(writer)
                    if restore_signals:
                        self.assertEqual((result.returncode, result.stderr), (-signal.SIGPIPE, b""))
                    else:
                        self.assertEqual(result.returncode, INPUT_OUTPUT)
                        self.assert_one_line(result, "standard output")

    def test_messages_that_cannot_be_written(self):
        suite = self.suite()
        with open("/dev/full", "wb") as full:
            self.assertEqual(self.run_program("nonsense", stderr=full).returncode, USAGE)
            self.assertEqual(self.run_program("run", suite, "--out", "a", stderr=full).returncode, FINE)
            self.assertEqual(self.run_program("run", suite, "--out", "a", stderr=full).returncode, FINE)
        closed = self.run_program("run", suite, "--out", "b", preexec_fn=lambda: (os.close(0), os.close(1), os.close(2)))
        self.assertEqual(closed.returncode, FINE)
        self.assert_complete("a")
        self.assert_complete("b")


class Places(Case):
    """Where results go, and where they cannot."""

    def test_places_that_are_none(self):
        self.suite()
        self.write("file", "mine")
        self.write("full/mine.txt", "mine")
        self.write("full/suite.toml", "mine")
        (self.folder / "loop").symlink_to("loop")
        for out in ("file", "file/b", "file/deep/b", "full", "loop", "loop/b", "/dev/null", "/proc/b", "n" * 300):
            with self.subTest(out=out):
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", out], f"bezierbench: {out}: ", "choose")

    def test_damaged_bundle(self):
        self.bundle()
        for content in ("", "{", "[]", '{"schema_version": 9}'):
            with self.subTest(content=content):
                self.write("b/bundle.json", content)
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", "b"], "b/bundle.json")

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


if __name__ == "__main__":
    unittest.main()
