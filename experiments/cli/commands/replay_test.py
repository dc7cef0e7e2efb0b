#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`replay` from outside: every recorded worst case and counterexample comes out again. Usage: replay_test.py BEZIERBENCH"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINDING, HEAD, INPUT_OUTPUT, USAGE, Case  # noqa: E402

STUDIES = ['[[study]]', 'id = "a"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [0, 4]', 'dimension = [1, 3]',
           'scalar = ["float", "double"]', 'trials = 40',
           '[[study]]', 'id = "b"', 'kind = "search"', 'curve = "power"', 'degree = [3]', 'trials = 20',
           'budget = 50',
           '[[study]]', 'id = "c"', 'kind = "guarantees"', 'curve = "bernstein"', 'degree = [1, 3]', 'scalar = ["float", "double"]',
           'methods = ["de_casteljau", "de_casteljau_lerp", "direct*"]', 'trials = 10', 'budget = 2000',
           '[[study]]', 'id = "d"', 'kind = "bounds"', 'curve = "bernstein"', 'degree = [2, 3]', 'dimension = [1, 3]', 'trials = 50',
           '[[study]]', 'id = "e"', 'kind = "bounds"', 'curve = "rational"', 'degree = [3]', 'trials = 50']


class Replay(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "suite.toml").write_text("\n".join(HEAD + STUDIES) + "\n")
        self.bundle("suite.toml", name="b")

    def test_recomputes_what_is_recorded(self):
        """One id of every method, scalar and dimension."""
        chosen = {(r["method"], r["scalar"], r["dimension"]): r["worst_id"] for r in self.table("b/worst.csv")}
        chosen |= {r["method"]: r["search_id"] for r in self.table("b/search.csv")}
        self.assertGreater(len(chosen), 100)
        for what, worst_id in chosen.items():
            with self.subTest(what=what):
                text = self.fine("replay", "b", worst_id)
                self.assertIn("the same\n", text)
                self.assertNotIn("DIFFERENT", text)

    def test_counterexamples_break_their_property_again(self):
        rows = self.table("b/guarantees.csv") + self.table("b/guarantees_unstable.csv")
        self.assertEqual(len({r["guarantee_id"] for r in rows}), len(rows))
        chosen = {(r["method"], r["scalar"], r["property"], r["verdict"]): r for r in rows if r["t"]}
        self.assertEqual({verdict for *_, verdict in chosen}, {"refuted", "not_refuted"})
        for what, row in chosen.items():
            with self.subTest(what=what):
                text = self.fine("replay", "b", row["guarantee_id"])
                self.assertIn("it breaks the property" if row["verdict"] == "refuted" else "it does not break", text)
                for words in [row["property"], row["t"], row["t_next"], row["offset"], *row["coefficients"].split()]:
                    self.assertIn(words, text)

    def test_boxes_lose_a_point_again(self):
        rows = {f"bounds.csv:{line}": row for line, row in enumerate(self.table("b/bounds.csv"), 2)}
        refuted = {name: row for name, row in rows.items() if row["contains"] == "refuted"}
        self.assertEqual({row["form"] for row in refuted.values()}, {"bernstein", "rational"})
        for name, row in refuted.items():
            with self.subTest(name=name):
                text = self.fine("replay", "b", name)
                for words in [row["method"], "doubles inside", "refuted: the same", *row["coefficients"].split(), *row["weights"].split()]:
                    self.assertIn(words, text)
        proved = next(name for name, row in rows.items() if row["contains"] == "proved")
        self.refused(USAGE, ["replay", "b", proved], "has no curve with a point outside")

    def test_a_box_that_contains_its_curve_is_a_finding(self):
        rows = self.table("b/bounds.csv")
        line = next(line for line, row in enumerate(rows, 2) if row["contains"] == "refuted" and row["form"] == "bernstein")
        row = rows[line - 2]
        row["coefficients"] = " ".join(["0x1p+0"] * len(row["coefficients"].split()))
        self.write_table("b/bounds.csv", rows)
        result = self.run_program("replay", "b", f"bounds.csv:{line}")
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"DIFFERENT", result.stdout)

    def test_a_proof_has_no_input(self):
        row = next(r for r in self.table("b/guarantees.csv") if r["verdict"] == "proved")
        self.refused(USAGE, ["replay", "b", row["guarantee_id"]], "is proved")

    def test_what_does_not_break_its_property_is_a_finding(self):
        """Of an input that breaks a property the verdict is turned round, and of one that does not."""
        path = self.folder / "b/guarantees.csv"
        for before, after in (("refuted", "not_refuted"), ("not_refuted", "refuted")):
            rows = self.table("b/guarantees.csv")
            row = next(r for r in rows if r["verdict"] == before)
            good = path.read_text()
            row["verdict"] = after
            row["largest"] = "0.5"
            self.write_table(path, rows)
            self.assertIn(b"DIFFERENT", self.run_program("replay", "b", row["guarantee_id"]).stdout)
            path.write_text(good)

    def test_says_where_the_error_comes_from(self):
        row = next(r for r in self.table("b/worst.csv") if r["method"] == "differences:horner" and r["degree"] == "4")
        text = self.fine("replay", "b", row["worst_id"])
        for words in ["input", "converted to power form", "conversion", "rounding of 1-t", "evaluation", "bound",
                      row["error"], row["t"]]:
            self.assertIn(words, text)

    def test_another_result_is_a_finding(self):
        path = self.folder / "b/worst.csv"
        row = next(r for r in self.table("b/worst.csv") if float(r["error"]) > 0)
        path.write_text(path.read_text().replace(row["error"], "1e-30"))
        self.refused(INPUT_OUTPUT, ["replay", "b", row["worst_id"]], "b/worst.csv: is not what SHA256SUMS lists")
        self.list_anew("b")
        result = self.run_program("replay", "b", row["worst_id"])
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"DIFFERENT", result.stdout)

    def test_refusals(self):
        self.refused(USAGE, ["replay", "b", "w0"], "w0: no such id")
        self.refused(USAGE, ["replay", "b"], "ID is required")
        (self.folder / "empty").mkdir()
        self.refused(INPUT_OUTPUT, ["replay", "empty", "w1"], "empty: is not a bundle")
        path = self.folder / "b/worst.csv"
        good = path.read_text()
        row = self.table("b/worst.csv")[0]
        for column, bad in [("t", "nan"), ("coefficients", row["coefficients"] + " 0x1p+0"), ("degree", "2000"),
                            ("scalar", "half"), ("dimension", "0"), ("method", "nobody")]:
            with self.subTest(column=column):
                rows = self.table("b/worst.csv")
                rows[0][column] = bad
                self.write_table(path, rows)
                self.refused(INPUT_OUTPUT, ["replay", "b", "w1"], "worst.csv:2: ")
                path.write_text(good)


if __name__ == "__main__":
    unittest.main()
