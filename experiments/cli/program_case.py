# SPDX-License-Identifier: MIT
"""What tests that run the program have and expect. The program is $BEZIERBENCH or the first argument."""
import contextlib
import csv
import hashlib
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.path.abspath(os.environ.get("BEZIERBENCH") or sys.argv.pop(1))
ROOT = Path(__file__).resolve().parents[2]
REPORT_SUITE = ROOT / "experiments/suites/report.toml"

FINE, FINDING, USAGE, ENVIRONMENT, INPUT_OUTPUT, INTERRUPTED = 0, 1, 2, 3, 4, 130
CODE = Path(PROGRAM).read_bytes()
# The thread sanitizer writes a file of its own before main.
HAS_THREAD_SANITIZER = b"libtsan" in CODE
HAS_SANITIZER = HAS_THREAD_SANITIZER or b"libasan" in CODE
CAN_COUNT = shutil.which("valgrind") and not HAS_SANITIZER
WAITING = re.compile(r"\Abezierbench: [^\n]+ takes more than 3 seconds; Ctrl-C ends this\n")
PATIENCE = 600  # seconds for a program to do what it should, on a busy machine, under a sanitizer: longer is a hang
ADVICE = r"; |must|write|see|from|did you mean|is empty"

METHOD_COLUMNS = ["id", "problem", "form", "min_degree", "max_degree", "bound", "bit_stable", "flops", "citation", "guarantees"]
PROJECT_COLUMNS = ["method", "t", "distance", "candidates", "exact_t", "exact_distance", "error"]
EVAL_COLUMNS = ["method", "t", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"]
BERNSTEIN = ["direct", "direct_pow", "de_casteljau", "de_casteljau_lerp", "horner_bernstein"]
POWER = ["power_sum", "horner"]
TO_POWER = ["factorial", "differences", "exact"]
TO_BERNSTEIN = ["forward_substitution", "positive_sum", "triangle", "exact"]

HEAD = ['schema_version = 1', '[suite]', 'id = "tiny"', 'title = "Tiny"', 'seed = 1']
STUDY = {"id": '"a"', "kind": '"accuracy"', "curve": '"bernstein"', "degree": "[3]", "coordinate_range": "[1]",
         "trials": "50", "methods": '["direct", "de_casteljau"]'}
CONVERSION = {"id": '"c"', "kind": '"conversion"', "curve": '"bernstein"', "degree": "[3, 5]",
              "coordinate_range": "[1]", "trials": "5", "replicates": "4",
              "methods": '["factorial+forward_substitution"]'}
TIMING = {"id": '"t"', "kind": '"timing"', "curve": '"bernstein"', "degree": "[3]", "coordinate_range": "[1]"}
NOISY = ("machine.json", "SHA256SUMS")  # the load of the machine is in the former
# Several blocks per replicate, several replicates per cell, cells in two scalar types, and every kind of study.
ACCURACY = {**STUDY, "degree": "[3, 9]", "trials": "2200", "replicates": "2", "decomposed_trials": "20",
            "scalar": '["double", "float"]', "baseline": '["exact", "direct"]',
            "methods": '["direct", "de_casteljau", "direct_pow"]'}
SEARCH = {"id": '"s"', "kind": '"search"', "curve": '"bernstein"', "degree": "[3, 5]", "coordinate_range": "[1]",
          "trials": "300", "budget": "300", "methods": '["direct", "de_casteljau"]'}


def lines_of(*studies, **changes):
    """The lines of a suite; `changes` go to its first study, None leaves a key out."""
    studies = [dict(study) for study in studies or [STUDY]]
    studies[0].update(changes)
    lines = list(HEAD)
    for study in studies:
        lines += ["[[study]]"] + [f"{key} = {value}" for key, value in study.items() if value is not None]
    return lines


def rows(text):
    return list(csv.DictReader(io.StringIO(text), strict=True))


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bezierbench-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    # What a test needs to have, and to do.

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def suite(self, *studies, name="s.toml", **changes):
        return self.write(name, "\n".join(lines_of(*studies, **changes)) + "\n")

    def run_program(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL,
                   "timeout": 60, **options}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, check=False, **options)

    def snapshot(self, folder="."):
        """Every name below a folder, with the bytes of files and the targets of links."""
        found = {}
        for path in sorted((self.folder / folder).rglob("*")):
            name = str(path.relative_to(self.folder))
            found[name] = os.readlink(path) if path.is_symlink() else path.is_dir() or path.read_bytes()
        return found

    def list_anew(self, bundle):
        """Makes SHA256SUMS that of the files as they are, as whoever changes a bundle on purpose can."""
        folder = self.folder / bundle
        names = sorted(path.name for path in folder.iterdir() if path.is_file() and path.name != "SHA256SUMS")
        (folder / "SHA256SUMS").write_text(
            "".join(f"{hashlib.sha256((folder / name).read_bytes()).hexdigest()}  {name}\n" for name in names))

    def table(self, path):
        """The rows of a table; none where there is no such file."""
        path = self.folder / path
        return rows(path.read_text(encoding="utf-8")) if path.exists() else []

    def write_rows(self, path, table):
        with open(self.folder / path, "w", newline="", encoding="utf-8") as text:
            writer = csv.DictWriter(text, table[0].keys(), lineterminator="\n")
            writer.writeheader()
            writer.writerows(table)

    def write_table(self, path, table):
        """Writes a table of a bundle, and its checksum."""
        self.write_rows(path, table)
        self.list_anew(Path(path).parent)

    def edit(self, path, change):
        """Applies `change` to every row of a table of a bundle; rows for which it returns False are left out."""
        self.write_table(path, [row for row in self.table(path) if change(row) is not False])

    def manifest(self, bundle):
        return json.loads((self.folder / bundle / "bundle.json").read_text())

    # What is expected.

    def assert_one_line(self, result, *needles):
        message = result.stderr.decode()
        if HAS_SANITIZER:  # with one, an exact result takes so long that the program says so first
            message = WAITING.sub("", message)
        self.assertRegex(message, r"\Abezierbench: [^\n]+\n\Z")
        self.assertTrue(message[:-1].isprintable(), message)
        self.assertRegex(message, ADVICE)
        for needle in needles:
            self.assertIn(needle, message)

    def refused(self, code, arguments, *needles, unchanged=True, alone=True, **options):
        """The program ends with `code` and one line that has the needles, prints nothing and changes no file; `alone`
        says whether no other writes there at the same time."""
        before = self.snapshot() if alone else None
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, code, result)
        self.assertIn(result.stdout, (b"", None))
        self.assert_one_line(result, *needles)
        if not alone:
            return result
        after = self.snapshot()
        self.assertEqual([name for name in after if name.endswith(".tmp")], [])
        if unchanged:
            self.assertEqual(before, after)
        return result

    def fine(self, *arguments, **options):
        """The program's standard output; standard error stays empty."""
        result = self.run_program(*arguments, **options)
        self.assertEqual((result.returncode, result.stderr or b""), (FINE, b""), result)
        return (result.stdout or b"").decode()

    def assert_fits(self, *arguments, columns=(60, 80), code=FINE):
        """No line is longer than the terminal is wide, except commands to be pasted."""
        for width in columns:
            result = self.run_program(*arguments, env={**os.environ, "COLUMNS": str(width)})
            self.assertEqual(result.returncode, code, result.stderr)
            lines = [line for line in result.stdout.decode().splitlines() if "bezierbench replay " not in line]
            self.assertEqual([line for line in lines if len(line) > width], [])

    def our_methods(self):
        """The lines of `list methods` without those of other libraries, which a build may have as well."""
        return [row for row in rows(self.fine("list", "methods", "--format", "csv")) if not row["id"].startswith("peer_")]

    def bundle(self, *arguments, name="b", **options):
        """A complete bundle whose checksums hold."""
        arguments = arguments or [self.suite()]
        self.assertEqual(self.fine("run", *arguments, "--quiet", "--out", name, **options), "")
        self.assert_complete(name)
        return name

    def assert_complete(self, name):
        self.assertEqual(self.manifest(name)["state"], "complete")
        self.assertFalse((self.folder / name / "blocks").exists())
        subprocess.run(["sha256sum", "--check", "--strict", "--quiet", "SHA256SUMS"], cwd=self.folder / name,
                       check=True, capture_output=True)
        self.assertEqual(self.fine("verify", name).splitlines()[0], f"{name}: fine")

    def assert_not_complete(self, name):
        if (self.folder / name / "bundle.json").exists():
            self.assertEqual(self.manifest(name)["state"], "partial")


