#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`choose` from outside, and pareto.csv beside it. Usage: choose_test.py BEZIERBENCH"""
import fnmatch
import re
import shlex
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINDING, FINE, HEAD, INPUT_OUTPUT, ROOT, USAGE, Case, rows  # noqa: E402

METHODS = ["de_casteljau", "compensated_de_casteljau", "horner_bernstein", "differences:horner"]
# No error in units of u p~ is proved for all curves that go through rounded power coefficients, up to t = 1.
NO_CLASS_BOUND = ("differences:horner", "differences:estrin")
ELSEWHERE = "differences:estrin"  # timed with the others, judged in a study of its own
STUDIES = ['[[study]]', 'id = "truth"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [8]', 'trials = 300',
           f'methods = {METHODS}'.replace("'", '"'),
           '[[study]]', 'id = "more"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [8]', 'trials = 900',
           'coordinate_range = [0.5, 1, 8]', 't_interval = [[0, 1], [-10, 10]]', 'methods = ["de_casteljau"]',
           '[[study]]', 'id = "small"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [8]', 'trials = 20',
           f'methods = ["{ELSEWHERE}"]',
           '[[study]]', 'id = "race"', 'kind = "timing"', 'curve = "bernstein"', 'degree = [8]', 'modes = ["point"]',
           f'methods = {[*METHODS, ELSEWHERE]}'.replace("'", '"')]
COLUMNS = ["method", "mode", "ns", "ns_low", "ns_high", "observed_max", "bound", "unit", "pareto"]


