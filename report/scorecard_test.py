# SPDX-License-Identifier: MIT
"""Verdicts of printed cells: counted by table, whichever program wrote them."""

import tempfile
import unittest

from . import fixture, summary
from .bundle import Bundle
from .chapters.printed import MARK, scorecard
from .findings.roster import find_all
from .fixture import scorecards


def _bundle(change=None):
    with tempfile.TemporaryDirectory() as place:
        return Bundle(fixture.write(f"{place}/b", change))


def _older(at, row):
    """Programs that know no `untestable` call a time of 0 or 1 ms inside or outside."""
    if at == "scorecard_timing.csv" and row["verdict"] == "untestable":
        row["verdict"] = "inside"


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

    def test_bundles_without_the_verdict_are_read(self):
        found = self.counted(_bundle(_older))["Table 2.4"]
        self.assertEqual(found["– untestable"], "0")
        self.assertNotEqual(found["✓ inside"], "0")

    def test_the_summary_has_a_column_for_it(self):
        bundle = _bundle()
        head, *lines = summary.text(bundle, find_all(bundle)).splitlines()[1:6]
        self.assertEqual(head.split(), ["table", *MARK, "cells"])
        for line in lines:
            number, *numbers, cells = line.split()
            self.assertEqual(sum(map(int, numbers)), int(cells), number)


if __name__ == "__main__":
    unittest.main()
