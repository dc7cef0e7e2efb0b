#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`compare` from outside: what it finds, in which order, and what it refuses. Usage: compare_test.py BEZIERBENCH"""
import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from xml.etree import ElementTree

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import ENVIRONMENT, FINDING, FINE, INPUT_OUTPUT, PROGRAM, ROOT, STUDY, USAGE, Case, rows  # noqa: E402

CONTRACT = "kind,study,method,scalar,dimension,degree,mode,a,b,ratio,ratio_low,ratio_high,verdict".split(",")
BASELINE = ROOT / "results/baseline"
TIMES = ("median_ns", "low_ns", "high_ns")
UNITS = ("sentinel_units", "sentinel_units_low", "sentinel_units_high")


def verdict(low, high):
    """The rule of verdicts, from the interval alone."""
    if low > 1.01:
        return "slower"
    if high < 0.99:
        return "faster"
    return "same" if low >= 0.99 and high <= 1.01 else "unresolved"


class Compare(Case):
    def setUp(self):
        super().setUp()
        shutil.copytree(BASELINE, self.folder / "a")
        shutil.copytree(BASELINE, self.folder / "b")

    def scale_times(self, factor, only=None):
        """As if the machine were slower or, in units of its sentinel too, some methods only."""
        def change(row):
            if only is None or only(row):
                row.update({column: repr(float(row[column]) * factor) for column in (TIMES if only is None else TIMES + UNITS)})
        self.edit("b/timing.csv", change)

    def still_times(self, bundle):
        """As if nothing had varied, so that what the committed times were taken beside decides nothing."""
        def change(row):
            for median, *limits in (TIMES, UNITS):
                row.update({limit: row[median] for limit in limits})
        self.edit(f"{bundle}/timing.csv", change)

    def change_machine(self, change):
        path = self.folder / "b/machine.json"
        machine = json.loads(path.read_text())
        change(machine)
        path.write_text(json.dumps(machine))
        self.list_anew("b")

    def compared(self, *arguments, code=FINE):
        result = self.run_program("compare", *arguments, "--format", "csv")
        self.assertEqual(result.returncode, code, result.stderr)
        return rows(result.stdout.decode())

    # What it says.

    def test_a_bundle_is_itself(self):
        text = self.fine("compare", "a", "b")
        self.assertIn("no recorded difference", text)
        self.assertIn("\naccuracy identical in ", text)
        self.assertIn("ranks: none changed, among the methods of a race that both bundles have", text)
        table = self.compared("a", "b")
        self.assertEqual(list(table[0])[:len(CONTRACT)], CONTRACT)
        self.assertEqual({row["kind"] for row in table}, {"accuracy", "timing"})
        self.assertEqual({row["verdict"] for row in table if row["kind"] == "accuracy"}, {"identical"})
        times = [row for row in table if row["kind"] == "timing"]
        self.assertEqual(len(times), len(self.table("a/timing.csv")))
        for row in times:
            self.assertEqual(float(row["ratio"]), 1)
            units = {end: float(row[f"normalised_{end}"] or row[f"ratio_{end}"]) for end in ("low", "high")}
            self.assertEqual(row["verdict"], verdict(min(units["low"], float(row["ratio_low"])), max(units["high"], float(row["ratio_high"]))))

    def test_machines_first_then_accuracy_then_times(self):
        self.change_machine(lambda machine: machine["build"].update(compiler="Clang 99"))
        text = self.fine("compare", "a", "b")
        self.assertIn("Clang 99", text)
        self.assertLess(text.index("build.compiler"), text.index("\naccuracy "))
        self.assertLess(text.index("\naccuracy "), text.index("timing, b over a"))

    def test_one_bit_of_accuracy(self):
        """The last digit of one value: its cell, both values, and an input that replays."""
        victim = next(row for row in self.table("a/accuracy.csv")
                      if row["baseline"] == "exact" and row["method"] == "de_casteljau" and row["degree"] == "20")
        line = ",".join(victim.values())
        path = self.folder / "b/accuracy.csv"
        other = victim["max_error"][:-6] + "1" + victim["max_error"][-5:]
        self.assertNotEqual(float(other), float(victim["max_error"]))
        path.write_text(path.read_text().replace(line, line.replace(victim["max_error"], other)))
        self.list_anew("b")
        result = self.run_program("compare", "a", "b")
        self.assertEqual(result.returncode, FINDING)
        self.assert_one_line(result, "b, against a: accuracy differs in 1 of ")
        text = result.stdout.decode()
        for needle in (victim["study"], victim["max_error"], other):
            self.assertIn(needle, text)
        replay = next(line for line in text.splitlines() if "bezierbench replay a " in line).split()
        self.assertIn("the same\n", self.fine(*replay[1:]))
        different = [row for row in self.compared("a", "b", code=FINDING) if row["verdict"] == "different"]
        self.assertEqual([(row["a"], row["b"], row["column"]) for row in different],
                         [(victim["max_error"], other, "max_error")])

    # Gates.

    def gate(self, code, *gates):
        result = self.run_program("compare", "a", "b", "--fail-on", *gates)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr.decode()

    def test_the_gate_of_times(self):
        self.still_times("a")
        self.still_times("b")
        self.scale_times(1.25, lambda row: row["method"] == "de_casteljau")
        count = sum(row["method"] == "de_casteljau" for row in self.compared("a", "b") if row["kind"] == "timing")
        self.assertEqual(self.gate(FINDING, "slower"),
                         f"bezierbench: b, against a: {count} of 100 times are slower by more than 5 %; see --all\n")
        self.assertEqual(self.gate(FINE, "slower", "--threshold", "30%"), "")
        self.assertEqual(self.gate(FINE, "less-accurate"), "")
        self.edit("b/timing.csv", lambda row: row.update(low_ns=repr(float(row["median_ns"]) / 1.2)))
        self.assertEqual(self.gate(FINE, "slower"), "", "intervals that reach to below the threshold decide nothing")

    def test_the_gate_of_counts(self):
        suite = self.suite(**{"kind": '"timing"', "degree": "[3]", "methods": '["direct", "horner_bernstein"]', "modes": '["point"]',
                              "trials": None})
        for name in ("x", "y"):
            result = self.run_program("run", suite, "--counts", "--no-timing", "--out", name, "--quiet")
            if result.returncode == ENVIRONMENT:
                self.skipTest(result.stderr.decode())
            self.assertEqual(result.returncode, FINE, result.stderr)
        self.assertEqual((self.folder / "x/cost.csv").read_bytes(), (self.folder / "y/cost.csv").read_bytes())
        self.assertEqual([row["method"] for row in self.table("x/cost.csv")], ["direct", "horner_bernstein"])
        self.assertEqual(self.run_program("verify", "x").returncode, FINE)
        gate = ["compare", "x", "y", "--fail-on", "costlier"]
        self.edit("y/cost.csv", lambda row: row.update(cycles_zen4="1000000"))
        self.assertEqual(self.run_program(*gate).returncode, FINE, "a prediction is not a count")
        self.edit("y/cost.csv", lambda row: row.update(instructions=repr(1.1 * float(row["instructions"])))
                  if row["method"] == "direct" else None)
        result = self.run_program(*gate)
        self.assertEqual(result.returncode, FINDING)
        self.assert_one_line(result, "y, against x: 1 of 2 counts of instructions are larger by more than 5 %")
        self.assertIn("instructions, b over a: 1 of 2 counts differ", result.stdout.decode())
        rows = self.compared("x", "y", "--fail-on", "costlier", code=FINDING)
        self.assertEqual([row["ratio"] for row in rows if row["kind"] == "cost"][1], "1")

    def test_reports_for_pull_requests(self):
        self.still_times("a")
        self.still_times("b")
        self.scale_times(1.25, lambda row: row["method"] == "de_casteljau" and row["degree"] == "20")
        arguments = ["compare", "a", "b", "--fail-on", "slower,less-accurate", "--format"]
        text = self.run_program(*arguments, "markdown")
        self.assertEqual(text.returncode, FINDING)
        self.assertIn("**bezierbench: 1 of 2 gates fail**", text.stdout.decode())
        self.assertRegex(text.stdout.decode(), r"\n\| slower \| fails \| de_casteljau, .*degree 20.* \| 1\.250 \[1\.250, 1\.250\] \|\n")
        suites = ElementTree.fromstring(self.run_program(*arguments, "junit").stdout)
        self.assertEqual([one.get("name") for one in suites], ["b: less-accurate", "b: slower"])
        for one in suites:
            self.assertEqual(int(one.get("tests")), len(one))
            self.assertEqual(int(one.get("failures")), len(one.findall("testcase/failure")))
        self.assertGreater(int(suites[1].get("failures")), 0)

    def test_the_verdict_comes_first(self):
        def first_line(*more, code=FINE):
            result = self.run_program("compare", "a", "b", *more)
            self.assertEqual(result.returncode, code, result.stderr)
            return result.stdout.decode().splitlines()[0]
        self.assertRegex(first_line(), r"^verdict  accuracy identical in (\d+) rows; 0 slower, \d+ same, 0 faster, \d+ unresolved of 100 times$")
        self.edit("b/accuracy.csv", lambda row: row.update(max_error="1") if row["method"] == "direct" else None)
        self.assertRegex(first_line(code=FINDING), r"^verdict  accuracy differs in \d+ of \d+ rows; 0 slower")

    def test_only_what_changed_and_the_worst_first(self):
        self.still_times("a")
        self.still_times("b")
        self.scale_times(1.25, lambda row: row["method"] == "de_casteljau")
        self.scale_times(1.5, lambda row: row["method"] == "direct")
        self.scale_times(0.8, lambda row: row["method"] == "power_sum")

        def worse(row):
            factor = {"direct": 1.5, "de_casteljau": 3}.get(row["method"], 1)
            if row["max_error_u"] and row["degree"] == "20":
                row["max_error_u"] = repr(factor * float(row["max_error_u"]))
        self.edit("b/accuracy.csv", worse)
        result = self.run_program("compare", "a", "b")
        self.assertEqual(result.returncode, FINDING)
        text = result.stdout.decode()
        accuracy, times = text[text.index("\naccuracy "):].split("timing, b over a")
        self.assertEqual([line.split()[0] for line in accuracy.splitlines() if " max_error_u " in line and "line" not in line],
                         ["de_casteljau", "direct"])
        names = [line.split()[0] for line in times.splitlines() if re.search(r"\] +(slower|faster) ", line)]
        self.assertEqual(list(dict.fromkeys(names)), ["direct", "de_casteljau", "power_sum"])
        whole = self.run_program("compare", "a", "b", "--all").stdout.decode()
        self.assertGreater(len(whole.splitlines()), len(text.splitlines()) + 50)
        self.assertIn("\nhorner ", whole)

    def test_fits_the_terminal(self):
        self.assert_fits("compare", "a", "b")
        self.scale_times(1.25, lambda row: row["method"] == "de_casteljau")
        self.edit("b/accuracy.csv", lambda row: row.update(max_error="1") if row["method"] == "direct" else None)
        for more in ([], ["--all"], ["--method", "direct"]):
            self.assert_fits("compare", "a", "b", *more, code=FINDING)

    def test_readings_and_digests_are_no_differences_of_machines(self):
        self.change_machine(lambda machine: machine.update(load_average=[7.25, 7.25, 7.25]))
        self.assertIn("machines and builds: the same, except for 3 readings and digests, see --all\n", self.fine("compare", "a", "b"))
        self.assertRegex(self.fine("compare", "a", "b", "--all"), r"\nload_average.0 +\S+ +7.25\n")

    def test_verdicts_are_those_that_compare_methods(self):
        """On another machine that takes twice as long for everything, no method is slower than it was."""
        self.change_machine(lambda machine: machine["cpu"].update(model_name="another"))
        self.still_times("a")
        self.still_times("b")
        self.scale_times(2)
        text = self.fine("compare", "a", "b")
        self.assertRegex(text.splitlines()[0], r"; 0 slower, 100 same, 0 faster, 0 unresolved of 100 times in sentinels; different machines$")
        self.assertRegex(text, r"\n2 +b +another .* 2\.000 +1\.000\n")

    def test_one_method(self):
        self.edit("b/accuracy.csv", lambda row: row.update(max_error="1") if row["method"] == "direct" else None)
        table = self.compared("a", "b", "--method", "de_casteljau")
        self.assertEqual({row["method"] for row in table}, {"de_casteljau"})
        self.compared("a", "b", "--method", "direct", code=FINDING)
        self.assertEqual({row["method"] for row in self.compared("a", "b", "--method", "*:horner")},
                         {"exact:horner", "factorial:horner", "differences:horner"})
        self.refused(USAGE, ["compare", "a", "b", "--method", "de_castel"], "--method de_castel")

    def test_rank_changes(self):
        self.scale_times(100, lambda row: row["method"] == "horner_bernstein")
        text = self.fine("compare", "a", "b")
        self.assertIn("ranks that changed", text)
        self.assertRegex(text, r"method horner_bernstein, .*: 1 in a, 5 in b")

    def test_many_bundles_give_one_table(self):
        shutil.copytree(BASELINE, self.folder / "c")
        self.scale_times(0.5)
        text = self.fine("compare", "a", "b", "c")
        ranks = [line.split()[:2] for line in text[text.index("\nrank ") + 1:].splitlines()[1:]]
        self.assertEqual(ranks, [["1", "b"], ["2", "a"], ["2", "c"]])
        self.assertEqual({row["bundle"] for row in self.compared("a", "b", "c")}, {"b", "c"})

    def test_tables_for_the_report(self):
        text = self.fine("compare", "a", "b", "--format", "csv", "--out", "tables/new")
        self.assertEqual((self.folder / "tables/new/comparison.csv").read_text(), text)
        self.assertEqual({path.name for path in (self.folder / "tables/new").iterdir()},
                         {"comparison.csv", "facts.csv", "standings.csv"})

    def test_part_of_a_suite_and_other_columns(self):
        """Rows are found by column name, whatever else an older or newer program writes."""
        suite = self.suite()
        self.bundle(suite, name="x")
        self.bundle(self.suite(STUDY, {**STUDY, "id": '"more"'}, name="more.toml"), name="y")
        text = self.fine("compare", "x", "y")
        self.assertIn("0 rows only in a, 2 only in b", text)
        self.assertIn("worst.csv is left out", text)
        path = self.folder / "x/accuracy.csv"
        lines = [line.split(",") for line in path.read_text().splitlines()]
        gone = lines[0].index("p50_error")
        path.write_text("".join(",".join(line[:gone] + line[gone + 1:]) + ",extra\n" for line in lines))
        self.list_anew("x")
        self.assertIn("\naccuracy identical in 2 rows\n", self.fine("compare", "x", "y"))

    # What it refuses.

    def test_refusals(self):
        self.refused(USAGE, ["compare", "a"], "two bundles")
        self.refused(USAGE, ["compare"], "BUNDLE is required")
        self.refused(USAGE, ["compare", "a", "b", "--fail-on", "slowr"], '--fail-on slowr: is not a gate; did you mean "slower"?')
        self.refused(USAGE, ["compare", "a", "b", "--fail-on", "costlier"], "do not have counts of one compiler in common")
        self.refused(USAGE, ["compare", "a", "b", "--threshold", "five"], "--threshold five: must be a share from 0 on")
        self.refused(USAGE, ["compare", "a", "b", "--out", "a"], "is a bundle itself")
        self.refused(INPUT_OUTPUT, ["compare", "a", "nowhere"], "nowhere: is not a bundle")
        (self.folder / "b/machine.json").write_text("{")
        self.refused(INPUT_OUTPUT, ["compare", "a", "b"], "b/machine.json: is not what SHA256SUMS lists")
        self.list_anew("b")
        self.refused(INPUT_OUTPUT, ["compare", "a", "b"], "b/machine.json:1:2: ")
        (self.folder / "b/machine.json").unlink()
        self.refused(INPUT_OUTPUT, ["compare", "a", "b"], "machine.json")

    def test_nothing_in_common(self):
        for name, seed in (("x", 1), ("y", 2)):
            self.bundle(self.suite(), "--seed", seed, name=name)
        self.refused(USAGE, ["compare", "x", "y"], "y: does not have a row in common with x")
        self.refused(USAGE, ["compare", "a", "x"], "does not have a row in common")

    def test_a_reader_that_leaves(self):
        shell = subprocess.run(["bash", "-c", f"'{PROGRAM}' compare a b | head -n 1"], cwd=self.folder, check=True,
                               capture_output=True, text=True)
        self.assertEqual((shell.stdout.count("\n"), shell.stderr), (1, ""))


if __name__ == "__main__":
    unittest.main()
