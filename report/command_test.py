# SPDX-License-Identifier: MIT
"""scripts/report as a user meets it: exit codes and one-line messages; nothing in the current folder, in a bundle or in the environment is run."""

import contextlib
import io
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from . import __main__ as command
from . import fixture

ROOT = Path(__file__).resolve().parent.parent


def run(*arguments, **more):
    """scripts/report as a process of its own."""
    environment = {**os.environ, **more.pop("env", {})}
    return subprocess.run([ROOT / "scripts/report", *map(str, arguments)], capture_output=True, text=True, env=environment, check=False, **more)


def of_one_suite(file, row):
    """A page of it has one figure, where that of the whole fixture takes seconds to draw."""
    return not file.startswith("scorecard") and row.get("study", "ladder-").startswith("ladder-")


class Command(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.bundle = fixture.write(self.place / "bundle", of_one_suite)

    def said(self, code, *arguments):
        """(standard output, standard error) of a call that ends with this code; a failure says one line and nothing else."""
        out, error = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
            try:
                found = command.main(list(map(str, arguments)))
            except SystemExit as end:
                found = end.code
        self.assertEqual(found, code, error.getvalue())
        if code:
            self.assertEqual((error.getvalue().count("\n"), out.getvalue()), (1, ""), error.getvalue())
        return out.getvalue(), error.getvalue()

    def fails(self, code, *arguments, says=()):
        _, error = self.said(code, *arguments)
        for word in says:
            self.assertIn(word, error)

    def test_renders_from_anywhere_beside_the_bundle(self):
        done = run("bundle", cwd=self.place)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("report.html", done.stdout)
        out = self.place / "bundle-report"
        self.assertEqual({p.name for p in out.iterdir()}, {"report.html", "report.md", "tables", "figures"})
        for png in out.glob("figures/*.png"):
            self.assertTrue(png.read_bytes().startswith(b"\x89PNG"), png)

    def test_summary_writes_nothing_and_counts(self):
        fixture.write(self.bundle)
        before = sorted(self.place.rglob("*"))
        texts = []
        for columns in 200, 80:
            with mock.patch.dict(os.environ, COLUMNS=str(columns)):
                texts.append(self.said(0, self.bundle, "--summary")[0])
        out, narrow = texts
        self.assertEqual([max(map(len, text.splitlines())) <= 80 for text in texts], [False, True])
        self.assertLessEqual(max(map(len, out.splitlines())), 100)
        self.assertEqual(narrow.split(), out.split())
        self.assertIn("2.3.1", out)
        self.assertIn("vanishes", out)
        self.assertNotIn("`", out)
        self.assertEqual(before, sorted(self.place.rglob("*")))

    def test_a_comparison_becomes_a_chapter(self):
        comparison = fixture.write_comparison(self.place / "comparison")
        self.said(0, self.bundle, "--comparison", comparison, "--out", self.place / "pages")
        self.assertIn("Clang", (self.place / "pages/tables/comparison-1-machines.csv").read_text())
        self.fails(4, self.bundle, "--comparison", self.place, says=("comparison.csv: missing", "bezierbench compare"))

    def test_usage(self):
        for arguments in ((), ("--wrong",), (self.bundle, "--out"), (self.bundle, "--out", self.bundle),
                          (self.bundle, "--summary", "--out", "x"), (self.bundle, "second")):
            self.fails(2, *arguments, says=("usage",) if "--out" not in arguments[1:2] else ())

    def test_missing_packages(self):
        for name in ("matplotlib", "jinja2"):
            with mock.patch.object(command.importlib.util, "find_spec", lambda module, name=name: None if module == name else module):
                self.fails(3, self.bundle, "--out", self.place / "out", says=("python3-matplotlib", "python3-jinja2"))
        self.assertFalse((self.place / "out").exists())

    def test_what_is_malformed_or_not_as_it_was_written_is_refused(self):
        """The package's reader, whose tests have the rest, and the columns of the report."""
        whole = fixture.write(self.bundle)
        for name, old, new, sealed, says in (
                ("bundle.json", "{", "[", True, "bundle.json:1"),
                ("bundle.json", '"schema_version": 3', '"schema_version": 9', True, "schema_version"),
                ("accuracy.csv", "mean_error,", "mean_eror,", True, "mean_error"),
                ("accuracy.csv", "9e-11", "nine", True, "accuracy.csv:2"),
                ("audit.csv", "1.25", "0x1.4p+0", True, None),
                ("audit.csv", "1.25", "\x1b[2J" + "9" * 100_000 + "x", True, r"\x1b[2J999"),
                ("scorecard.csv", "inside", "outside", False, "scorecard.csv: is not what SHA256SUMS lists")):
            with self.subTest(name=name, new=new[:20]):
                good = (whole / name).read_text()
                self.assertIn(old, good)
                (whole / name).write_text(good.replace(old, new, 1))
                if sealed:
                    fixture.seal(whole)
                _, error = self.said(4 if says else 0, whole, "--summary")
                self.assertIn(says or "", error)
                self.assertLess(len(error), 500)
                (whole / name).write_text(good)
                fixture.seal(whole)
        for name in ("audit.csv", "suite.toml", "SHA256SUMS"):
            (whole / name).rename(self.place / name)
            self.fails(4, whole, "--summary", says=(f"{name}: is missing",))
            (self.place / name).rename(whole / name)
        (whole / "extra.csv").write_text("study\nx\n")
        self.fails(4, whole, "--summary", says=("extra.csv: is not in SHA256SUMS",))

    def test_not_a_bundle_and_no_place(self):
        self.fails(4, self.place / "nowhere", says=("nowhere",))
        self.fails(4, self.place, "--summary", says=("bundle.json",))
        (self.place / "file").write_text("in the way")
        self.fails(4, self.bundle, "--out", self.place / "file", says=("file", "--out"))


TRAPPED = "import pathlib\npathlib.Path(__file__).with_suffix('.trapped').touch()\n"
TRAPS = ("report", "tomllib", "csv", "json", "argparse", "matplotlib", "jinja2", "sitecustomize", "usercustomize")


def _lay_traps(folder):
    """Modules that say so when they run, and settings that would change every figure."""
    for name in TRAPS:
        (folder / f"{name}.py").write_text(TRAPPED)
    (folder / "matplotlibrc").write_text("font.size: 40\nno such key: 1\n")


class Isolation(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def render(self, bundle, **more):
        done = run(bundle, "--out", self.place / "out", **more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rendered = {str(path.relative_to(self.place)): path.read_bytes() for path in (self.place / "out").rglob("*") if path.is_file()}
        shutil.rmtree(self.place / "out")
        return rendered

    def test_the_current_folder_and_the_environment_run_nothing(self):
        bundle = fixture.write(self.place / "bundle", of_one_suite)
        plain = self.render(bundle, cwd=self.place)
        _lay_traps(bundle)
        trapped = self.render(bundle, cwd=bundle, env={"PYTHONPATH": f":.:{bundle}"})
        self.assertEqual([p.name for p in bundle.glob("*.trapped")], [])
        self.assertEqual(trapped, plain)

    def test_every_script_starts_python_isolated(self):
        """A file run by its path has its own folder first on the module path; -c, -m and standard input have the current one."""
        starts = re.compile(r"(?:python3?\b\"?|_PYTHON\}|_EXECUTABLE\})\s+(-[\w-]*|\")")
        texts = [path for folder in ("scripts", "report", "experiments", "core", "cmake", ".ci") for path in (ROOT / folder).rglob("*")
                 if path.is_file() and (path.name == "CMakeLists.txt" or path.suffix in (".cmake", ".sbatch", ""))]
        self.assertGreater(len(texts), 20)
        loose, found = [], 0
        for path in texts:
            for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                for start in starts.finditer(line):
                    found += 1
                    if not re.fullmatch(r"-I|-[BEs]*E[BEs]*", start[1]):
                        loose.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
        self.assertGreater(found, 8)
        self.assertEqual(loose, [])


if __name__ == "__main__":
    unittest.main()
