# SPDX-License-Identifier: MIT
"""Verdicts of printed cells, counted by table."""

import tempfile
import unittest

from . import fixture, summary
from .bundle import Bundle
from .chapters.printed import MARK, scorecard
from .findings.roster import find_all
from .fixture import scorecards


def _bundle():
    with tempfile.TemporaryDirectory() as place:
        return Bundle(fixture.write(f"{place}/b"))


class Scorecard(unittest.TestCase):
    def counted(self, bundle):
        table = next(block for block in scorecard(bundle, ((), ())) if block.kind == "table")
        head, rows = table.csv()
        return {row[0]: dict(zip(head[1:], row[1:])) for row in rows}

    def test_a_time_of_one_tick_is_counted_as_what_it_is(self):
        rows = scorecards.scorecard_timing()
        few = sum(row["published"] <= 1 for row in rows)
        found = self.counted(_bundle())["Table 2.4"]
        self.assertEqual((found["– untestable"], found["✗ outside"], found["cells"]), (str(few), str(len(rows) - few), str(len(rows))))
        self.assertEqual(self.counted(_bundle())["Table 2.3.1"]["– untestable"], "0")

    def test_the_summary_has_a_column_for_it(self):
        bundle = _bundle()
        head, *lines = summary.text(bundle, find_all(bundle)).splitlines()[1:6]
        self.assertEqual(head.split(), ["table", *MARK, "cells"])
        for line in lines:
            number, *numbers, cells = line.split()
            self.assertEqual(sum(map(int, numbers)), int(cells), number)


if __name__ == "__main__":
    unittest.main()
