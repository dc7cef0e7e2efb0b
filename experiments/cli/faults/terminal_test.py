#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What a file or its name holds cannot act on the terminal on which it is shown. Usage: terminal_test.py BEZIERBENCH"""
import csv
import hashlib
import shutil
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import Case, INPUT_OUTPUT, ROOT, USAGE  # noqa: E402

# Clears the screen, sets the title, ends lines, goes back, and turns the direction of writing, as UTF-8 and as bytes.
HOSTILE = "\x1b[2J\x1b]0;owned\x07\r\n\x08\x9b31m\u202e\u2028\u200b"
BASELINE = ROOT / "results/baseline"


class Terminal(Case):
    def assert_harmless(self, output, *, lines=True):
        """Printable but for the ends of lines of its own."""
        text = output.decode()  # UTF-8 throughout
        self.assertTrue(all(c.isprintable() or (lines and c == "\n") for c in text), repr(text))
        return text

    def copy(self, name):
        shutil.copytree(BASELINE, self.folder / name)

    def edit(self, bundle, file, change):
        """Applies `change` to the rows of a table, and lists the file as it is then."""
        path = self.folder / bundle / file
        with open(path, newline="", encoding="utf-8") as text:
            table = list(csv.DictReader(text))
        for row in table:
            change(row)
        with open(path, "w", newline="", encoding="utf-8") as text:
            writer = csv.DictWriter(text, table[0].keys(), lineterminator="\n")
            writer.writeheader()
            writer.writerows(table)
        sums = self.folder / bundle / "SHA256SUMS"
        sums.write_text("".join(line if not line.endswith(f"  {file}\n") else
                                f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {file}\n"
                                for line in sums.read_text().splitlines(keepends=True)))

    def test_names_of_files(self):
        name = "n" + HOSTILE.replace("\x9b", "")
        for code, arguments in ((INPUT_OUTPUT, ["verify", name]), (INPUT_OUTPUT, ["compare", name, name]),
                                (USAGE, ["run", name, "--out", "b"]), (USAGE, ["run", self.suite(), "--only", name, "--out", "b"]),
                                (INPUT_OUTPUT, ["curve", "eval", "--curve", name, "--t", "0"]),
                                (USAGE, ["curve", "eval", "--curve", self.write("c.csv", "x\n1\n"), "--t", name]), (USAGE, [name]),
                                (USAGE, ["list", name]), (USAGE, ["run", "--" + name])):
            with self.subTest(arguments=arguments[0]):
                self.refused(code, arguments)
        self.suite()
        result = self.run_program("run", "s.toml", "--out", name, "--dry-run")
        self.assertIn("\\x1b[2J", self.assert_harmless(result.stdout))
        self.assertEqual(len(result.stdout.splitlines()), 6)
        self.bundle("s.toml", name="b")
        (self.folder / "b").rename(self.folder / name)
        self.assertIn("\\x1b[2J", self.assert_harmless(self.run_program("verify", name).stdout))
        again = self.run_program("run", "s.toml", "--out", name)
        self.assertEqual(len(self.assert_harmless(again.stderr).splitlines()), 1)

    def test_fields_of_files(self):
        self.write("c.csv", f'x\n"{HOSTILE}"\n')
        result = self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", "c.csv", "--t", "0"], "c.csv:")
        self.assert_harmless(result.stderr)
        self.write("c.csv", b"x\n\xff\xfe\x9b31m\n")
        self.assertIn("c.csv:2: character \\xff",
                      self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", "c.csv", "--t", "0"]).stderr.decode())
        self.write("s.toml", (self.folder / self.suite()).read_text().replace('"direct"', '"\\u001b[2J\\u202e"'))
        self.refused(USAGE, ["run", "s.toml", "--out", "b"], "s.toml:13:")

    def test_tables_of_bundles(self):
        self.copy("a")
        self.copy("b")
        def hostile(row):
            row["method"] += HOSTILE
        for bundle in ("a", "b"):
            self.edit(bundle, "timing.csv", hostile)
            self.edit(bundle, "accuracy.csv", hostile)
        for arguments in ([], ["--format", "csv"]):
            result = self.run_program("compare", "a", "b", *arguments)
            self.assertEqual((result.returncode, result.stdout), (INPUT_OUTPUT, b""), result.stderr)
            self.assertIn("csv:2: character \\x1b", self.assert_harmless(result.stderr))

    def test_text_of_other_languages_stays(self):
        self.bundle(name="kurven-größe-曲线")
        self.assertEqual(self.fine("verify", "kurven-größe-曲线").splitlines()[0], "kurven-größe-曲线: fine")


if __name__ == "__main__":
    unittest.main()