class ResumeCase(Case):
    """What the tests of runs that are stopped, shared out or disturbed have in common."""

    def results(self, bundle):
        """Everything that does not depend on the time: name and bytes."""
        return {path.name: path.read_bytes() for path in (self.folder / bundle).iterdir()
                if path.suffix in (".csv", ".json", ".toml") and path.name not in NOISY and "timing" not in path.name}

    def block_files(self, bundle):
        try:
            names = os.listdir(self.folder / bundle / "blocks")
        except FileNotFoundError:  # not yet, or no more
            return []
        return [self.folder / bundle / "blocks" / name for name in sorted(names) if name.endswith(".blocks")]

    def change(self, bundle, name, content):
        """Another content of a file, with its checksum."""
        path, sums = self.folder / bundle / name, self.folder / bundle / "SHA256SUMS"
        self.assertNotEqual(path.read_text(), content)
        path.write_text(content)
        line = f"{hashlib.sha256(content.encode()).hexdigest()}  {name}"
        sums.write_text(re.sub(rf"^\w+  {re.escape(name)}$", line, sums.read_text(), flags=re.MULTILINE))

    def pretend_another_machine(self, bundle):
        text = (self.folder / bundle / "machine.json").read_text()
        self.change(bundle, "machine.json", re.sub(r'"model_name": "[^"]*"', '"model_name": "Other"', text))

    def stop(self, seconds, which, *arguments):
        """Sends a signal after so many seconds; the result."""
        with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            try:
                out, err = process.communicate(timeout=seconds)
            except subprocess.TimeoutExpired:
                process.send_signal(which)
                out, err = process.communicate(timeout=PATIENCE)
        return subprocess.CompletedProcess(arguments, process.returncode, out, err)

    def start_and_stop(self, name, *arguments, which=signal.SIGKILL):
        """A run that was stopped when some of its blocks were done, but not all."""
        for _ in range(20):
            code = self.stop_when(lambda: self.block_files(name), which, "run", *arguments, "--quiet", "--checkpoint", 0,
                                  "--out", name)
            if code != FINE:
                break
            shutil.rmtree(self.folder / name)  # it was faster
        self.assertEqual(code, -which if which == signal.SIGKILL else INTERRUPTED)
        self.assertTrue(self.block_files(name))
        self.assert_not_complete(name)

    def stop_when(self, true, which, *arguments):
        with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE) as process:
            deadline = time.monotonic() + PATIENCE
            while not true() and process.poll() is None and time.monotonic() < deadline:
                time.sleep(0.002)
            process.send_signal(which)
            process.communicate(timeout=PATIENCE)
        return process.returncode

    @contextlib.contextmanager
    def at_work(self, name, *arguments):
        """A run without an end that has kept blocks in the bundle."""
        with subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE) as process:
            try:
                deadline = time.monotonic() + PATIENCE
                while not self.block_files(name) and time.monotonic() < deadline:
                    time.sleep(0.01)
                yield
            finally:
                process.kill()
                process.communicate()
