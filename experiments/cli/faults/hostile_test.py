#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Bundles from strangers: damaged and hostile ones, by seed, through every command that reads a bundle. None may crash, hang,
write anywhere but where it was told to, let control characters through, or use what is damaged in silence.

hostile_test.py BEZIERBENCH [--bundles N] [--seed S] [--report]    --report: through scripts/report as well, which takes seconds
"""
import argparse
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import (CONVERSION, FINE, HAS_SANITIZER, IN_MEMORY, INPUT_OUTPUT, PROGRAM, ROOT, STUDY,  # noqa: E402
                          TIMING, Case, rows)
from resume_case import SEARCH  # noqa: E402

sys.path.append(str(ROOT))
from scripts.hostile_bundle import damaged, deterministic, sign  # noqa: E402

LONGEST = 60  # seconds for any command: all take less than one
MEMORY = 6 * 2**30
MADE = {"out", "pages"}  # what commands are told to make
SMALL = {**STUDY, "trials": "20", "replicates": "2", "decomposed_trials": "5"}
FAST = {**TIMING, "modes": '["point"]', "methods": '["direct", "de_casteljau"]'}


def options():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bundles", type=int, default=15)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--report", action="store_true")
    chosen, rest = parser.parse_known_args()
    sys.argv[1:] = rest
    return chosen


def limited():
    if not HAS_SANITIZER:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Hostile(Case):
    place = IN_MEMORY

    def setUp(self):
        super().setUp()
        self.bundle(self.suite(SMALL, CONVERSION, {**SEARCH, "trials": "20", "budget": "20"}, FAST), name="good")
        self.suite(SMALL, CONVERSION, name="shards.toml")
        for number in (1, 2):
            self.fine("run", "shards.toml", "--quiet", "--out", f"s{number}", "--shard", f"{number}/2")
        shutil.copytree(self.folder / "good", self.folder / "outside")
        self.write("outside/kept", "mine\n")
        self.write("outside/folder/kept", "mine\n")
        self.worst = rows((self.folder / "good/worst.csv").read_text())[-1]["worst_id"]
        self.found = rows((self.folder / "good/search.csv").read_text())[0]["search_id"]

    def readers(self, bundle):
        """Commands that only read, with the files that each uses; and whether it has --damaged."""
        tables = {"bundle.json", "machine.json", "timing.csv", *deterministic(os.listdir(self.folder / "good"))}
        choose = ["choose", bundle, "--degree", "3", "--tolerance", "1000"]
        trials = ["trials", bundle, "--study", "a", "--method", "direct"]
        yield ["verify", bundle], set(os.listdir(self.folder / "good")), False
        yield ["compare", "good", bundle], tables, True
        yield ["compare", bundle, "good", "--format", "csv"], tables, True
        yield choose, {"timing.csv", "accuracy.csv"}, True
        yield [*choose, "--format", "csv"], {"timing.csv", "accuracy.csv"}, True
        yield trials, {"suite.toml"}, True
        yield ["replay", bundle, self.worst], {"worst.csv"}, True
        yield ["replay", bundle, self.found], {"worst.csv", "search.csv"}, True
        yield ["run", "s.toml", "--out", bundle, "--dry-run"], set(), False

    def assert_behaves(self, command, result):
        self.assertIn(result.returncode, (0, 1, 2, 3, 4), (command, result.stderr[-2000:]))
        message = result.stderr.decode(errors="replace")
        self.assertNotRegex(message, r"Traceback|terminate called|AddressSanitizer|runtime error")
        self.assertNotRegex(message, "[\x00-\x08\x0b-\x1f\x7f]", command)
        for line in message.splitlines():
            self.assertLess(len(line), 10000, command)
        if result.returncode not in (FINE,):
            self.assertTrue(message, command)

    def ran(self, command, program=PROGRAM):
        result = subprocess.run([program, *command], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                                timeout=LONGEST, preexec_fn=limited, check=False)
        self.assert_behaves(command, result)
        return result

    def snapshot_of(self, name):
        return {path.relative_to(self.folder): (os.lstat(path).st_mode, os.lstat(path).st_size, os.lstat(path).st_mtime_ns)
                for path in sorted((self.folder / name).rglob("*"))}

    def fresh(self, start, seed):
        for name in MADE | {"b"}:
            shutil.rmtree(self.folder / name, ignore_errors=True)
        shutil.copytree(self.folder / start, self.folder / "b")
        return damaged(self.folder / "b", random.Random(seed))

    def assert_outside_is_as_it_was(self, before):
        self.assertEqual({name: self.snapshot_of(name) for name in before}, before)
        self.assertLessEqual({path.name for path in self.folder.iterdir()}, {*before, "s.toml", "shards.toml", "b", *MADE})

    def each_bundle(self, start, check):
        for number in range(OPTIONS.bundles):
            seed = f"{OPTIONS.seed}/{start}/{number}"
            with self.subTest(seed=seed):
                changed, signed = self.fresh(start, seed)
                others = {name: self.snapshot_of(name) for name in ("good", "s1", "s2", "outside")}
                check(changed, signed)
                self.assert_outside_is_as_it_was(others)

    def test_commands_that_read(self):
        used = [0, 0]

        def check(changed, signed):
            before = self.snapshot_of("b")
            for command, files, has_damaged in self.readers("b"):
                result = self.ran(command)
                damage = not signed and changed & files
                used[bool(damage)] += 1
                if damage:
                    self.assertNotEqual(result.returncode, FINE, (command, changed))
                    self.assertEqual(result.stdout, b"", (command, changed))
                if not has_damaged:
                    continue
                result = self.ran([*command, "--damaged"])
                if damage and result.stdout:
                    self.assertRegex(result.stdout.split(b"\n")[0], b"^# DAMAGED", (command, changed))
            self.assertEqual(self.snapshot_of("b"), before)

        self.each_bundle("good", check)
        self.assertGreater(min(used), 0)

    def test_report(self):
        if not OPTIONS.report:
            self.skipTest("not asked for (--report)")

        def check(changed, signed):
            before = self.snapshot_of("b")
            result = self.ran(["b", "--out", "pages"], ROOT / "scripts/report")
            if not signed and changed & {"bundle.json", "machine.json", "accuracy.csv", "timing.csv"}:
                self.assertNotEqual(result.returncode, FINE, changed)
            self.assertEqual(self.snapshot_of("b"), before)

        self.each_bundle("good", check)

    def test_runs_that_go_on(self):
        """What they write is the bundle alone; where they say that all is well, verify does too."""

        def check(_changed, _signed):
            suite = "shards.toml"
            for command in (["run", suite, "--quiet", "--out", "b", "--shard", "2/2"], ["run", suite, "--quiet", "--out", "b"]):
                result = self.ran(command)
            if result.returncode == FINE:
                self.assertEqual(self.fine("verify", "b").splitlines()[0], "b: fine")

        self.each_bundle("s1", check)
        self.each_bundle("good", lambda *_: self.ran(["run", "s.toml", "--quiet", "--out", "b"]))

    def test_merges(self):
        def check(_changed, _signed):
            for command in (["merge", "--quiet", "b", "s2", "--out", "out"], ["merge", "--quiet", "s2", "b", "--out", "out"],
                            ["merge", "--quiet", "s1", "s2", "--out", "b"], ["merge", "--quiet", "b", "s2", "--out", "b"]):
                if self.ran(command).returncode == FINE:
                    self.assertEqual(self.fine("verify", command[-1]).splitlines()[0], f"{command[-1]}: fine")

        self.each_bundle("s1", check)


class Named(Case):
    """What was seen to go wrong, one by one."""

    def setUp(self):
        super().setUp()
        self.bundle()

    def test_a_pipe_hangs_nobody(self):
        for name in ("accuracy.csv", "bundle.json", "suite.toml", "SHA256SUMS"):
            with self.subTest(name=name):
                path = self.folder / "b" / name
                kept = path.read_bytes()
                path.unlink()
                os.mkfifo(path)
                commands = [["verify", "b"], ["run", "s.toml", "--out", "b"]]
                if name != "suite.toml":  # which `compare` does not look at
                    commands.append(["compare", "b", "b"])
                for command in commands:
                    result = self.run_program(*command, timeout=LONGEST)
                    self.assertIn(result.returncode, (1, INPUT_OUTPUT), result)
                path.unlink()
                path.write_bytes(kept)

    @unittest.skipIf(HAS_SANITIZER, "a sanitizer takes more memory than the limit")
    def test_a_link_to_an_endless_device_fills_no_memory(self):
        path = self.folder / "b/accuracy.csv"
        path.unlink()
        path.symlink_to("/dev/zero")
        for command in (["verify", "b"], ["run", "s.toml", "--out", "b"], ["compare", "b", "b", "--damaged"]):
            result = self.run_program(*command, timeout=LONGEST, preexec_fn=limited)
            self.assertIn(result.returncode, (1, INPUT_OUTPUT), result)

    def test_links_are_replaced_and_not_written_through(self):
        self.write("mine.csv", "mine")
        self.suite({**SMALL, "replicates": "3"}, name="t.toml")
        self.fine("run", "t.toml", "--quiet", "--out", "p", "--shard", "1/2")
        (self.folder / "p/accuracy.csv").symlink_to("../mine.csv")
        self.fine("run", "t.toml", "--quiet", "--out", "p")
        self.assertFalse((self.folder / "p/accuracy.csv").is_symlink())
        self.assertEqual((self.folder / "mine.csv").read_text(), "mine")
        self.assert_complete("p")

    def test_locks_are_made_in_the_bundle_only(self):
        self.write("away/kept", "mine")
        (self.folder / "p").mkdir()
        self.write("p/suite.toml", "x")
        (self.folder / "p/blocks").symlink_to("../away")
        self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", "p"], "p/blocks: is not a folder")
        self.assertEqual(os.listdir(self.folder / "away"), ["kept"])

    def test_schema_and_required_tables(self):
        """With checksums that are right."""
        for name, change, needle in [
                ("accuracy.csv", lambda text: re.sub(",exact,ok,", ",exact,fine,", text, count=1), "status is"),
                ("accuracy.csv", lambda text: text.replace("p50_error", "median"), "column 'median'"),
                ("machine.json", lambda text: text.replace('"caches"', '"caches_"'), "caches"),
                ("bundle.json", lambda text: text.replace('"seed": 1', '"seed": 7'), "seed is 7, in suite.toml 1"),
                ("bundle.json", lambda text: text.replace('"git_clean"', '"git_clear"'), "git_clean"),
                ("suite.toml", lambda text: text.replace("seed = 1", "seed = 2"), "seed is 1, in suite.toml 2"),
                ("suite.toml", lambda text: text.replace('id = "a"', 'id = "z"'), "its study is not one of those"),
                ("accuracy.csv", None, "accuracy.csv: is missing, a study"),
                ("reference.csv", None, "reference.csv: is missing, a study")]:
            with self.subTest(name=name, needle=needle):
                shutil.rmtree(self.folder / "c", ignore_errors=True)
                shutil.copytree(self.folder / "b", self.folder / "c")
                path = self.folder / "c" / name
                if change is None:
                    path.unlink()
                else:
                    text = change(path.read_text())
                    self.assertNotEqual(text, path.read_text())
                    path.write_text(text)
                sign(self.folder / "c")
                result = self.run_program("verify", "c")
                self.assertEqual((result.returncode, result.stdout), (1, b""), result)
                self.assertIn(needle, result.stderr.decode())

    def test_a_foreign_folder_is_one_line(self):
        for number in range(5):
            self.write(f"thesis/{number}.tex", "x")
        result = self.run_program("verify", "thesis")
        self.assertEqual(result.returncode, 1)
        self.assert_one_line(result, "thesis: is not a bundle")


if __name__ == "__main__":
    OPTIONS = options()
    unittest.main()
