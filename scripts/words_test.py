#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Finds turns of phrase that scripts/words.csv says to avoid, in tracked sources, pages and messages.

A phrase is a regular expression for whole words; a line break, with the sign of a comment, counts as a space.
"""
import bisect
import csv
import itertools
import os
import re
import subprocess
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PHRASES = ROOT / "scripts/words.csv"
OURS = {PHRASES, Path(__file__).resolve()}
TEXT = re.compile(r"\.(?:cpp|hpp|h|c|py|md|cmake|in|sh|j2|js|mjs|sbatch|toml)$|(?:^|/)CMakeLists\.txt$|^\.ci/|^scripts/[^.]+$"
                  r"|^experiments/bundle/schema/.*\.json$")
NOT_OURS = re.compile(r"^(?:results|site|report/(?:vendor|atlas|baseline|answers)|reference/published)/")
BREAK = re.compile(r"[ \t]*\n[ \t]*(?:(?://[/!]?<?|#|\*)[ \t]*)?(?=\S)")


def phrases(path=PHRASES):
    """[(pattern, what to write instead)] of the list."""
    with open(path, newline="", encoding="utf-8") as file:
        return [(re.compile(rf"\b(?:{row['avoid']})\b", re.IGNORECASE), row["write"]) for row in csv.DictReader(file)]


def findings(text, known):
    """[(line, phrase, what to write instead)] of a text."""
    breaks = list(BREAK.finditer(text))
    origins = [0, *(one.end() for one in breaks)]  # of the parts between the breaks, in the text
    parts = [text[start:end] for start, end in zip(origins, [*(one.start() for one in breaks), len(text)])]
    starts = list(itertools.accumulate((len(part) + 1 for part in parts), initial=0))  # of the parts, in the joined text

    def line(place):
        part = bisect.bisect_right(starts, place) - 1
        return text.count("\n", 0, origins[part] + place - starts[part]) + 1

    joined = " ".join(parts)
    return sorted((line(match.start()), match[0], write) for pattern, write in known for match in pattern.finditer(joined))


def tracked(root=ROOT):
    """The text files that are written here; without Git, those of the source tree."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=False)
    names = listed.stdout.split("\0") if listed.returncode == 0 else [
        os.path.relpath(os.path.join(folder, name), root) for folder, _, files in os.walk(root) for name in files
        if not os.path.relpath(folder, root).startswith(("build", ".git"))]
    return [name for name in sorted(filter(None, names)) if TEXT.search(name) and not NOT_OURS.search(name)
            and (root / name).is_file() and (root / name).resolve() not in OURS]


class Rules(unittest.TestCase):
    def found(self, text):
        return [(line, phrase) for line, phrase, _ in findings(text, phrases())]

    def test_finds_a_phrase_across_lines_of_a_comment(self):
        self.assertEqual(self.found("// first\n// It is right\n//   enough.\n"), [(2, "right enough")])
        self.assertEqual(self.found('"""One.\n\nIt is no\nfile."""\n'), [(3, "is no")])

    def test_leaves_other_words_alone(self):
        self.assertEqual(self.found("There is no file. It is no longer here. bright enough, least_needed = 1, is_no file\n"), [])

    def test_every_phrase_has_an_alternative(self):
        with open(PHRASES, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertTrue(all(row["avoid"] and row["write"] and row["why"] and None not in row for row in rows))
        self.assertEqual(len({row["avoid"] for row in rows}), len(rows))


class Words(unittest.TestCase):
    def test_files(self):
        """Every tracked file."""
        known = phrases()
        faults = [f"{name}:{line}: '{phrase}'; write: {write}" for name in tracked()
                  for line, phrase, write in findings((ROOT / name).read_text(encoding="utf-8"), known)]
        self.assertFalse(faults, "\n" + "\n".join(faults))


if __name__ == "__main__":
    unittest.main()
