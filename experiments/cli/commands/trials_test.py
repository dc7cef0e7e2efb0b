#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`trials` from outside: what it exports gives the statistics of accuracy.csv. Usage: trials_test.py BEZIERBENCH"""
import sys
import unittest
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import HEAD, INPUT_OUTPUT, USAGE, Case, rows  # noqa: E402

STUDIES = ['[[study]]', 'id = "a"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [0, 6]', 'dimension = [1, 3]',
           'scalar = ["float", "double"]', 't_interval = [[0, 1], [0.25, 0.5]]', 'trials = 30', 'replicates = 2',
           'methods = ["de_casteljau", "direct_pow", "differences:horner"]',
           '[[study]]', 'id = "w"', 'kind = "accuracy"', 'curve = "rational"', 'degree = [3]', 'trials = 40',
           'methods = ["direct"]',
           '[[study]]', 'id = "c"', 'kind = "conversion"', 'curve = "bernstein"', 'degree = [3]', 'trials = 5',
           'methods = ["exact+exact"]']


def exact(text):
    """The rational number that a decimal or hexadecimal floating-point number is."""
    return Fraction(float.fromhex(text) if "0x" in text else float(text))


class Trials(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "suite.toml").write_text("\n".join(HEAD + STUDIES) + "\n")
        self.bundle("suite.toml", name="b")

    def trials(self, cell):
        axes = [f"{axis}={cell[axis]}" for axis in ("degree", "dimension", "scalar", "coordinate_range", "generator")]
        axes.append(f"t_interval={cell['t_min']}:{cell['t_max']}")
        return rows(self.fine("trials", "b", "--study", cell["study"], "--method", cell["method"],
                              *[word for axis in axes for word in ("--set", axis)]))

    def test_gives_the_statistics_of_every_cell(self):
        """Count, largest and mean, the latter in exact arithmetic and rounded once, as the bundle's is."""
        judged = 0
        for cell in self.table("b/accuracy.csv") + self.table("b/unstable.csv"):
            with self.subTest(cell=cell):
                trials = self.trials(cell)
                self.assertEqual([int(row["trial"]) for row in trials], list(range(int(cell["trials"]))))
                finite = [row for row in trials if row["error"]]
                self.assertEqual(len(trials) - len(finite), int(cell["non_finite"]))
                for column in ("error", "error_u"):
                    values = [float(row[column]) for row in finite]
                    self.assertEqual(max(values), float(cell["max_" + column]))
                    self.assertEqual(float(sum(map(Fraction, values)) / len(values)), float(cell["mean_" + column]))
                if cell["bound_u"]:
                    self.assertEqual(max(float(row["bound_u"]) for row in finite if row["bound_u"]),
                                     float(cell["bound_u"]))
                judged += 1
        self.assertEqual(judged, 2 * 2 * 2 * 2 * 3 + 1)

    def test_the_worst_trial_is_the_recorded_one(self):
        for worst in self.table("b/worst.csv"):
            with self.subTest(worst=worst["worst_id"]):
                row = self.trials(worst)[int(worst["trial"])]
                for column in ("error", "error_u", "t", "coefficients", "weights"):
                    self.assertEqual(row[column], worst[column])

    def test_refusals(self):
        study = ["trials", "b", "--study", "a"]
        method = ["--method", "de_casteljau"]
        one = ["--set", "dimension=1", "--set", "scalar=double", "--set", "t_interval=0:1"]
        self.refused(USAGE, [*study, *method], "16 such cells", "degree (0, 6)", "scalar (float, double)")
        self.refused(USAGE, [*study, *method, *one], "2 such cells", "degree (0, 6)")
        self.refused(USAGE, [*study, *method, *one, "--set", "degree=5"], "no such cell in b", "degree (0, 6)")
        self.refused(USAGE, [*study, "--method", "de_castlejau", *one, "--set", "degree=6"], "de_castlejau")
        self.refused(USAGE, [*study, "--method", "*horner*", *one, "--set", "degree=6"], "name one")
        self.refused(USAGE, ["trials", "b", "--study", "b", *method], "--study b: no study matches")
        self.refused(USAGE, ["trials", "b", "--study", "", *method], "--study: is empty")
        for setting in ("baseline=direct", "trials=5", "replicates=1", "methods=direct", "decomposed_trials=1"):
            with self.subTest(setting=setting):  # every trial is judged as the run did: a cell is all there is to choose
                self.refused(USAGE, [*study, *method, *one, "--set", "degree=6", "--set", setting],
                             f"--set {setting}", "not an axis that distinguishes cells", "degree")
        self.refused(USAGE, [*study, *method, *one, "--set", "degre=6"], 'did you mean "degree"?')
        self.refused(USAGE, ["trials", "b", "--study", "*", *method], "more than one study")
        self.refused(USAGE, ["trials", "b", "--study", "c", *method], "kind accuracy")
        self.refused(USAGE, ["trials", "b", *method], "--study")
        self.refused(INPUT_OUTPUT, ["trials", "nowhere", "--study", "a", *method], "not a bundle")

if __name__ == "__main__":
    unittest.main()
