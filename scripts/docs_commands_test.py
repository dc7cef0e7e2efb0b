#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/docs_commands.py finds what a page shows and the program does not do."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts import docs_commands  # noqa: E402

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
        page.check_links()
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

    def test_links_lead_somewhere(self):
        self.assertEqual(self.page("[a](page.md), [b](page.md#b), [c](https://example.org)\n")[0].faults, [])
        self.assertEqual(len(self.page("[a](nothing.md)\n")[0].faults), 1)

    def test_the_answer_is_short(self):
        self.assertLessEqual(len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()), 120)
        for name in ("reproduce", "choose", "change", "compare"):  # the four tasks, none with more than five commands
            path = ROOT / "docs" / f"{name}.md"
            if path.exists():
                blocks = [match[2] for match in docs_commands.BLOCK.finditer(path.read_text(encoding="utf-8")) if match[1] == "console"]
                self.assertIn(sum(len(docs_commands.transcript(block)) for block in blocks), range(1, 6), name)


if __name__ == "__main__":
    unittest.main()
