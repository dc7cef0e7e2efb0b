#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What `cmake --install` installs of the program works there. Usage: install_test.py BEZIERBENCH, in its build folder"""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import ENVIRONMENT, FINE, PROGRAM, ROOT, Case, rows  # noqa: E402

SCRIPTS = Path(__file__).resolve().parent / "completions"


class Installed(Case):
    def setUp(self):
        super().setUp()
        self.prefix = self.folder / "prefix"
        subprocess.run(["cmake", "--install", Path(PROGRAM).parent, "--prefix", self.prefix, "--component", "program"],
                       check=True, stdout=subprocess.DEVNULL, timeout=60)
        self.program = self.prefix / "bin/bezierbench"

    def test_builds_first_what_is_not_built(self):
        """After a build of the program alone, by scripts/reproduce for instance, this stamp is not there."""
        stamp = Path(PROGRAM).parent / "installed.stamp"
        stamp.unlink()
        self.setUp()
        self.assertTrue(stamp.exists())

    def run_installed(self, *arguments, program=None):
        return subprocess.run([program or self.program, *arguments], cwd=self.folder, check=False, capture_output=True,
                              timeout=60)

    def test_places(self):
        share = self.prefix / "share"
        self.assertEqual(sorted(file.name for file in (share / "bezierbench/suites").iterdir()),
                         sorted(file.name for file in (ROOT / "experiments/suites").iterdir()
                                if file.suffix == ".toml" or file.name == "suite.schema.json"))
        for source, place in (("bezierbench.bash", "bash-completion/completions/bezierbench"),
                              ("_bezierbench", "zsh/site-functions/_bezierbench"),
                              ("bezierbench.fish", "fish/vendor_completions.d/bezierbench.fish")):
            self.assertEqual((share / place).read_bytes(), (SCRIPTS / source).read_bytes())

    @unittest.skipUnless(shutil.which("help2man") and shutil.which("groff"), "help2man or groff is not installed")
    def test_manual_page(self):
        """It names every command and every exit code, and groff finds no fault in it."""
        page = self.prefix / "share/man/man1/bezierbench.1"
        result = subprocess.run(["groff", "-ww", "-man", "-Tutf8", "-P-cbou", page], check=True, capture_output=True)
        self.assertEqual(result.stderr, b"")
        text = result.stdout.decode()
        listed = self.fine("--help").partition("Subcommands:\n")[2].split("\n\n")[0]
        names = re.findall(r"^  (\w+)", listed, re.MULTILINE)
        self.assertIn("curve", names)
        for name in names:
            self.assertRegex(text, rf"(?m)^ +{name}\b")
        for code in (0, 1, 2, 3, 4, 130):
            self.assertRegex(text, rf"(?m)^ +{code}  ")

    def test_its_suites_are_those_beside_it(self):
        (self.prefix / "share/bezierbench/suites/report.toml").unlink()
        listed = self.run_installed("list", "suites", "--format", "csv")
        self.assertEqual(listed.returncode, FINE, listed.stderr)
        ids = [row["id"] for row in rows(listed.stdout.decode())]
        self.assertIn("ladder", ids)
        self.assertNotIn("report", ids)

    def test_it_runs_a_suite(self):
        ran = self.run_installed("run", "report", "--trials", "10", "--set", "replicates=2", "--only", "2.3.1-bezier",
                                 "--out", "b")
        self.assertEqual(ran.returncode, FINE, ran.stderr)
        told, following = ran.stderr.decode().splitlines()
        self.assertIn("b: complete", told)
        self.assertEqual(following, f"next: `{self.program} report b`")
        self.assertEqual(self.run_installed("verify", "b").returncode, FINE)
        rendered = self.run_installed("report", "b", "--out", "pages")
        self.assertEqual(rendered.returncode, FINE, rendered.stderr)
        self.assertIn("<html", (self.folder / "pages/report.html").read_text(encoding="utf-8"))

    def test_its_answers_are_those_beside_it(self):
        answers = self.prefix / "share/bezierbench/answers"
        self.assertEqual(self.run_installed("verify", answers).returncode, FINE)
        said = self.run_installed("report", answers, "--summary")
        self.assertEqual((said.returncode, said.stderr), (FINE, b""))
        self.assertEqual(said.stdout, self.run_program("report", ROOT / "results/answers", "--summary").stdout)
        self.write("c.csv", "x,y\n0,0\n1,2\n3,-1\n4,0.5\n")
        chosen = self.run_installed("choose", "--curves", "c.csv")
        self.assertEqual(chosen.returncode, FINE, chosen.stderr)
        (answers / "timing.csv").unlink()  # it reads the times of these
        self.assert_one_line(self.run_installed("choose", "--curves", "c.csv"), f"{answers}/timing.csv")

    def test_called_by_a_link(self):
        (self.folder / "link").symlink_to(self.program)
        self.assertEqual(self.run_installed("list", "suites", program=self.folder / "link").returncode, FINE)

    def test_a_program_without_its_suites_says_so(self):
        alone = self.folder / "alone/bin/bezierbench"
        alone.parent.mkdir(parents=True)
        shutil.copy(self.program, alone)
        self.assertEqual(self.run_installed("list", "methods", program=alone).returncode, FINE)
        for arguments, missing in ((["list", "suites"], "suites"), (["run", "report", "--out", "b"], "suites"), (["report", "b"], "scripts")):
            result = self.run_installed(*arguments, program=alone)
            self.assertEqual(result.returncode, ENVIRONMENT)
            self.assert_one_line(result, f"share/bezierbench/{missing}")


if __name__ == "__main__":
    unittest.main()
