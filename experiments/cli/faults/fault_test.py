#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Every system call that writes fails once, and nothing is lost: a one-line reason, earlier results untouched, and the
same command afterwards ends with the bytes of an undisturbed run. Usage: fault_test.py BEZIERBENCH FAILING_CALLS.so"""
import errno
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

FAILING_CALLS = os.path.abspath(sys.argv.pop(2))
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import CONVERSION, FINE, HAS_THREAD_SANITIZER, IN_MEMORY, INPUT_OUTPUT, PROGRAM, STUDY  # noqa: E402
from resume_case import ResumeCase

ERRORS = [errno.ENOSPC, errno.EIO, errno.EDQUOT, errno.EROFS]
# What POSIX lets a signal interrupt, of the calls that the program makes itself.
INTERRUPTIBLE = {"open", "write", "fsync", "close", "flock"}
PRELOAD = {"LD_PRELOAD": FAILING_CALLS, "ASAN_OPTIONS": "verify_asan_link_order=0"}
TINY = {**STUDY, "trials": "20"}


def is_harmless(call):
    """Whether nothing is lost where this call fails: letting go of a lock."""
    name, path = call
    return name in ("flock", "close") and re.search(r"\.lock( \(deleted\))?$", path)


class Faults(ResumeCase):
    """Each test prepares a folder `start`, and has a command that makes of its copy `b` a complete bundle."""

    place = IN_MEMORY

    def prepare(self, *studies):
        self.study_file = self.suite(*(studies or [TINY]))
        (self.folder / "start").mkdir()
        self.bundle(self.study_file, name="whole")
        self.expected = self.results("whole")

    def shard(self, number, name):
        self.fine("run", self.study_file, "--quiet", "--jobs", 1, "--out", name, "--shard", f"{number}/2")

    def command(self, *more):
        return ["run", self.study_file, "--quiet", "--jobs", 1, "--checkpoint", 0, "--out", "b", *more]

    def again(self):
        for name in ("b", "b.gone"):
            shutil.rmtree(self.folder / name, ignore_errors=True)
        shutil.copytree(self.folder / "start", self.folder / "b")

    def disturbed(self, command, at, how, times=1):
        """One run of the command on a fresh copy, with one call that fails."""
        self.again()
        return self.run_program(*command, env={
            **os.environ, **PRELOAD, "FAILING_CALLS_AT": str(at), "FAILING_CALLS_HOW": str(how),
            "FAILING_CALLS_TIMES": str(times), "FAILING_CALLS_FOLDER": "b"})

    def calls(self, command):
        """Name and path of every call of an undisturbed run, which is checked as well."""
        self.again()
        path = self.folder / "calls"
        path.unlink(missing_ok=True)
        self.fine(*command, env={**os.environ, **PRELOAD, "FAILING_CALLS_LIST": str(path)})
        self.assert_whole("b")
        return [tuple(line.split(" ", 1)) for line in path.read_text().splitlines()] if path.exists() else []

    def assert_whole(self, name):
        self.assert_complete_results(name)
        self.assertEqual({path.name for path in (self.folder / name).iterdir()},
                         {path.name for path in (self.folder / "whole").iterdir()})

    def assert_complete_results(self, name):
        self.assertEqual(self.manifest(name)["state"], "complete")
        self.assertEqual(self.results(name), self.expected)

    def assert_reason(self, result, reason):
        self.assertEqual(result.returncode, INPUT_OUTPUT, result)
        self.assertEqual(result.stdout, b"")
        self.assert_one_line(result, reason)
        self.assertRegex(result.stderr.decode(), "^bezierbench: (b|s[12])[:/]")  # the path at fault

    def is_complete(self, name):
        return (self.folder / name / "bundle.json").exists() and self.manifest(name)["state"] == "complete"

    def assert_nothing_lost(self, result, reason, may_be_fine):
        """A one-line reason and the earlier blocks, or a complete result."""
        name = "b.gone" if (self.folder / "b.gone").exists() else "b"
        if result.returncode == FINE and may_be_fine:
            self.assert_complete_results("b" if (self.folder / "b").exists() else name)
            return
        self.assert_reason(result, reason)
        if self.is_complete(name):
            self.assertEqual(self.results(name), self.expected)
        else:
            for path in self.block_files("start"):
                self.assertEqual((self.folder / name / "blocks" / path.name).read_bytes(), path.read_bytes())

    def assert_goes_on(self, command):
        if (self.folder / "b.gone").exists() and not (self.folder / "b").exists():
            (self.folder / "b.gone").rename(self.folder / "b")
        self.fine(*command)
        self.assert_whole("b")

    def assert_survives_failures(self, command, when_complete=None):
        """`when_complete` is the command for a bundle that is complete but for leftovers, if it is another."""
        calls = self.calls(command)
        sources = {name: self.snapshot(name) for name in ("s1", "s2")}
        for number, call in enumerate(calls, 1):
            with self.subTest(number=number, call=call):
                error = ERRORS[number % len(ERRORS)]
                result = self.disturbed(command, number, error)
                self.assert_nothing_lost(result, os.strerror(error), is_harmless(call))
                left = [name for name in self.snapshot("b") if name.endswith(".tmp")]
                self.assertEqual(left, [])
                self.assert_goes_on(when_complete if when_complete and self.is_complete("b") else command)
        self.assertEqual({name: self.snapshot(name) for name in sources}, sources)
        return calls

    # The tests.

    def test_first_run(self):
        self.prepare(TINY, CONVERSION)
        (self.folder / "start").rmdir()
        self.again = lambda: [shutil.rmtree(self.folder / name, ignore_errors=True) for name in ("b", "b.gone")]
        calls = self.assert_survives_failures(self.command())
        self.assertEqual({name for name, _ in calls},
                         {"open", "write", "fsync", "close", "rename", "mkdir", "unlink", "flock"})
        self.assertGreater(len(calls), 100)

    def test_run_that_goes_on(self):
        self.prepare({**TINY, "replicates": "4"})
        self.shard(1, "start")
        self.assert_survives_failures(self.command())

    def test_last_shard(self):
        self.prepare({**TINY, "replicates": "2"})
        self.shard(1, "start")
        self.assert_survives_failures(self.command("--shard", "2/2"))

    def test_merge(self):
        self.prepare({**TINY, "replicates": "2"})
        for number in (1, 2):
            self.shard(number, f"s{number}")
        self.assert_survives_failures(["merge", "--quiet", "s1", "s2", "--out", "b"])

    def test_merge_into_one_of_them(self):
        self.prepare({**TINY, "replicates": "2"})
        self.shard(1, "s1")
        (self.folder / "start").rmdir()
        self.shard(2, "start")
        self.pretend_another_machine("start")  # machine.json then comes from s1
        calls = self.assert_survives_failures(["merge", "--quiet", "b", "s1", "--out", "b"], self.command())
        self.assertIn(("rename", "b/machine.json"), calls)

    def test_gathering_of_files(self):
        """Many files of blocks become one; a file that then cannot be removed does no harm."""
        self.prepare({**TINY, "replicates": "4"})
        self.shard(1, "start")
        kept = self.block_files("start")[0].read_bytes()
        for number in range(1, 66):
            self.write(f"start/blocks/whole.{number:06}.blocks", kept)
        calls = self.calls(self.command())
        superseded = [call for call in calls if call[0] == "unlink" and call[1].startswith("b/blocks/")]
        self.assertGreater(len(superseded), 65)
        for number, call in enumerate(calls, 1):
            with self.subTest(number=number, call=call):
                result = self.disturbed(self.command(), number, errno.EIO)
                if result.returncode != FINE or not (is_harmless(call) or call in superseded):
                    self.assert_reason(result, os.strerror(errno.EIO))
                self.assert_goes_on(self.command())

    def test_complete_bundle(self):
        """Nothing is written to it; what a killed run left in it is removed."""
        self.prepare()
        shutil.rmtree(self.folder / "start")
        shutil.copytree(self.folder / "whole", self.folder / "start")
        self.assertEqual(self.calls(self.command()), [("open", "b")])  # to list what is in it
        self.write("start/blocks/whole.000001.blocks", "x")
        self.write("start/.bezierbench-1-1.tmp", "x")
        calls = self.calls(self.command())
        for number, call in enumerate(calls, 1):
            with self.subTest(number=number, call=call):
                result = self.disturbed(self.command(), number, errno.EIO)
                self.assert_nothing_lost_of_complete(result, call)
                self.assert_goes_on(self.command())

    def assert_nothing_lost_of_complete(self, result, call):
        self.assertEqual(self.results("b"), self.expected)
        if result.returncode != FINE or not is_harmless(call):
            self.assert_reason(result, os.strerror(errno.EIO))

    def test_from_one_moment_on(self):
        """The disk is full, and stays so: temporary files cannot be removed either."""
        self.prepare({**TINY, "replicates": "2"})
        self.shard(1, "start")
        calls = self.calls(self.command())
        for number, call in enumerate(calls, 1):
            with self.subTest(number=number, call=call):
                result = self.disturbed(self.command(), number, errno.ENOSPC, times=len(calls))
                self.assert_nothing_lost(result, os.strerror(errno.ENOSPC), is_harmless(call))
                self.assert_goes_on(self.command())

    def test_interrupted_calls_and_short_writes(self):
        self.prepare({**TINY, "replicates": "2"})
        self.shard(1, "start")
        for number, call in enumerate(self.calls(self.command()), 1):
            for how, times in [(errno.EINTR, 1)] * (call[0] in INTERRUPTIBLE) + \
                    [(errno.EINTR, 3)] * (call[0] in INTERRUPTIBLE - {"close"}) + \
                    [("short", 1), ("short", 3)] * (call[0] == "write"):
                with self.subTest(number=number, call=call, how=how, times=times):
                    result = self.disturbed(self.command(), number, how, times)
                    self.assertEqual((result.returncode, result.stderr), (FINE, b""), result)
                    self.assert_whole("b")

    def test_vanishing_folder(self):
        self.prepare({**TINY, "replicates": "2"})
        self.shard(1, "start")
        codes = set()
        for number, call in enumerate(self.calls(self.command()), 1):
            with self.subTest(number=number, call=call):
                result = self.disturbed(self.command(), number, "vanish")
                codes.add(result.returncode)
                self.assert_nothing_lost(result, os.strerror(errno.ENOENT), True)
                self.assert_goes_on(self.command())
        self.assertIn(INPUT_OUTPUT, codes)

    def test_no_call_is_missed(self):
        """What the kernel sees is what was counted."""
        names = ("write pwrite64 writev fsync fdatasync sync_file_range rename renameat renameat2 mkdir mkdirat unlink "
                 "unlinkat rmdir flock ftruncate truncate link linkat symlink symlinkat fallocate sendfile "
                 "copy_file_range msync").split()
        if not shutil.which("strace"):
            self.skipTest("strace is not installed")
        if HAS_THREAD_SANITIZER:
            self.skipTest("the thread sanitizer makes such calls of its own")
        self.prepare()
        counted = self.calls(self.command())
        self.again()
        trace = self.folder / "trace"
        subprocess.run(["strace", "-f", "-o", trace, "-e", "trace=" + ",".join(names), PROGRAM,
                        *map(str, self.command())], cwd=self.folder, check=False, capture_output=True)
        if not trace.exists() or "exited with 0" not in trace.read_text():
            self.skipTest("strace may not trace here")
        seen = re.findall(r"^\d+ +(\w+)\(", trace.read_text(), re.MULTILINE)
        removed = seen.count("rmdir")  # std::filesystem tries unlink, then rmdir, in one call
        self.assertEqual(len(seen) - removed, sum(name not in ("open", "close") for name, _ in counted))


if __name__ == "__main__":
    unittest.main()
