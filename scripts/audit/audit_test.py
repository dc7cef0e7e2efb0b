# SPDX-License-Identifier: MIT
"""The audit: a library that answers wrongly is caught, and every worst case of results/audit follows from its row.

Argument: libbezierbench.so.
"""
import importlib.machinery
import importlib.util
import os
import random
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
os.environ["BEZIERBENCH_LIBRARY"] = sys.argv.pop() if len(sys.argv) > 1 else str(ROOT / "build/release/lib/libbezierbench.so")
loader = importlib.machinery.SourceFileLoader("audit", str(ROOT / "scripts/checks/audit"))
audit = importlib.util.module_from_spec(importlib.util.spec_from_loader("audit", loader))
sys.dont_write_bytecode = True
loader.exec_module(audit)

import numpy as np
import questions
from bezierbench import ease
from libraries import DISTANCE, ENDS, FOLDER, LENGTH, NEAREST, POINT, SPLIT, Child, Library


def truth(problem, degree, items, wrong=0.0):
    """What a library that knows the truth answers, with its numbers made larger by `wrong` of them."""
    answers = []
    for item in items:
        curve = questions.Curve("", "", tuple(zip(item[:2 * degree + 2:2], item[1:2 * degree + 2:2])))
        exact = questions.PROBLEMS[problem].exact(curve, item[2 * degree + 2:])
        answers.append([value + wrong * max(abs(value), 1) for value in exact])
    return answers


class Faults(unittest.TestCase):
    library = Library("fake", "1", "npm", (), (LENGTH, POINT, SPLIT, ENDS, NEAREST, DISTANCE))
    curves = {"bootstrap": audit.curves_of("bootstrap", 5)}

    def off(self, ask):
        return {(row["problem"], row["degree"]): int(row["off"]) for row in audit.rows_of(self.library, self.curves, ask)}

    def test_the_truth_is_never_off(self):
        found = self.off(truth)
        self.assertEqual(len(found), 12)
        self.assertEqual({name for name, off in found.items() if off and name[0] != "ends"}, set())

    def test_wrong_answers_are_off(self):
        found = self.off(lambda *asked: truth(*asked, wrong=0.2))
        self.assertEqual({name for name, off in found.items() if off < 4}, set())

    def test_what_is_not_answered_is_counted(self):
        rows = audit.rows_of(self.library, self.curves, lambda problem, degree, items: [None] * len(items))
        self.assertEqual({(row["asked"], row["answered"], row["max"]) for row in rows}, {("5", "0", "")})


class Committed(unittest.TestCase):
    rows = audit.read(audit.RESULTS / "audit.csv")

    def test_every_worst_case_follows_from_its_row(self):
        for row in self.rows:
            control, asked, answer, exact = ([float.fromhex(value) for value in row[field].split()]
                                             for field in ("control_points", "question", "answer", "exact"))
            curve = questions.Curve(row["set"], row["worst_curve"], tuple(zip(control[::2], control[1::2])))
            problem, case = questions.PROBLEMS[row["problem"]], " ".join(list(row.values())[:7])
            error = problem.error(curve, asked, answer)
            problem.check(curve, asked, answer, error)
            self.assertEqual(f"{error / questions.UNITS[row['unit']](curve):.3g}", row["max"], case)
            self.assertEqual([float(value) for value in problem.exact(curve, asked)], exact, case)
            if not problem.faults:
                self.assertEqual(int(row["off"]) > 0, error / questions.UNITS[row["unit"]](curve) > float(row["expectation"]), case)

    def test_a_changed_worst_case_is_found(self):
        row = next(row for row in self.rows if row["problem"] == "length" and int(row["off"]))
        control, answer = ([float.fromhex(value) for value in row[field].split()] for field in ("control_points", "answer"))
        curve = questions.Curve(row["set"], row["worst_curve"], tuple(zip(control[::2], control[1::2])))
        with self.assertRaises(ValueError):
            questions.LENGTH.check(curve, [], answer, 1.1 * questions.LENGTH.error(curve, [], answer))

    def test_the_page_is_written_from_the_table(self):
        self.assertEqual((audit.RESULTS / "README.md").read_text(encoding="utf-8"), audit.page.written(self.rows))

    def test_differences_are_named(self):
        self.assertEqual(audit.differences(self.rows, self.rows), [])
        self.assertEqual(len(audit.differences([{**self.rows[0], "off": "9999"}], self.rows)), 1)

    def test_rows_of_others_stay(self):
        changed = {**self.rows[5], "off": "9999"}
        self.assertEqual(audit.with_others([changed], self.rows), [*self.rows[:5], changed, *self.rows[6:]])
        self.assertEqual(audit.with_others([], [{**self.rows[0], "version": "0"}]), [])


class Live(unittest.TestCase):
    """The package bezier-easing 2.1.0, where `scripts/check audit` has installed it, against easing_table_newton, our copy of it."""

    def setUp(self):
        if not (FOLDER / "npm/node_modules/bezier-easing-2.1.0").is_dir():
            self.skipTest("bezier-easing 2.1.0 is not in build/audit/npm; scripts/check audit installs it")
        child = Child(["node", FOLDER / "npm/bezier_easing.mjs", "bezier-easing-2.1.0", "require"])
        self.addCleanup(child.close)
        self.ask = child.ask

    def test_has_the_same_bits(self):
        draw = random.Random(1)
        for bezier in [(1, 0, 0, 1), (0.25, 0.1, 0.25, 1), *([draw.random() for _ in range(4)] for _ in range(50))]:
            x = [draw.random() for _ in range(400)]
            answers = self.ask("easing", 3, [[0, 0, *bezier, 1, 1, one] for one in x])
            self.assertEqual([y for y, in answers], ease(bezier, x, "easing_table_newton").tolist(), bezier)

    def test_goes_back_at_the_same_steps(self):
        corner = (1, 0, 0, 1)
        (count, worst, before, after), = self.ask("monotone", 3, [[0, 0, *corner, 1, 1, questions.MONOTONE_STEPS, 0]])
        y = ease(corner, np.arange(questions.MONOTONE_STEPS + 1) / questions.MONOTONE_STEPS, "easing_table_newton")
        self.assertEqual((np.count_nonzero(np.diff(y) < 0), np.argmin(np.diff(y)) + 1), (count, worst))
        self.assertEqual((y[worst - 1], y[worst]), (before, after))
        self.assertEqual(count, 1190)


if __name__ == "__main__":
    unittest.main()
