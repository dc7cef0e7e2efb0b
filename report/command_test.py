# SPDX-License-Identifier: MIT
"""scripts/report as a user meets it: exit codes and one-line messages; nothing in the current folder, in a bundle or in the environment is run."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from . import fixture
from .fixture.comparison import write_comparison

ROOT = Path(__file__).resolve().parent.parent


def run(*arguments, command=(ROOT / "scripts/report",), **more):
    environment = {**os.environ, **more.pop("env", {})}
    return subprocess.run([*command, *map(str, arguments)], capture_output=True, text=True, env=environment, check=False, **more)


def of_one_suite(file, row):
    """A page of it has one figure, where that of the whole fixture takes seconds to draw."""
    return not file.startswith("scorecard") and row.get("study", "ladder-").startswith("ladder-")


class Command(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.bundle = fixture.write(self.place / "bundle")

    def fails(self, code, *arguments, says=(), **more):
        done = run(*arguments, **more)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(done.stdout, "")
        for word in says:
            self.assertIn(word, done.stderr)

    def test_renders_from_anywhere_beside_the_bundle(self):
        fixture.write(self.bundle, of_one_suite)
        done = run("bundle", cwd=self.place)
        self.assertEqual(done.returncode, 0, done.stderr)
        out = self.place / "bundle-report"
        self.assertIn("report.html", done.stdout)
        self.assertEqual({p.name for p in out.iterdir()}, {"report.html", "report.md", "tables", "figures"})

    def test_summary_writes_nothing_and_counts(self):
        before = sorted(self.place.rglob("*"))
        done = run(self.bundle, "--summary")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2.3.1", done.stdout)
        self.assertIn("vanishes", done.stdout)
        self.assertNotIn("`", done.stdout)
        self.assertEqual(before, sorted(self.place.rglob("*")))

    def test_a_comparison_becomes_a_chapter(self):
        fixture.write(self.bundle, of_one_suite)
        comparison = write_comparison(self.place / "comparison")
        done = run(self.bundle, "--comparison", comparison, "--out", self.place / "pages")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Clang", (self.place / "pages/tables/comparison-1-machines.csv").read_text())
        self.fails(4, self.bundle, "--comparison", self.place, says=("comparison.csv: missing", "bezierbench compare"))

    def test_usage(self):
        for arguments in ((), ("--wrong",), (self.bundle, "--out"), (self.bundle, "--out", self.bundle),
                          (self.bundle, "--summary", "--out", "x"), (self.bundle, "second")):
            self.fails(2, *arguments, says=("usage",) if "--out" not in arguments[1:2] else ())

    def test_missing_packages(self):
        for name in ("matplotlib", "jinja2"):
            blind = (f"import sys; sys.modules[{name!r}] = None; sys.path.append({str(ROOT)!r}); "
                     "from report.__main__ import main; sys.exit(main())")
            self.fails(3, self.bundle, "--out", self.place / "out", command=(sys.executable, "-I", "-B", "-c", blind),
                       says=("python3-matplotlib", "python3-jinja2"))
        self.assertFalse((self.place / "out").exists())

    def test_malformed_bundles(self):
        def spoil(name, old, new):
            path = self.bundle / name
            text = path.read_text()
            self.assertIn(old, text)
            path.write_text(text.replace(old, new, 1))
            fixture.seal(self.bundle)
        for name, old, new, says in (
                ("bundle.json", "{", "[", "bundle.json:1"),
                ("bundle.json", '"schema_version": 3', '"schema_version": 9', "schema_version"),
                ("accuracy.csv", "mean_error,", "mean_eror,", "mean_error"),
                ("accuracy.csv", "9e-11", "nine", "accuracy.csv:2"),
                ("scorecard.csv", "inside,,0.1\n", "inside,,0.1,\n", "scorecard.csv:2"),
                ("timing.csv", "study", "\0", "NUL"),
                ("methods.csv", "gamma_3n p~", '"gamma_3n', "methods.csv")):
            with self.subTest(name=name, new=new):
                path = self.bundle / name
                good = path.read_text()
                spoil(name, old, new)
                self.fails(4, self.bundle, "--out", self.place / "out", says=(says,))
                self.assertFalse((self.place / "out").exists())
                path.write_text(good)
        (self.bundle / "audit.csv").write_bytes(b"study\xff\n")
        fixture.seal(self.bundle)
        self.fails(4, self.bundle, "--summary", says=("audit.csv", "UTF-8"))
        (self.bundle / "audit.csv").write_bytes(b"")
        fixture.seal(self.bundle)
        self.fails(4, self.bundle, "--summary", says=("audit.csv:1",))

    def test_what_is_not_as_it_was_written_is_refused(self):
        sums = (self.bundle / "SHA256SUMS").read_text()
        other = (self.bundle / "scorecard.csv").read_text().replace("inside", "outside", 1)
        for name, data, words in (("scorecard.csv", other, "scorecard.csv: is not what SHA256SUMS lists"), ("audit.csv", None, "audit.csv: is missing"),
                                  ("suite.toml", None, "suite.toml: is missing"), ("extra.csv", "study\nx\n", "extra.csv: is not in SHA256SUMS"),
                                  ("SHA256SUMS", None, "SHA256SUMS: is missing"), ("SHA256SUMS", "x\n", "SHA256SUMS:1: is not a line of sha256sum"),
                                  ("SHA256SUMS", sums + f"{'0' * 64}  ../x\n", "is not a line of sha256sum")):
            with self.subTest(name=name, words=words):
                path = self.bundle / name
                before = path.read_text() if path.exists() else None
                path.unlink() if data is None else path.write_text(data)
                self.fails(4, self.bundle, "--summary", says=(words,))
                path.unlink(missing_ok=True) if before is None else path.write_text(before)

    def test_no_link_is_followed(self):
        path = self.bundle / "audit.csv"
        path.rename(self.place / "outside.csv")
        path.symlink_to(self.place / "outside.csv")
        self.fails(4, self.bundle, "--summary", says=("audit.csv: is a link",))

    def test_a_message_repeats_the_beginning_of_a_field_only(self):
        path = self.bundle / "audit.csv"
        path.write_text(path.read_text().replace("1.25", "\x1b[2J" + "9" * 100_000 + "x"))
        fixture.seal(self.bundle)
        done = run(self.bundle, "--summary")
        self.assertEqual(done.returncode, 4)
        self.assertLess(len(done.stderr), 500)
        self.assertIn(r"\x1b[2J999", done.stderr)

    def test_not_a_bundle(self):
        self.fails(4, self.place / "nowhere", says=("nowhere",))
        self.fails(4, self.place, "--summary", says=("bundle.json",))

    def test_unwritable_place(self):
        fixture.write(self.bundle, of_one_suite)
        (self.place / "file").write_text("in the way")
        self.fails(4, self.bundle, "--out", self.place / "file", says=("file", "--out"))

    def test_reads_hexadecimal_numbers(self):
        path = self.bundle / "audit.csv"
        path.write_text(path.read_text().replace("1.25", "0x1.4p+0"))
        fixture.seal(self.bundle)
        self.assertEqual(run(self.bundle, "--summary").returncode, 0)


TRAPPED = "import pathlib\npathlib.Path(__file__).with_suffix('.trapped').touch()\n"
TRAPS = ("report", "tomllib", "csv", "json", "argparse", "matplotlib", "jinja2", "sitecustomize", "usercustomize", "isolated")


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

    def files(self, folder):
        return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def render(self, bundle, **more):
        done = run(bundle, "--out", self.place / "out", **more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rendered = self.files(self.place / "out")
        shutil.rmtree(self.place / "out")
        return rendered

    def test_the_current_folder_and_the_environment_run_nothing(self):
        bundle = fixture.write(self.place / "bundle", without=[f for f in fixture.FILES if f != "scorecard.csv"])
        plain = self.render(bundle, cwd=self.place)
        _lay_traps(bundle)
        trapped = self.render(bundle, cwd=bundle, env={"PYTHONPATH": f":.:{bundle}"})
        self.assertEqual([p.name for p in bundle.glob("*.trapped")], [])
        self.assertEqual(trapped, plain)

    def test_every_script_starts_python_isolated(self):
        """A file run by its path has its own folder first on the module path; -c, -m and standard input have the current one."""
        starts = re.compile(r"(?:python3?\b\"?|_PYTHON\}|_EXECUTABLE\})\s+(-\S*|\")")
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
