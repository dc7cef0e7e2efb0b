#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What runs the pages of docs finds what they show and the program does not do: docs_commands.py, readme.py, snippets_test.py."""
import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts import docs_commands, readme, snippets_test  # noqa: E402

PROGRAM = "#!/bin/sh\necho \"said $1\"\n[ \"$1\" != fail ] || exit 2\n"


class Commands(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.program = self.place / "program"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)

    def page(self, text):
        path = self.place / "page.md"
        path.write_text(text, encoding="utf-8")
        page = docs_commands.Page(path, self.program)
        page.fault = lambda at, what: page.faults.append(what)
        page.said = lambda skipped: self.skipped.extend(skipped.splitlines())
        self.skipped = []
        return page, page.run()

    def test_what_is_printed_is_compared(self):
        page, text = self.page("```console\n$ build/release/bezierbench list\nsaid list\n```\n")
        self.assertEqual((page.faults, text), ([], page.text))
        page, text = self.page("```console\n$ build/release/bezierbench list\nsaid lists\n```\n")
        self.assertEqual(len(page.faults), 1)
        self.assertEqual(text, "```console\n$ build/release/bezierbench list\nsaid list\n```\n")

    def test_numbers_of_a_measurement_may_differ_but_nothing_else(self):
        command = "$ build/release/bezierbench check; echo took"
        page, _ = self.page(f"```console\n{command} 12.5 ns, same\nsaid check\ntook 3 ns, slower\n```\n")
        self.assertEqual(page.faults, [])
        page, _ = self.page(f"```console\n{command} 12.5 ns\nsaid check\ntook 3 ms\n```\n")
        self.assertEqual(len(page.faults), 1)

    def test_a_script_must_succeed(self):
        self.assertEqual(self.page("```sh\nbuild/release/bezierbench list\n```\n")[0].faults, [])
        self.assertEqual(len(self.page("```sh\nbuild/release/bezierbench fail | cat\n```\n")[0].faults), 1)
        self.assertEqual(len(self.page("```sh\nscripts/nothing\n```\n")[0].faults), 1)

    def test_slow_scripts_are_there_and_said(self):
        page, text = self.page("```console\n$ scripts/test -j 2\nwhat it printed\n$ scripts/check golden\n```\n")
        self.assertEqual((page.faults, text), ([], page.text))
        self.assertEqual(self.skipped, ["skipped: scripts/test -j 2", "skipped: scripts/check golden"])
        self.assertEqual(len(self.page("```sh\nscripts/check nothing\n```\n")[0].faults), 1)

    def test_the_answer_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()), 120)
        for name in ("reproduce", "choose", "change", "compare"):  # the four tasks, none with more than five commands
            path = ROOT / "docs" / f"{name}.md"
            if path.exists():
                blocks = [match[2] for match in docs_commands.BLOCK.finditer(path.read_text(encoding="utf-8")) if match[1] == "console"]
                self.assertIn(sum(len(docs_commands.transcript(block)) for block in blocks), range(1, 6), name)


PAGE = "| id | cost |\n|---|---|\n| `direct` | 3 |\n| [`speed`](a.toml) | 55 |\n"


class Compared(unittest.TestCase):
    """A page may be without what was added to the program; any other difference is a fault."""

    def said(self, wanted):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            return readme.compare(ROOT / "README.md", PAGE, wanted), out.getvalue()

    def test_what_is_added_is_said_and_no_fault(self):
        for line in ("| `horner` | 2 |\n", "| [`tryout`](b.toml) | 1 |\n"):
            fault, said = self.said(PAGE + line)
            self.assertIsNone(fault)
            self.assertIn(f"without {line.split('`')[1]}", said)

    def test_anything_else_is_a_fault(self):
        for wanted in (PAGE.replace("55", "56"), PAGE.replace("| `direct` | 3 |\n", ""), PAGE + "a sentence\n"):
            fault, said = self.said(wanted)
            self.assertIn("README.md:", fault)
            self.assertEqual(said, "")


PRINTS = '```cpp\n// one.cpp\n#include <cstdio>\nint main() { std::puts("1 of 3"); }\n```\n'


class Snippets(unittest.TestCase):
    def complaints(self, text):
        with tempfile.TemporaryDirectory() as place:
            root = Path(place)
            (root / "lib/pkgconfig").mkdir(parents=True)
            for name in ("bezierbench-methods", "bezierbench-c"):
                (root / f"lib/pkgconfig/{name}.pc").write_text("Name: n\nDescription: d\nVersion: 1\nCflags: -DFLAG=1\n")
            page = root / "page.md"
            page.write_text(text, encoding="utf-8")
            return snippets_test.check_page(page, root)[0]

    def assert_wrong(self, text, words):
        complaints = self.complaints(text)
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn(words, complaints[0])

    def test_right_snippets(self):
        self.assertEqual(self.complaints(PRINTS + "```text\n1 of 3\n```\n"), [])
        self.assertEqual(self.complaints(PRINTS + "\n```text\n1 of ...\n```\n"), [])
        self.assertEqual(self.complaints("```cpp\nint f() { return FLAG; }\n```\n"), [])
        self.assertEqual(self.complaints("```c\nint f(void) { return FLAG; }\n```\n"), [])
        self.assertEqual(self.complaints("```python\nprint(2)\n```\n```text\n2\n```\n"), [])
        self.assertEqual(self.complaints("```sh\nexit 1\n```\n"), [])

    def test_a_project_takes_the_files_that_were_named(self):
        project = "```cmake\ncmake_minimum_required(VERSION 3.22)\nproject(p CXX)\nadd_executable(p one.cpp)\n```\n"
        self.assertEqual(self.complaints(PRINTS + "```text\n1 of 3\n```\n" + project), [])
        self.assert_wrong(project, "one.cpp")

    def test_wrong_snippets(self):
        self.assert_wrong("```cpp\nint f() { return nothing; }\n```\n", "nothing")
        self.assert_wrong("```cpp\nint f(int x) { return 1; }\n```\n", "unused")  # warnings are errors
        self.assert_wrong("```python\nraise SystemExit(3)\n```\n", "ends with 3")
        self.assert_wrong(PRINTS, "no block shows")
        self.assert_wrong(PRINTS + "```text\n2 of 3\n```\n", "where the page shows")
        self.assert_wrong(PRINTS + "words between\n```text\n1 of 3\n```\n", "no block shows")


if __name__ == "__main__":
    unittest.main()
