#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What `run` says on a terminal, and in a file, and shipped suites. Usage: progress_test.py BEZIERBENCH"""
import os
import pty
import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINE, PATIENCE, PROGRAM, ROOT, STUDY, TIMING, USAGE, Case, rows  # noqa: E402

SHORT_TIMING = {**TIMING, "methods": '["direct", "de_casteljau"]', "modes": '["point"]'}
QUICK = ["--trials", "10", "--set", "replicates=2", "--only", "2.3.1-*", "--no-timing"]


class Terminal(Case):
    def on_terminal(self, *arguments, **environment):
        """Exit code, and all that the program writes with all its streams on a terminal of 80 columns."""
        parent, child = pty.openpty()
        subprocess.run(["stty", "cols", "80"], stdin=child, check=True)
        kept = {key: text for key, text in os.environ.items() if key not in ("NO_COLOR", "COLUMNS")}
        with subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=child, stdout=child, stderr=child,
                              env={**kept, "TERM": "xterm", **environment}) as process:
            os.close(child)
            written = b""
            while True:
                try:
                    piece = os.read(parent, 65536)
                except OSError:  # the other end is closed
                    break
                if not piece:
                    break
                written += piece
            code = process.wait(PATIENCE)
        os.close(parent)
        return code, written.decode()

    def test_progress_is_rewritten_and_fits(self):
        suite = self.suite({**STUDY, "id": '"' + "long" * 20 + '"', "trials": "3000000"})
        code, text = self.on_terminal("run", suite, "--out", "b", "--jobs", "1")
        self.assertEqual(code, FINE, text)
        lines = re.findall(r"\r([^\r\n\x1b]*)\x1b\[K", text)
        told = [line for line in lines if line]
        self.assertTrue(told, text)
        for line in told:
            self.assertRegex(line, r"^ *\d+ %, about .* left, long")
            self.assertLess(len(line), 80)
        self.assertEqual(lines[-1], "")  # it is gone at the end
        self.assertRegex(text, r"b: complete in .*: 1 cell, no bound violated\r\nnext: ")

    def test_colours(self):
        for arguments in (["list", "suites"], ["rnu"], []):
            with self.subTest(arguments=arguments):
                coloured = self.on_terminal(*arguments)[1]
                self.assertIn("\x1b[", coloured)
                plain = self.on_terminal(*arguments, NO_COLOR="1")[1]
                self.assertNotIn("\x1b", plain)
                self.assertEqual(re.sub(r"\x1b\[[0-9;]*m", "", coloured), plain)
                self.assertNotIn("\x1b", self.on_terminal(*arguments, TERM="dumb")[1])
                piped = self.run_program(*arguments)
                self.assertNotIn(b"\x1b", piped.stdout + piped.stderr)

    def test_lists_fit(self):
        for topic in ("suites", "studies", "methods", "generators"):
            wide = self.fine("list", topic)
            with self.subTest(topic=topic):
                code, text = self.on_terminal("list", topic, NO_COLOR="1")
                self.assertEqual(code, FINE)
                self.assertLessEqual(max(map(len, text.splitlines())), 80)
                words = set(text.replace(";", "").split())
                self.assertEqual([word for line in wide.splitlines()[1:] for word in line.replace(";", "").split()
                                  if word not in words], [])
                narrow = self.fine("list", topic, env={**os.environ, "COLUMNS": "100"})
                self.assertLessEqual(max(map(len, narrow.splitlines())), 100)
                self.assertEqual(self.fine("list", topic, "--format", "csv", env={**os.environ, "COLUMNS": "40"}),
                                 self.fine("list", topic, "--format", "csv"))

    def test_help_fits(self):
        def commands(words):
            yield [*words, "--help"]
            for line in self.fine("complete", *words, "").splitlines():
                if "\t" in line:  # values of arguments have no meaning
                    yield from commands([*words, line.split("\t")[0]])
        every = list(commands([]))
        self.assertGreater(len(every), 35)
        for arguments in every:
            for columns in (60, 80, 120):
                lines = self.fine(*arguments, env={**os.environ, "COLUMNS": str(columns)}).splitlines()
                self.assertGreater(len(lines), 3)
                self.assertEqual([line for line in lines if len(line) > columns], [], arguments)

    def test_errors_are_broken_at_words_on_a_terminal_only(self):
        bundle = ROOT / "results/answers"
        for arguments in (["choose", bundle, "--degree", "4", "--tolerance", "5"], ["list", "kinds", "no_kind"],
                          ["run", "no_suite", "--out", "b"], ["verify", "no_bundle"], ["list", "methods", "--guarantee", "x"],
                          ["choose", bundle, "--degree", "4", "--tolerance", "5", "--unit", "metres"]):
            with self.subTest(arguments=arguments):
                code, text = self.on_terminal(*map(str, arguments), NO_COLOR="1")
                piped = self.run_program(*arguments, env={**os.environ, "COLUMNS": "80"})
                self.assertEqual(code, piped.returncode)
                self.assert_one_line(piped)
                message = piped.stderr.decode()
                self.assertEqual(text.split(), message.split())
                whole = [piece.strip("\n") for piece in re.findall("`.*?`", message)]  # can be pasted
                for line in text.splitlines():
                    self.assertTrue(len(line) <= 80 or line.strip().strip(";") in (*whole, *message.split()), line)
                for command in whole:
                    self.assertIn(command, text)

    def test_choose_fits_and_has_a_line_for_each_method(self):
        for unit, tolerance in (("u", "20"), ("coordinate", "1e-15")):
            asked = ["choose", str(ROOT / "results/answers"), "--degree", "3", "--tolerance", tolerance, "--unit", unit]
            code, text = self.on_terminal(*asked, NO_COLOR="1")
            methods = [row["method"] for row in rows(self.run_program(*asked, "--format", "csv").stdout.decode())]
            lines = text.splitlines()
            self.assertEqual(code, FINE)
            self.assertLessEqual(max(map(len, lines)), 80)
            table = lines[next(at for at, line in enumerate(lines) if line.startswith("  method")) + 1:]
            self.assertEqual([line[2:].split()[0] for line in table], methods)