class Choose(Case):
    def setUp(self):
        super().setUp()
        (self.folder / "suite.toml").write_text("\n".join(HEAD + STUDIES) + "\n")
        self.fine("run", "suite.toml", "--out", "b", "--quiet")

    def largest(self, column):
        """The largest error of each method on the curves that were timed: coordinates in [-1, 1], t in [0, 1]."""
        errors = {}
        for row in self.table("b/accuracy.csv"):
            if float(row["coordinate_range"]) <= 1 and (row["t_min"], row["t_max"]) == ("0", "1"):
                errors[row["method"]] = max(errors.get(row["method"], 0), float(row[column]))
        return errors

    def chosen(self, *more):
        return rows(self.fine("choose", "b", "--degree", "8", "--format", "csv", *more))

    def retime(self, ns, **more):
        """Puts other times, those of a base that takes 10 ns, and more in every row, into timing.csv: choose reads that file."""
        def change(row):
            row.update(more)
            if row["method"] in ns:
                row.update(zip(["median_ns", "low_ns", "high_ns"], map(str, ns[row["method"]])))
                row.update(zip(["ratio", "ratio_low", "ratio_high"], (str(one / 10) for one in ns[row["method"]])))
        self.edit("b/timing.csv", change)

    def test_lists_what_is_accurate_enough_fastest_first(self):
        errors = self.largest("max_error_u")
        self.assertGreater(errors["differences:horner"], 30)
        found = self.chosen("--tolerance", "30")
        self.assertEqual(list(found[0])[:len(COLUMNS)], COLUMNS)
        self.assertEqual({row["method"] for row in found}, {m for m in errors if errors[m] <= 30})
        self.assertEqual([float(row["ratio"]) for row in found], sorted(float(row["ratio"]) for row in found))
        self.assertEqual({row["relative_to"] for row in found}, {self.table("b/timing.csv")[0]["relative_to"]})
        for row in found:
            self.assertEqual(float(row["observed_max"]), errors[row["method"]])
            self.assertEqual((row["unit"], row["mode"]), ("u", "point"))
            kept = float(row["bound"]) <= 30
            self.assertEqual(row["bound_of"], "trials" if row["method"] in NO_CLASS_BOUND else "class")
            self.assertEqual(row["tolerance"], "observed" if not kept else "proved" if row["bound_of"] == "class" else
                             "proved for the trials")

    def test_proved_is_said_of_the_class_only(self):
        """With a bound for each of the trials, another input of the class may be as wrong as one likes."""
        found = {row["method"]: row for row in self.chosen("--tolerance", "1e300")}
        self.assertEqual({method for method, row in found.items() if row["tolerance"] == "proved for the trials"},
                         set(NO_CLASS_BOUND))
        self.assertEqual({row["tolerance"] for method, row in found.items() if method not in NO_CLASS_BOUND},
                         {"proved"})
        self.assertAlmostEqual(float(found["de_casteljau"]["bound"]), 3 * 8, places=9)  # gamma_3n p~
        self.retime({NO_CLASS_BOUND[0]: (0.02, 0.01, 0.03)})  # the first line states it of the fastest method
        told = self.fine("choose", "b", "--degree", "8", "--tolerance", "1e300")
        self.assertIn("coordinates in [-1, 1], t in [0, 1]", told)
        self.assertIn("proved for the trials", told)

    def test_no_bound_where_a_trial_has_none(self):
        """pareto.csv and choose do not state a bound that holds for some of the trials only."""
        method = "wozny_chudy_positive"  # proved for t in [0, 1] only
        both = f'methods = ["de_casteljau", "{method}"]\nt_interval = [[-10, 10]]\n'
        (self.folder / "partly.toml").write_text("\n".join(HEAD + [
            '[[study]]', 'id = "truth"', 'kind = "accuracy"', 'curve = "bernstein"', 'degree = [8]', 'trials = 300', both,
            '[[study]]', 'id = "race"', 'kind = "timing"', 'curve = "bernstein"', 'degree = [8]', 'modes = ["point"]', both]))
        self.fine("run", "partly.toml", "--out", "b2", "--quiet")
        stated = {row["method"]: row["bound_u"] for row in self.table("b2/pareto.csv")}
        self.assertEqual(stated[method], "")
        self.assertNotEqual(stated["de_casteljau"], "")
        self.assertTrue(all(row["bound_u"] for row in self.table("b2/accuracy.csv")))  # of the trials that have one
        chosen = self.fine("choose", "b2", "--degree", "8", "--tolerance", "1e300", "--format", "csv")
        told = {row["method"]: row for row in rows(chosen)}
        self.assertEqual((told[method]["bound"], told[method]["tolerance"]), ("", "observed"))
        self.assertEqual(told["de_casteljau"]["tolerance"], "proved")

    def test_knows_what_is_not_worth_choosing(self):
        self.retime({"de_casteljau": (50, 49, 51), "compensated_de_casteljau": (90, 89, 91),
                     "horner_bernstein": (10, 9, 11), "differences:horner": (60, 59, 61)})
        pareto = {row["method"]: row["pareto"] for row in self.chosen("--tolerance", "1e9")}
        self.assertEqual(pareto["horner_bernstein"], "yes")  # the fastest
        self.assertEqual(pareto["compensated_de_casteljau"], "yes")  # the most accurate
        self.assertEqual(pareto["differences:horner"], "no")  # slower and less accurate
        self.retime({"de_casteljau": (58, 50, 66)})
        self.assertEqual({row["method"]: row["pareto"] for row in self.chosen("--tolerance", "1e9")}
                         ["differences:horner"], "no")  # horner_bernstein still beats it

    def test_times_of_curves_that_are_not_described_are_refused_in_words(self):
        self.retime({}, coordinate_range="wide")
        self.refused(USAGE, ["choose", "b", "--degree", "8", "--tolerance", "1"], "b: timing.csv does not state")

    def lines(self, *more, code=FINE):
        result = self.run_program("choose", "b", "--degree", "8", *more)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout.decode().splitlines()

    def test_names_the_winner_and_what_speaks_for_others(self):
        apart = {"de_casteljau": (50, 49, 51), "compensated_de_casteljau": (90, 89, 91), "horner_bernstein": (10, 9, 11),
                 "differences:horner": (5, 4, 6), ELSEWHERE: (70, 69, 71)}
        self.retime(apart)
        wide = self.lines("--tolerance", "1e9")
        self.assertEqual(wide[0], "5 of 5 methods are within 1e9 u p~; the fastest: differences:horner")
        self.assertRegex(wide[1], r"^  0\.5 \[0\.4, 0\.6\] times the time of \w+, error \S+ u p~; proved for the trials$")
        self.assertRegex(wide[2], r"^  the fastest with a proof: horner_bernstein$")
        self.assertRegex(wide[3], r"^  1 \[0\.9, 1\.1\] times the time of \w+")
        narrow = self.lines("--tolerance", "30")
        self.assertEqual(narrow[0], "3 of 5 methods are within 30 u p~; the fastest: horner_bernstein")
        self.assertEqual(narrow[2], "")  # no other is as fast, and it is proved
        self.retime({**apart, "de_casteljau": (11, 10.5, 12)})
        self.assertEqual(self.lines("--tolerance", "30")[2], "  not certainly faster than de_casteljau")

    def test_says_which_cells_it_rests_on(self):
        lines = self.lines("--tolerance", "1e9")
        start = lines.index("times of study race; largest errors of 4 cells:")
        self.assertEqual(lines[start + 1:start + 5],
                         ["  truth: R 1, t in [0, 1], continuous, 300 trials", "  more: R 0.5, t in [0, 1], continuous, 900 trials",
                          "  more: R 1, t in [0, 1], continuous, 900 trials", "  small: R 1, t in [0, 1], continuous, 20 trials"])
        self.assertNotIn("R 8", "\n".join(lines))

    def test_fits_the_terminal(self):
        self.assert_fits("choose", "b", "--degree", "8", "--tolerance", "1e9")
        self.assert_fits("choose", "b", "--degree", "8", "--tolerance", "1e9", "--unit", "coordinate", "--range", "8")

    def test_names_other_times(self):
        """And where no class has errors, the first that was timed is what the message is about."""
        truth = STUDIES[:STUDIES.index('id = "more"') - 1] + ["t_interval = [[0, 1], [-10, 10]]"]
        race = STUDIES[STUDIES.index('id = "race"') - 1:]
        wide = [line.replace("race", "wide") for line in race] + ["t_interval = [[-10, 10]]"]
        (self.folder / "two.toml").write_text("\n".join(HEAD + truth + race + wide) + "\n")
        self.fine("run", "two.toml", "--out", "two", "--quiet")
        told = self.fine("choose", "two", "--degree", "8", "--tolerance", "1e300").splitlines()
        at = told.index("other timing studies, see --study:")
        self.assertEqual(told[at + 1], "  wide: coordinates in [-1, 1], t in [-10, 10], continuous")
        self.refused(USAGE, ["choose", "two", "--degree", "8", "--tolerance", "1", "--range", "1e200"], "coordinates in [-1e+200, 1e+200], t in [0, 1]")

    def offered(self, *wish):
        """The command that a refusal offers, as words; quick and speed are suites that come with the program."""
        message = self.refused(USAGE, ["choose", "b", "--tolerance", "1e9", *wish]).stderr.decode()
        words = shlex.split(re.search("`(.*)`", message)[1])[1:]
        self.assertEqual(words[0], "run")
        return words[:1] + [str(ROOT / f"experiments/suites/{words[1]}.toml")] + words[2:]

    def test_offers_a_command_that_makes_a_bundle_that_can(self):
        for wish in (["--degree", "3", "--form", "rational"], ["--degree", "2", "--form", "rational", "--range", "7",
                                                               "--scalar", "float", "--dimension", "3", "--mode", "one_shot"]):
            with self.subTest(wish=wish):
                command = self.offered(*wish)
                self.run_program(*command, "--quiet", timeout=600)
                told = self.fine("choose", command[command.index("--out") + 1], "--tolerance", "1e9", *wish)
                self.assertIn("; the fastest: ", told)

    def test_offers_a_suite_that_has_the_mode(self):
        for mode in ("point", "one_shot", "latency", "batch"):
            for form in ("bernstein", "power"):
                command = self.offered("--degree", "9", "--mode", mode, "--form", form)
                chosen = command[command.index("--only") + 1]
                studies = [row["id"] for row in rows(self.fine("list", "studies", "--format", "csv"))]
                self.assertEqual(len(fnmatch.filter(studies, chosen)), 2, chosen)
                self.assertIn(f'"{mode}"', Path(command[1]).read_text())

    def test_coordinate_units(self):
        errors = self.largest("max_error")
        tolerance = sorted(errors.values())[1]
        found = self.chosen("--tolerance", repr(tolerance), "--unit", "coordinate")
        self.assertEqual({row["method"] for row in found}, {m for m in errors if errors[m] <= tolerance})
        self.assertEqual({row["unit"] for row in found}, {"coordinate"})

    def test_other_ranges_are_scaled_by_powers_of_two(self):
        """1000 is below 1 times 2^10, and errors in coordinates are as many times those of the judged curves."""
        near, far = (self.chosen("--tolerance", "1e300", "--unit", "coordinate", "--range", range_) for range_ in ("1", "1000"))
        self.assertEqual({row["coordinate_range"] for row in far}, {"1024"})
        self.assertEqual({row["method"]: float(row["observed_max"]) for row in far},
                         {row["method"]: 1024 * float(row["observed_max"]) for row in near})
        self.assertIn("coordinates in [-1024, 1024], t in [0, 1]; judged in [-1, 1], times 2^10",
                      self.fine("choose", "b", "--degree", "8", "--tolerance", "1e300", "--range", "1000"))

    def test_pareto_file_says_the_same(self):
        stated = {row["method"]: row for row in self.table("b/pareto.csv")}
        self.assertEqual(set(stated), set(METHODS))
        for row in self.chosen("--tolerance", "1e9", "--accuracy-study", "truth"):
            for ours, theirs in [("ns", "ns"), ("ns_low", "ns_low"), ("observed_max", "observed_max_u"),
                                 ("pareto", "pareto")]:
                self.assertEqual(row[ours], stated[row["method"]][theirs])
            if row["bound_of"] == "trials":
                self.assertEqual(row["bound"], stated[row["method"]]["bound_u"])

    def test_none_is_accurate_enough(self):
        result = self.run_program("choose", "b", "--degree", "8", "--tolerance", "1e-9", "--format", "csv")
        self.assertEqual(result.returncode, FINDING)
        self.assertEqual(len(result.stdout.splitlines()), 1)  # the header
        self.assert_one_line(result, "most accurate is compensated_de_casteljau with ")
        self.assertRegex(result.stderr.decode(), r"with [0-9.]{1,7} u p~; --unit coordinate takes a tolerance in coordinates\n$")
        result = self.run_program("choose", "b", "--degree", "8", "--tolerance", "1e-30", "--unit", "coordinate")
        self.assertEqual((result.returncode, result.stdout), (FINDING, b""))
        self.assertRegex(result.stderr.decode(), r"with \S{1,9} coordinate units\n$")

    def test_refusals(self):
        asked = ["choose", "b", "--tolerance", "30", "--degree"]
        self.refused(USAGE, [*asked, "9"], "degree 9 ")
        self.refused(USAGE, [*asked, "8", "--mode", "batch"], "(available: point")
        self.refused(USAGE, [*asked, "8", "--form", "power"], "(available: bernstein")
        self.refused(USAGE, [*asked, "8", "--study", "other"], "(available: race")
        self.refused(USAGE, [*asked, "8", "--accuracy-study", "other"], "other")
        self.refused(USAGE, [*asked, "8", "--unit", "ulp"], "--unit")
        self.refused(USAGE, [*asked, "8", "--range", "1e200"], "0.5, 1, 8")
        self.refused(USAGE, [*asked, "8", "--range", "-1"], "--range -1")
        self.refused(USAGE, ["choose", "b", "--degree", "8", "--tolerance", "nan"], "nan")
        self.refused(INPUT_OUTPUT, ["choose", "nowhere", "--degree", "8", "--tolerance", "1"], "nowhere")
        (self.folder / "b/timing.csv").unlink()
        self.refused(INPUT_OUTPUT, [*asked, "8"], "b/timing.csv: is missing")
        self.list_anew("b")
        self.refused(USAGE, [*asked, "8"], "does not have times")

    def test_ranks_the_methods_of_a_companion_problem(self):
        """Those without a fault first, each part the fastest first; the quadratic formula in floating point is a little inside."""
        methods = ["control_box", "quadratic_formula_box", "exact_box"]
        both = ['curve = "bernstein"', 'degree = [3]', f"methods = {methods}".replace("'", '"')]
        (self.folder / "boxes.toml").write_text("\n".join(HEAD + [
            '[[study]]', 'id = "boxes"', 'kind = "bounds"', 'trials = 300', *both,
            '[[study]]', 'id = "race"', 'kind = "timing"', 'modes = ["one_shot"]', *both]) + "\n")
        self.fine("run", "boxes.toml", "--out", "boxes", "--quiet")
        judged = {row["method"]: row for row in self.table("boxes/bounds.csv")}
        asked = ["choose", "boxes", "--problem", "bounds", "--degree"]
        ranked = rows(self.fine(*asked, "3", "--format", "csv"))
        self.assertEqual({row["method"] for row in ranked}, set(methods))
        wrong = [int(judged[row["method"]]["too_small"]) for row in ranked]
        self.assertEqual([row["faults"] for row in ranked], [f"too_small {count}" if count else "" for count in wrong])
        self.assertEqual((wrong[:2], wrong[2] > 0), ([0, 0], True))
        self.assertLess(float(ranked[0]["ns"]), float(ranked[1]["ns"]))
        self.assertEqual([row["pareto"] for row in ranked], ["yes", "yes", "no"])
        for row in ranked:
            self.assertEqual(row["mean_excess_size"], judged[row["method"]]["mean_excess_size"])
        self.assertIn(f"2 of 3 methods are without a fault in 300 trials; the fastest: {ranked[0]['method']}",
                      self.fine(*asked, "3"))
        self.assert_fits(*asked, "3")
        self.refused(USAGE, [*asked, "4"], "no method of bounds was judged at degree 4; available: 3")
        self.refused(USAGE, [*asked, "3", "--tolerance", "1"], "bounds has no tolerance")
        self.refused(USAGE, ["choose", "boxes", "--problem", "flattening", "--degree", "3"], "does not have both flattening.csv and times")
        self.refused(USAGE, ["choose", "--problem", "bounds", "--degree", "3"], "must come with BUNDLE")

if __name__ == "__main__":
    unittest.main()
