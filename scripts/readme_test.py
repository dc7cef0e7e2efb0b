#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/readme.py: a page may be without what was added to the program; any other difference is a fault."""
import contextlib
import io
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts import readme  # noqa: E402

PAGE = "| id | cost |\n|---|---|\n| `direct` | 3 |\n| [`speed`](a.toml) | 55 |\n"


class Compared(unittest.TestCase):
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


if __name__ == "__main__":
    unittest.main()