class WithoutWords(Case):
    def test_five_lines(self):
        lines = self.fine().splitlines()
        self.assertEqual(len(lines), 5)
        for line in lines:
            self.assertLessEqual(len(line), 80)
            self.assertTrue(line.startswith("bezierbench "), line)

    def test_what_it_says_works(self):
        self.write("c.csv", "x,y\n0,0\n1,1\n")
        commands = [re.split(r"  +", line)[0].split()[1:] for line in self.fine().splitlines()]
        for words in commands:
            with self.subTest(words=words):
                if words[0] == "run":
                    words.append("--dry-run")
                    words[words.index("b")] = "other"
                self.assertTrue(self.fine(*(ROOT / "results/baseline" if word == "b" else word for word in words)))


class ShippedSuites(Case):
    def test_by_id(self):
        self.bundle("report", *QUICK, name="id")
        self.bundle(ROOT / "experiments/suites/report.toml", *QUICK, name="file")
        self.assertEqual(self.manifest("id"), self.manifest("file"))

    def test_file_names_are_ids(self):
        for file in (ROOT / "experiments/suites").glob("*.toml"):
            self.assertIn(f'\nid = "{file.stem}"\n', file.read_text(encoding="utf-8"))

    def test_words(self):
        self.refused(USAGE, ["run", "reprot", "--out", "b"], 'reprot: ', 'did you mean "report"?')
        self.write("report", "")  # a file in the way changes nothing
        self.refused(USAGE, ["run", "./report", "--out", "b"], "./report:")
        self.assertIn("cells", self.fine("run", "report", "--out", "b", "--dry-run", *QUICK))


class Progress(Case):
    def test_the_end_of_a_run(self):
        result = self.run_program("run", self.suite({**STUDY, "degree": "[3, 4]"}, SHORT_TIMING), "--out", "b")
        self.assertEqual((result.returncode, result.stdout), (FINE, b""))
        told, following = result.stderr.decode().splitlines()
        self.assertRegex(told, r"^b: complete in .* s: 3 cells, no bound violated, \d+ times, the intervals of their ratios \S+ % wide in the median$")
        self.assertTrue(following.startswith("next: "), following)
        command = following.removeprefix("next: ").strip("`")
        done = subprocess.run(f"{command} --summary", shell=True, cwd=self.folder, check=False, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (FINE, b""))

if __name__ == "__main__":
    unittest.main()
