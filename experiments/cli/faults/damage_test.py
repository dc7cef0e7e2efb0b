#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Damaged bundles: every file of a bundle, complete or in work, changed or cut at every kind of place. Nothing crashes, and
nothing wrong is taken for a result. Usage: damage_test.py BEZIERBENCH"""
import random
import re
import shutil
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import CONVERSION, FINDING, FINE, IN_MEMORY, INPUT_OUTPUT, STUDY, USAGE  # noqa: E402
from resume_case import SEARCH, ResumeCase

SMALL = {**STUDY, "trials": "20", "replicates": "2"}
# What `replay` recomputes from, and compares with.
REPLAYED = ("form", "method", "scalar", "dimension", "degree", "t", "coefficients", "weights", "error", "error_u")


def places(data):
    """One of every kind of place in a file, and some at random: name and position."""
    found = {"first byte": 0, "last byte": len(data) - 1, "middle": len(data) // 2, "in the head": min(12, len(data) - 1)}
    for name, pattern in [("separator", rb"[,:=]|  "), ("line end", rb"\n"), ("digit", rb"[0-9]"), ("letter", rb"[a-z]"),
                          ("quote", rb'"'), ("hash", rb"[0-9a-f]{64}"), ("exponent", rb"[ep][-+][0-9]")]:
        hits = [match.start() for match in re.finditer(pattern, data)]
        if hits:
            found |= {f"some {name}": hits[len(hits) // 2]}
    chance = random.Random(len(data))
    return found | {f"byte {place}": place for place in chance.sample(range(len(data)), min(2, len(data)))}


def damages(data):
    """Damaged copies of a file's bytes, each with what was done."""
    for number, (name, place) in enumerate(places(data).items()):
        bit = place % 8
        if number % 3 == 0:
            yield f"{name}: lost", data[:place] + data[place + 1:]
        else:
            yield f"{name}: bit {bit} flipped", data[:place] + bytes([data[place] ^ 1 << bit]) + data[place + 1:]
    for size in (0, 1, len(data) // 2, len(data) - 1):
        yield f"cut to {size} bytes", data[:size]
    line = data.find(b"\n", len(data) // 2) + 1
    yield "cut between lines", data[:line] if line < len(data) else b""
    yield "zeros in place of the second half", data[:len(data) // 2] + bytes(len(data) - len(data) // 2)
    yield "one byte more", data + b"\0"
    yield "twice", data + data
    yield "missing", None


class DamageCase(ResumeCase):
    place = IN_MEMORY

    def each_damage(self, name, check, files=None):
        """Damages one file of a folder after the other, in its copy `b`, and hands it to `check`; how many it were."""
        count = 0
        for path in sorted((self.folder / name).rglob("*")):
            if path.is_dir() or path.suffix == ".lock" or files and path.name not in files:
                continue
            data = path.read_bytes()
            for what, damaged in damages(data):
                if damaged == data:
                    continue
                count += 1
                shutil.rmtree(self.folder / "b", ignore_errors=True)
                shutil.copytree(self.folder / name, self.folder / "b")
                target = self.folder / "b" / path.relative_to(self.folder / name)
                with self.subTest(file=target.name, what=what):
                    if damaged is None:
                        target.unlink()
                    else:
                        target.write_bytes(damaged)
                    check(target)
        return count

    def assert_refused(self, result, codes, *needles):
        """One line, of any bytes, that has one of the needles."""
        message = result.stderr.decode(errors="replace")
        self.assertIn(result.returncode, codes, result)
        self.assertRegex(message, r"\Abezierbench: [^\n]+\n\Z")
        self.assertTrue(any(needle in message for needle in needles), message)


class Complete(DamageCase):
    def setUp(self):
        super().setUp()
        self.bundle(self.suite(SMALL, CONVERSION, SEARCH), name="whole")

    def test_verify_finds_everything(self):
        def check(target):
            result = self.run_program("verify", "b")
            self.assertEqual((result.returncode, result.stdout), (FINDING, b""), result)
            lines = result.stderr.decode(errors="replace").splitlines()
            self.assertTrue(all(line.startswith("bezierbench: b/") for line in lines), lines)
            self.assertTrue(any(f"b/{target.name}" in line or "SHA256SUMS" in line for line in lines), lines)

        self.assertGreater(self.each_damage("whole", check), 100)

    def test_no_blessing_of_damage(self):
        """What a killed run left is removed, and no checksum is written again."""
        (self.folder / "whole/blocks").mkdir()

        def check(_):
            for _ in ("with blocks/", "without"):
                result = self.run_program("run", "s.toml", "--quiet", "--out", "b")
                self.assertEqual(result.returncode, FINDING, result)
                self.assertIn(b"restore it, or remove it and run the command again", result.stderr)
                self.assertFalse((self.folder / "b/blocks").exists())
            self.assertEqual(self.run_program("verify", "b").returncode, FINDING)

        self.each_damage("whole", check, ["accuracy.csv", "SHA256SUMS"])


class InWork(DamageCase):
    """Two shards of a run, one of them damaged."""

    def setUp(self):
        super().setUp()
        self.suite(SMALL, CONVERSION)
        self.bundle("s.toml", name="whole")
        for number in (1, 2):
            self.fine("run", "s.toml", "--quiet", "--out", f"s{number}", "--shard", f"{number}/2")
        self.expected = self.results("whole")

    def assert_right_or_refused(self, result, name):
        if result.returncode == FINE:
            self.assert_complete(name)
            self.assertEqual(self.results(name), self.expected)
        else:
            self.assert_refused(result, (FINDING, USAGE, INPUT_OUTPUT), "b/", "b: ", "s2: ")

    def test_verify(self):
        def check(_):
            result = self.run_program("verify", "b")
            self.assertEqual((result.returncode, result.stdout), (FINDING, b""), result)

        self.each_damage("s1", check)

    def test_run_goes_on_or_refuses(self):
        codes = {}

        def check(target):
            result = self.run_program("run", "s.toml", "--quiet", "--out", "b")
            self.assert_right_or_refused(result, "b")
            codes.setdefault(target.name, set()).add(result.returncode)

        self.each_damage("s1", check)
        self.assertEqual({name: codes[name] for name in ("suite.toml", "methods.csv", "generators.csv", "machine.json")},
                         {"suite.toml": {INPUT_OUTPUT}, "methods.csv": {INPUT_OUTPUT}, "generators.csv": {INPUT_OUTPUT},
                          "machine.json": {FINE}})

    def test_merge_refuses(self):
        def check(target):
            shutil.rmtree(self.folder / "m", ignore_errors=True)
            sources = ["b", "s2"] if len(target.name) % 2 else ["s2", "b"]
            result = self.run_program("merge", *sources, "--out", "m")
            if target.suffix == ".blocks":
                self.assertEqual(result.returncode, FINDING, result)  # a gap, after a line that says what is damaged
                self.assertFalse((self.folder / "m").exists())
            else:
                self.assert_right_or_refused(result, "m")
            if target.name not in ("bundle.json", "SHA256SUMS"):  # of which not all is used
                self.assertNotEqual(result.returncode, FINE, result)

        self.each_damage("s1", check)


if __name__ == "__main__":
    unittest.main()
