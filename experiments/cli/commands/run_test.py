#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`run` from outside: what it writes, its estimates, and how it ends when stopped. Usage: run_test.py BEZIERBENCH"""
import hashlib
import json
import os
import platform
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import (  # noqa: E402
    CAN_COUNT, CONVERSION, FINE, HAS_SANITIZER, INTERRUPTED, PATIENCE, PROGRAM, REPORT_SUITE, ROOT, STUDY, TIMING, USAGE, Case, rows)

sys.path.append(str(ROOT))
from scripts.digests import of_bundle  # noqa: E402


class Bundles(Case):
    def test_again_changes_nothing(self):
        self.bundle()
        before = self.snapshot()
        result = self.run_program("run", "s.toml", "--out", "b")
        self.assertEqual((result.returncode, result.stdout, result.stderr),
                         (FINE, b"", b"b: already complete, nothing to do\n"))
        self.assertEqual(self.fine("run", "s.toml", "--out", "b", "--quiet"), "")
        self.assertEqual(before, self.snapshot())

    def test_cycles_of_other_processors_take_llvm(self):
        if not CAN_COUNT or platform.machine() != "x86_64":
            self.skipTest("Valgrind is not installed or does not run this build, or the processor is another one")
        suite = self.suite(TIMING, methods='["direct", "horner_bernstein"]', modes='["point"]')
        os.chmod(self.folder / self.write("bin/valgrind", f'#!/bin/sh\nexec {shutil.which("valgrind")} "$@"\n'), 0o755)

        def costs(name, **options):
            result = self.run_program("run", suite, "--counts", "--no-timing", "--quiet", "--out", name, **options)
            self.assertEqual(result.returncode, FINE, result.stderr)
            return result, rows((self.folder / name / "cost.csv").read_text())
        said, without = costs("without", env={**os.environ, "PATH": str(self.folder / "bin")})
        self.assert_one_line(said, "no cycles of other processors: llvm-objdump-19 is not installed; install llvm-19")
        predicted = [column for column in without[0] if column.startswith(("cycles_", "latency_"))]
        self.assertEqual({row[column] for row in without for column in predicted}, {""})
        if not all(map(shutil.which, ("llvm-objdump-19", "llvm-mca-19"))):
            self.skipTest("LLVM 19 is not installed")
        said, counted = costs("with")
        self.assertEqual(said.stderr, b"")
        self.assertEqual([{**row, **dict.fromkeys(predicted, "")} for row in counted], without)
        for row in counted:
            for cycles, latency in zip(predicted[::2], predicted[1::2]):
                self.assertGreater(float(row[cycles]), 0.9 * float(row["instructions"]) / 6, "no more than six instructions begin in a cycle")
                self.assertGreater(float(row[latency]), float(row[cycles]))

    def test_another_run_is_refused(self):
        self.bundle()
        self.refused(USAGE, ["run", "s.toml", "--out", "b", "--seed", "77"], "b: ", "seed 1", "77")
        digest = self.manifest("b")["suites"]["digest"][:12]
        self.refused(USAGE, ["run", "s.toml", "--out", "b", "--trials", "51"], "b: ", "suite tiny", digest)
        self.refused(USAGE, ["run", "s.toml", "--out", "b", "--set", "degree=4", "--dry-run"], "b: ", digest)
        manifest = self.manifest("b")
        for key, what in (("program_version", "version"), ("git_commit", "commit"), ("fp_flags", "flags")):
            with self.subTest(key=key):
                self.write("b/bundle.json", json.dumps({**manifest, key: "theirs"}))
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], "b: ", what, "theirs", manifest[key])

    def test_dry_run_writes_nothing(self):
        self.suite(STUDY, TIMING, CONVERSION)
        before = self.snapshot()
        self.assertIn("evaluations", self.fine("run", "s.toml", "--out", "b/c", "--dry-run"))
        self.fine("run", "s.toml", "--out", "b", "--dry-run", "--trials", 2**63 - 1, "--set", "replicates=1")
        self.assertEqual(before, self.snapshot())

    def test_dry_run_has_no_estimate_of_searches_that_end_when_they_have_found_something(self):
        guarantees = {"id": '"g"', "kind": '"guarantees"', "degree": "[2]", "trials": "100", "budget": "1000000"}
        text = self.fine("run", self.suite(guarantees, STUDY), "--out", "dry", "--dry-run")
        self.assertRegex(text, r"estimated +\d.* of memory\nno estimate +for g: .*\nout +dry\n")
        self.assertNotIn("for a:", text)

    def estimated(self, suite, *options):
        """Seconds, megabytes of disk and of memory."""
        text = self.fine("run", suite, "--out", "dry", "--dry-run", *options)
        found = re.search(r"estimated +([\d.]+) s on one thread, ([\d.]+) MB of disk, ([\d.]+) MB of memory", text)
        return [float(number) for number in found.groups()]

    def test_dry_run_says_what_a_run_takes(self):
        """To an order of magnitude: costs are the same on every machine."""
        suite = self.suite({**STUDY, "degree": "[4, 20, 60]", "methods": None, "trials": "3000"},
                           {**CONVERSION, "degree": "[5, 30]", "trials": "400", "methods": None},
                           {**TIMING, "modes": '["point"]', "methods": '["direct", "de_casteljau"]'})
        estimated = self.estimated(suite)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.bundle(suite, "--jobs", "1", timeout=PATIENCE)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.assertLess(estimated[0] / seconds, 10)
        if not HAS_SANITIZER:  # with one, a run takes some ten times as long
            self.assertGreater(estimated[0] / seconds, 1 / 10)
        bundle = sum(path.stat().st_size for path in (self.folder / "b").iterdir()) / 1e6
        self.assertGreater(estimated[1], bundle / 2)  # files of blocks come on top

    def test_dry_run_computes_nothing_that_takes_long(self):
        """A trial of the first takes hours, one of the second half a second."""
        bspline = {"id": '"s"', "kind": '"bspline"', "degree": "[150]", "trials": "1"}
        projection = {"id": '"p"', "kind": '"projection"', "degree": "[90]", "trials": "10"}
        begin = time.monotonic()
        self.assertGreater(self.estimated(self.suite(bspline))[0], 60)
        self.assertLess(self.estimated(self.suite(projection))[0], 60)
        self.estimated("quick", "--only", "quick*-bezier*", "--set", "degree=1021")
        self.assertLess(time.monotonic() - begin, 10)

    def test_estimates_of_time_grow_with_trials(self):
        """Also where nothing could wait for the run that they speak of."""
        suite = self.suite({**STUDY, "degree": "[20]"})
        few, many = (self.estimated(suite, "--trials", str(trials))[0] for trials in (10**8, 10**12))
        self.assertGreater(many / few, 10**4 / 4)
        self.assertLess(many / few, 10**4 * 4)

    def test_no_timing(self):
        self.bundle(self.suite(STUDY, TIMING), "--no-timing")
        names = {path.name for path in (self.folder / "b").iterdir()}
        self.assertIn("accuracy.csv", names)
        self.assertEqual([name for name in names if "timing" in name], [])

    def test_same_bytes_everywhere(self):
        """With one thread and with many, and in any locale."""
        self.suite({**STUDY, "trials": "1100", "degree": "[3, 12]", "replicates": "2", "methods": None,
                    "scalar": '["double", "float"]', "dimension": "[1, 2, 3]"}, CONVERSION)
        plain = dict(os.environ, LC_ALL="C", LANG="C")
        german = dict(os.environ, LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8", TZ="Asia/Tokyo", COLUMNS="20")
        kept = []
        for name, options, environment in (("one", ["--jobs", "1"], plain), ("four", ["--jobs", "4"], german),
                                           ("default", [], None)):
            self.bundle("s.toml", *options, name=name, env=environment)
            kept.append({path.name: path.read_bytes() for path in (self.folder / name).iterdir()
                         if path.name not in ("machine.json", "SHA256SUMS")})
        self.assertLessEqual({"accuracy.csv", "conversion.csv", "suite.toml", "bundle.json"}, set(kept[0]))
        for other in kept[1:]:
            self.assertEqual(kept[0], other)
        self.write("c.csv", "x,y\n0.1,1e300\n1,2\n")
        self.assertEqual(*(self.fine("curve", "eval", "--curve", "c.csv", "--t", "0.3", env=environment)
                           for environment in (plain, german)))

    def test_digest_is_that_of_the_contract(self):
        self.bundle(self.suite(STUDY, CONVERSION))
        text = (self.folder / "b/digests.csv").read_bytes()
        self.assertEqual(text.decode(), of_bundle(self.folder / "b"))
        self.assertEqual({row["table"] for row in rows(text.decode())}, {"accuracy.csv", "conversion.csv", "worst.csv"})
        self.assertEqual(self.manifest("b")["accuracy_digest"], hashlib.sha256(text).hexdigest())

    def test_a_method_that_is_added_changes_no_digest(self):
        """Though it comes first and worst.csv gives its rows other numbers."""
        self.bundle(self.suite(STUDY, CONVERSION))
        self.suite({**STUDY, "methods": '["horner_bernstein", "direct", "de_casteljau"]'}, CONVERSION)
        self.bundle("s.toml", name="more")
        before, after = (set((self.folder / name / "digests.csv").read_text().splitlines()) for name in ("b", "more"))
        self.assertLess(before, after)
        self.assertEqual({line.split(",")[2] for line in after - before}, {"horner_bernstein"})
        self.assertRegex(self.fine("compare", "b", "more"), r"\n0 +1 +accuracy.csv, a horner_bernstein\n")

    def test_verify_says_how_much_the_timed_kernels_judged(self):
        """direct_pow has no kernel for groups; of de_casteljau the first trial of each block goes through both."""
        self.bundle(self.suite(degree="[4]", trials="1030", methods='["de_casteljau", "direct_pow"]'))
        counts = {row["method"]: int(row["own_kernel"]) for row in self.table("b/reference.csv")}
        self.assertEqual(counts["direct_pow"], 1030)
        self.assertIn(counts["de_casteljau"], (2, 1030))  # the latter on a processor without kernels for groups
        told = self.fine("verify", "b").splitlines()[1]
        self.assertIn(f"of 2060 evaluations that accuracy studies judged, {sum(counts.values())} went through", told)

    def test_timing(self):
        """What is in the files; never how long anything took."""
        modes = ["point", "one_shot"]
        self.bundle(self.suite(TIMING, degree="[1, 2, 3]", methods='["horner_bernstein", "de_casteljau"]',
                               modes=json.dumps(modes), baseline='"horner_bernstein"'))
        table = self.table("b/timing.csv")
        timed = [row for row in table if row["method"] != "sentinel"]
        self.assertEqual(len({tuple(row[key] for key in ("method", "scalar", "degree", "mode")) for row in timed}),
                         2 * 3 * 2)
        for row in timed:
            self.assertEqual((row["checked"], row["relative_to"]), ("yes", "horner_bernstein"), row)
            self.assertIn(row["quality"], ("ok", "noisy"))
            self.assertGreaterEqual(int(row["rounds"]), 41)
            self.assertGreater(float(row["median_ns"]), 0)
            self.assertLessEqual(float(row["ratio_low"]), float(row["ratio"]))
            self.assertLessEqual(float(row["ratio"]), float(row["ratio_high"]))
            self.assertEqual(row["cycles"] == "", row["instructions"] == "")
        sentinels = [row for row in table if row["method"] == "sentinel"]
        self.assertEqual([row["mode"] for row in sentinels], modes)
        self.assertEqual({(row["dimension"], row["degree"], row["checked"]) for row in sentinels}, {("", "", "yes")})
        complexity = self.table("b/complexity.csv")
        self.assertEqual(len(complexity), 2 * 2)
        for row in complexity:
            self.assertEqual(row["claimed"], {"de_casteljau": "2", "horner_bernstein": "1"}[row["method"]])
            self.assertIn(row["verdict"], ("within", "above", "unresolved"))
        counters = json.loads((self.folder / "b/machine.json").read_text())["counters"]
        self.assertEqual(counters.startswith("unavailable: "), timed[0]["cycles"] == "")
        self.assertEqual(self.fine("verify", "b").splitlines()[0], "b: fine")

    def test_report_scorecard(self):
        self.bundle(REPORT_SUITE, "--only", "2.3.1-bezier", "--trials", "20", "--set", "replicates=20")
        cells = self.table("b/scorecard.csv")
        self.assertEqual({(cell["table"], cell["form"]) for cell in cells}, {("2.3.1", "bernstein")})
        for cell in cells:
            self.assertIn(cell["verdict"], ("inside", "edge"), "the ends of a band of 20 repetitions are not known")
            for column in ("published", "ours_median", "ours_p05", "ours_p95", "continuous_median", "against_exact"):
                self.assertGreaterEqual(float(cell[column]), 0)
            self.assertLessEqual(float(cell["ours_p05"]), float(cell["ours_p95"]))


class Interruption(Case):
    def interrupted(self, name, suite, which):
        """The seconds from the signal to the end."""
        with subprocess.Popen([PROGRAM, "run", suite, "--out", name], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            try:
                deadline = time.monotonic() + PATIENCE
                while not (self.folder / name / "bundle.json").exists() and time.monotonic() < deadline:
                    time.sleep(0.01)
                time.sleep(0.1)
                process.send_signal(which)
                begin = time.monotonic()
                out, err = process.communicate(timeout=PATIENCE)
                taken = time.monotonic() - begin
            finally:
                process.kill()
        result = subprocess.CompletedProcess([], process.returncode, out, err)
        self.assertEqual((result.returncode, result.stdout), (INTERRUPTED, b""), result)
        self.assert_one_line(result, f"{name}: interrupted", "run the same command again")
        self.assertEqual(self.manifest(name)["state"], "partial")
        for left in ("accuracy.csv", "conversion.csv"):
            self.assertFalse((self.folder / name / left).exists())
        self.assertEqual([name for name in self.snapshot() if name.endswith(".tmp")], [])
        return taken

    def test_long_studies_end_soon(self):
        most = str(2**63 - 1)
        for study in (STUDY, CONVERSION):
            for degree in ("[3]", "[500]"):
                for which in (signal.SIGINT, signal.SIGTERM):
                    with self.subTest(kind=study["kind"], degree=degree, signal=which):
                        suite = self.suite(study, degree=degree, trials=most, replicates="1",
                                           methods='["exact"]' if study is CONVERSION else None)
                        self.interrupted(f"b{len(list(self.folder.iterdir()))}", suite, which)

    def test_a_trial_that_takes_hours_ends_within_a_second(self):
        suite = self.suite({"id": '"s"', "kind": '"bspline"', "degree": "[150]", "trials": "1"})
        for which in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=which):
                self.assertLess(self.interrupted(f"b{which}", suite, which), 2)

    def test_another_run_goes_on(self):
        self.interrupted("b", self.suite(trials="2000000000"), signal.SIGINT)
        self.refused(USAGE, ["run", self.suite(), "--out", "b"], "b: ", "suite", "choose another --out")


if __name__ == "__main__":
    unittest.main()
