# SPDX-License-Identifier: MIT
"""Times stand in the chapter of the problem that was solved, in tables that say what they are of."""

import tempfile
import unittest

from . import fixture
from .bundle import Bundle
from .chapters.parts import ROSTER
from .findings.roster import find_all
from .fixture.times import COMPANIONS

CHAPTERS = {**{one.suite: one for one in ROSTER}, "evaluation": next(one for one in ROSTER if one.id == "timing")}
PROBLEMS = ("derivative", "arc_length", "inverse_arc_length", "projection", "interpolation", "fitting", "subdivision", "grid", "bspline", "bounds", "evaluation")


def _blocks(change=None, problems=PROBLEMS):
    """({problem: blocks of its chapter}, findings)"""
    with tempfile.TemporaryDirectory() as place:
        bundle = Bundle(fixture.write(f"{place}/b", change))
        found = find_all(bundle)
        return {problem: list(CHAPTERS[problem].blocks(bundle, found)) for problem in problems}, found[0]


def _tables(blocks):
    return {b.id: b for b in blocks if b.kind == "table" and b.id.startswith("timing-")}


class Times(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.blocks, cls.found = _blocks()
        cls.tables = {problem: _tables(blocks) for problem, blocks in cls.blocks.items()}

    def test_stand_in_the_chapter_of_their_problem(self):
        for problem, study, methods, _ in COMPANIONS:
            self.assertEqual({g.key for g in self.tables[problem][f"timing-{study}"].groups}, set(methods), study)
        self.assertEqual(set(self.tables["evaluation"]), {"timing-2.4-bezier", "timing-peers-speed"})
        self.assertEqual(sum(map(len, self.tables.values())), len(COMPANIONS) + 2)

    def test_findings_are_shown_once_in_the_chapter_of_their_problem(self):
        for f in self.found:
            if f.suite.startswith("companion_"):
                shown = [problem for problem, blocks in self.blocks.items() for b in blocks if b.kind == "finding" and b.id == f.id]
                self.assertEqual(shown, [f.id.split("_time")[0]], f.id)

    def test_tables_say_what_of_and_what_was_asked(self):
        table = self.tables["fitting"]["timing-companion_speed-fitting"]
        self.assertEqual(table.caption, 'Time over that of `schneider`, and about how many microseconds per fit: Fits to "points" (double, 2 axes)')
        lines = {(g.key, label): cells for g in table.groups for label, cells in g.rows}
        self.assertEqual(set(lines), {(m, data) for m in ("schneider", "gauss_newton") for data in ("samples", "noisy")})
        self.assertEqual((table.axis, table.head), ("tolerance", ("1e-6", "0.01")))
        self.assertEqual([(c.text, c.raw) for c in lines["schneider", "noisy"]], [("1, 20", "20000")] * 2)
        self.assertRegex(lines["gauss_newton", "noisy"][0].text, r"^\S+ \[\S+ – \S+\], \S+$")
        derivatives = self.tables["derivative"]["timing-companion_speed-derivative"]
        self.assertEqual([label for label, _ in derivatives.groups[0].rows], ["order 1", "order 2"])
        self.assertTrue(derivatives.caption.startswith("Time over that of `"))

    def test_captions_are_unique(self):
        captions = [table.caption for tables in self.tables.values() for table in tables.values()]
        self.assertEqual(len(captions), len(set(captions)))

    def test_are_shown_without_errors_whose_lack_is_said(self):
        def times_only(at, row):
            return at != "fitting.csv" or not row["study"].startswith("fitting-")
        blocks = _blocks(times_only, ("fitting",))[0]["fitting"]
        self.assertIn("The errors are left out: `fitting.csv` has no study", blocks[0].text)
        self.assertEqual([b.kind for b in blocks[1:]], ["heading", "finding", "figure", "table", "text"])

    def test_wrong_answers_are_marked(self):
        def wrong(at, row):
            if at == "timing.csv" and row["method"] == "seed_000" and row["order"] == 2:
                row["checked"] = "no"
        blocks = _blocks(wrong, ("derivative",))[0]["derivative"]
        table, = _tables(blocks).values()
        self.assertEqual({label: cells[0].mark for label, cells in table.groups[-1].rows}, {"order 1": "", "order 2": "outside"})
        self.assertIn("✗ marks times of `seed_000`", blocks[-1].text)


if __name__ == "__main__":
    unittest.main()
