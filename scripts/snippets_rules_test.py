#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""snippets_test.py runs right snippets and complains about wrong ones of each kind."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import snippets_test  # noqa: E402

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
