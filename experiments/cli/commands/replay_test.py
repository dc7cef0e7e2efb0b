#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`replay` from outside: every recorded worst case comes out again. Usage: replay_test.py BEZIERBENCH"""
import csv
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINDING, HEAD, INPUT_OUTPUT, USAGE, Case  # noqa: E402

STUDIES = ['[[study]]', 'id = "a"', 'kind = "accuracy"', 'curve = "bezier"', 'degree = [0, 4]', 'dimension = [1, 3]',
           'scalar = ["float", "double"]', 'trials = 40',
           '[[study]]', 'id = "b"', 'kind = "search"', 'curve = "polynomial"', 'degree = [3]', 'trials = 20',
           'budget = 50']


class Replay(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "suite.toml").write_text("\n".join(HEAD + STUDIES) + "\n")
        self.bundle("suite.toml", name="b")

    def recorded(self, name):
        with open(self.folder / "b" / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_recomputes_what_is_recorded(self):
        """One id of every method, scalar and dimension."""
        chosen = {(r["method"], r["scalar"], r["dimension"]): r["worst_id"] for r in self.recorded("worst.csv")}
        chosen |= {r["method"]: r["search_id"] for r in self.recorded("search.csv")}
        self.assertGreater(len(chosen), 100)
        for what, worst_id in chosen.items():
            with self.subTest(what=what):
                text = self.fine("replay", "b", worst_id)
                self.assertIn("the same\n", text)
                self.assertNotIn("DIFFERENT", text)

    def test_says_where_the_error_comes_from(self):
        row = next(r for r in self.recorded("worst.csv") if r["method"] == "differences:horner" and r["degree"] == "4")
        text = self.fine("replay", "b", row["worst_id"])
        for words in ["input", "converted to power form", "conversion", "rounding of 1-t", "evaluation", "bound",
                      row["error"], row["t"]]:
            self.assertIn(words, text)

    def test_another_result_is_a_finding(self):
        path = self.folder / "b/worst.csv"
        row = next(r for r in self.recorded("worst.csv") if float(r["error"]) > 0)
        path.write_text(path.read_text().replace(row["error"], "1e-30"))
        self.refused(INPUT_OUTPUT, ["replay", "b", row["worst_id"]], "b/worst.csv: is not what SHA256SUMS lists", "--damaged")
        result = self.run_program("replay", "b", row["worst_id"], "--damaged")
        self.assertTrue(result.stdout.startswith(b"# DAMAGED, not as SHA256SUMS lists: b/worst.csv\n"), result)
        self.list_anew("b")
        result = self.run_program("replay", "b", row["worst_id"])
        self.assertNotIn(b"DAMAGED", result.stdout)
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"DIFFERENT", result.stdout)

    def test_refusals(self):
        self.refused(USAGE, ["replay", "b", "w0"], "w0: no such worst case")
        self.refused(USAGE, ["replay", "b"], "replay needs ID")
        (self.folder / "empty").mkdir()
        self.refused(INPUT_OUTPUT, ["replay", "empty", "w1"], "empty: is not a bundle")
        path = self.folder / "b/worst.csv"
        good = path.read_text()
        row = self.recorded("worst.csv")[0]
        for column, bad in [("t", "nan"), ("coefficients", row["coefficients"] + " 0x1p+0"), ("degree", "2000"),
                            ("scalar", "half"), ("dimension", "0"), ("method", "nobody")]:
            with self.subTest(column=column):
                rows = self.recorded("worst.csv")
                rows[0][column] = bad
                with open(path, "w", newline="") as file:
                    writer = csv.DictWriter(file, row.keys(), lineterminator="\n")
                    writer.writeheader()
                    writer.writerows(rows)
                self.list_anew("b")
                self.refused(INPUT_OUTPUT, ["replay", "b", "w1"], "worst.csv:2: ")
                path.write_text(good)


if __name__ == "__main__":
    unittest.main()
