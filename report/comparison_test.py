# SPDX-License-Identifier: MIT
"""The chapter of a comparison: machine first, what differs, every ratio with its verdict and its doubts."""

import tempfile
import unittest
from pathlib import Path

from . import fixture
from .bundle import Bundle, BundleError, Missing
from .chapters import provenance
from .document import Table
from .fixture.comparison import ACCURACY, FACTS, SENTINEL, TIME, write_comparison

class Chapter(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.bundle = fixture.write(self.place / "bundle")

    def write(self, rows, facts=()):
        return write_comparison(self.place / "comparison", rows, facts)

    def blocks(self, rows, facts=()):
        return list(provenance.comparison(Bundle(self.bundle, self.write(rows, facts)), ()))

    def words(self, *arguments):
        return [block.text for block in self.blocks(*arguments) if block.kind == "text"]

    def table(self, table_id, *arguments):
        return next(b for b in self.blocks(*arguments) if isinstance(b, Table) and b.id == table_id)

    def test_without_a_comparison_it_is_left_out(self):
        with self.assertRaises(Missing):
            list(provenance.comparison(Bundle(self.bundle), ()))

    def test_machines_come_first(self):
        blocks = self.blocks([ACCURACY, TIME], FACTS)
        self.assertEqual([b.id for b in blocks if b.kind == "table"],
                         ["comparison-1-machines", "comparison-1-times-t", "comparison-standings"])
        self.assertEqual(blocks[1].csv()[1], [["build.compiler", "GNU 12.2.0", "Clang 14.0.6"]])
        self.assertIn("Machines and builds do not differ", self.words([ACCURACY])[1])

    def test_accuracy(self):
        self.assertIn("identical, bit for bit, in all 2 common rows", self.words([ACCURACY, ACCURACY])[2])
        other = {**ACCURACY, "b": "2e-10", "verdict": "different"}
        self.assertIn("**differs** in 1 of 2 common rows", self.words([ACCURACY, other])[2])
        rows = self.table("comparison-1-accuracy", [ACCURACY, other]).csv()[1]
        self.assertEqual(rows, [["s", "direct", "4", "accuracy.csv", "max_error", "1e-10", "2e-10"]])
        status = {**other, "column": "status", "a": "ok", "b": "degree_unsupported"}
        self.assertEqual(self.table("comparison-1-accuracy", [status]).csv()[1][0][-1], "degree_unsupported")

    def test_times_with_their_verdicts(self):
        table = self.table("comparison-1-times-t", [TIME, SENTINEL])
        self.assertEqual([group.key for group in table.groups], ["direct"])
        self.assertEqual([(label, [cell.text for cell in cells]) for label, cells in table.groups[0].rows],
                         [("point", ["1.100 [1.090 – 1.120] slower"]), ("point, in sentinels", ["1.001 [0.995 – 1.005]"])])

    def test_standings(self):
        table = self.table("comparison-standings", [TIME])
        self.assertEqual([row[0] for row in table.csv()[1]], ["a", "x/b"])
        self.assertEqual([[cell.text for cell in group.rows[0][1]][-2:] for group in table.groups], [["1.000", "1.000"], ["1.100", ""]])

    def test_what_is_no_comparison_is_refused(self):
        with self.assertRaisesRegex(BundleError, "nowhere: no such directory"):
            Bundle(self.bundle, self.place / "nowhere")
        folder = self.write([TIME])
        (folder / "facts.csv").unlink()
        with self.assertRaisesRegex(BundleError, "facts.csv: missing; write it again with `bezierbench compare"):
            Bundle(self.bundle, folder)


if __name__ == "__main__":
    unittest.main()
