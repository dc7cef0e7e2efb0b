#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Manual pages: what groff says of them, and that they describe every command. Usage: manual_test.py BEZIERBENCH"""
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import INPUT_OUTPUT, ROOT, USAGE, Case  # noqa: E402


def commands_of(program, path=()):
    """The paths of all commands, from the help of each."""
    lines = program(*path, "--help").splitlines()
    yield path
    if "commands" in lines:
        for line in lines[lines.index("commands") + 1:]:
            if not line.startswith("  "):
                break
            if line[2] != " ":
                yield from commands_of(program, (*path, line.split()[0]))


class Manual(Case):
    def setUp(self):
        super().setUp()
        self.fine("manual", "man")
        self.pages = {page.name: page for page in (self.folder / "man").iterdir()}

    def test_every_command_has_a_page(self):
        paths = list(commands_of(self.fine))
        self.assertIn(("curve", "eval"), paths)
        self.assertEqual(sorted(self.pages), sorted("-".join(("bezierbench", *path)) + ".1" for path in paths))
        for path in paths:
            text = self.pages["-".join(("bezierbench", *path)) + ".1"].read_text()
            for line in self.fine(*path, "--help").splitlines():
                if line.startswith("  --"):
                    self.assertIn(line.split()[0].replace("-", "\\-"), text, path)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_no_warning(self):
        for name, page in self.pages.items():
            with self.subTest(page=name):
                result = subprocess.run(["groff", "-ww", "-man", "-Tutf8", "-P-cbou", page], check=True, capture_output=True)
                self.assertEqual(result.stderr, b"")
                self.assertIn(b"EXIT STATUS", result.stdout)

    def test_exit_codes_are_those_of_the_documentation(self):
        documented = (ROOT / "docs/terminal.md").read_text(encoding="utf-8")
        page = self.pages["bezierbench.1"].read_text()
        entries = page[page.index(".SH EXIT STATUS"):page.index(".SH ENVIRONMENT")].split(".TP\n")[1:]
        self.assertEqual(len(entries), 7)
        for entry in entries:
            code, meaning = entry.splitlines()
            self.assertIn(f"| {code.split(chr(34))[1]} | {meaning} |\n", documented)

    def test_where_it_cannot_be_written(self):
        self.refused(USAGE, ["manual"], "folder")
        self.write("file", "")
        self.refused(INPUT_OUTPUT, ["manual", "file"], "file")


if __name__ == "__main__":
    unittest.main()
