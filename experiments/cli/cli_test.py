#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The program from outside: exit codes, one-line messages, no file half-written. Usage: cli_test.py BEZIERBENCH"""
import hashlib
import json
import os
import re
import resource
import shlex
import signal
import subprocess
import sys
import time
import unittest

from program_case import (BERNSTEIN, CONVERSION, FINDING, FINE, HAS_THREAD_SANITIZER, HEAD, INPUT_OUTPUT,
                          INTERRUPTED, METHOD_COLUMNS, PATIENCE, POWER, PROGRAM, REPORT_SUITE, ROOT, STUDY, TIMING,
                          TO_BERNSTEIN, TO_POWER, USAGE, Case, lines_of, rows)

sys.path.append(str(ROOT))
from report.digests import of_bundle  # noqa: E402


class CommandLine(Case):
    def test_parser_says_one_line(self):
        suite = self.suite()
        for arguments, needle in [
                ([], "subcommand"), (["rnu"], "rnu: unknown; did you mean \"run\"?"), (["list"], "subcommand"),
                (["list", "method"], "did you mean \"methods\"?"), (["curve"], "subcommand"),
                (["curve", "evl"], "did you mean \"eval\"?"), (["--nonsense"], "--help"),
                (["run"], "suites"), (["run", suite], "--out"), (["run", suite, "--out"], "--out"),
                (["run", "--out", "b"], "suites"), (["run", suite, "--out", "b", "--nonsense"], "--nonsense"),
                (["run", suite, "--oot", "b"], "--oot: unknown option; did you mean \"--out\"?"),
                (["run", suite, "--oot=b"], "--oot: unknown option; did you mean \"--out\"?"),
                (["list", "methods", "--fromat", "csv"], "did you mean \"--format\"?"),
                (["curve", "at-length", "--curve", "c", "--fractoin", "1"], "did you mean \"--fraction\"?"),
                (["rnu", "--help"], "rnu: unknown; did you mean \"run\"?"), (["--help", "rnu"], "rnu: unknown"),
                (["curve", "evl", "--help"], "did you mean \"eval\"?"), (["run", "--oot", "b", "--help"], "--oot"),
                (["run", suite, "--out", ""], "--out"), (["run", suite, "--out", "b", "--out", "c"], "--out"),
                (["verify"], "bundle"), (["verify", "b", "c"], "c"), (["curve", "eval", "--t", "0"], "--curve"),
                (["curve", "eval", "--curve", "c"], "--t"), (["curve", "convert", "--curve", "c"], "--method"),
                (["curve", "eval", "--curve", "c", "--t", "0", "--form", "beta"], "beta"),
                (["list", "methods", "--format", "xml"], "xml")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, arguments, needle)

    def test_values_of_options(self):
        run = ["run", self.suite(), "--out", "b"]
        for arguments, needle in [
                (["--jobs", "0"], "--jobs"), (["--jobs", "x"], "--jobs"), (["--jobs", "99999999999999999999"], "--jobs"),
                (["--seed", "-1"], "--seed -1"), (["--seed", "x"], "--seed x"), (["--seed", "1.5"], "--seed 1.5"),
                (["--seed", "99999999999999999999"], "--seed 99999999999999999999"),
                (["--trials", "0"], "--trials 0"), (["--trials", "-3"], "--trials -3"), (["--trials", "x"], "--trials x"),
                (["--trials", "99999999999999999999"], "--trials"), (["--reference", "guess"], "guess"),
                (["--only", "z*"], "--only z*"), (["--set", "degree"], "axis=v1,v2"), (["--set", "degree="], "no value"),
                (["--set", "=3"], "axis"), (["--set", "degre=3"], "did you mean \"degree\"?"),
                (["--set", "id=x"], "unknown axis \"id\""), (["--set", "degree=x"], "--set degree=x"),
                (["--set", "degree=1.5"], "whole"), (["--set", "degree=-1"], "0 to"), (["--set", "degree=9999"], "0 to"),
                (["--set", "degree=3,3"], "twice"), (["--set", "coordinate_range=nan"], "finite"),
                (["--set", "coordinate_range=inf"], "finite"), (["--set", "coordinate_range=-1"], "negative"),
                (["--set", "t_interval=0"], "intervals"), (["--set", "t_interval=1:0"], "a <= b"),
                (["--set", "t_interval=0:nan"], "finite"), (["--set", "scalar=doubel"], "did you mean \"double\"?"),
                (["--set", "generator=dyadc"], "did you mean \"dyadic\"?"), (["--set", "dimension=4"], "1, 2 or 3"),
                (["--set", "methods=horne_bernstein"], "did you mean \"horner_bernstein\"?"),
                (["--set", "replicates=1000000000000"], "replicates"), (["--set", "trials=1,2"], "one value"),
                (["--set", "degree=1", "--set", "degree=2"], "keep one"),
                (["--set", "generator=integer", "--set", "coordinate_range=0.5"], "from 1 to 2^53"),
                (["--set", "coordinate_range=1e39", "--set", "scalar=float"], "largest float")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, run + arguments, needle)

    def test_no_timing_leaves_nothing(self):
        self.refused(USAGE, ["run", self.suite(TIMING), "--no-timing", "--out", "b"], "--no-timing")

    def test_doctor(self):
        """Warnings are no failure: few machines are free of them."""
        lines = [line.split(maxsplit=1) for line in self.fine("doctor").replace("floating point", "arithmetic").splitlines()]
        self.assertEqual([aspect for aspect, _ in lines],
                         ["arithmetic", "clock", "governor", "boost", "load", "virtualised", "counters"])
        for aspect, text in lines:
            self.assertIn(text.split()[0], ("fine", "warning"), aspect)

    def test_help_and_version(self):
        self.assertIn("run", self.fine("--help"))
        self.assertIn("--out", self.fine("run", "--help"))
        self.assertTrue(self.fine("--version").startswith("bezierbench "))


class Examples(Case):
    def test_of_the_readme(self):
        """Those on committed bundles work as they stand there."""
        lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
        examples = [shlex.split(line, comments=True) for line in lines if line.startswith("    bezierbench ")]
        whole = [words[1:] for words in examples if "results/baseline" in words and not {"DIR", "&&"} & set(words)]
        self.assertLessEqual({"trials", "choose"}, {words[0] for words in whole})
        for words in whole:
            with self.subTest(words=words):
                self.assertTrue(self.fine(*(str(ROOT / word) if word.startswith("results/") else word for word in words)))


class Suites(Case):
    def at(self, key, lines, needle, key_line=None):
        """`lines` are refused with the line of `key`, and a column."""
        self.write("s.toml", "\n".join(lines) + "\n")
        number = key_line or 1 + next(k for k, line in enumerate(lines) if line.startswith(key))
        result = self.refused(USAGE, ["run", "s.toml", "--out", "b"], needle)
        self.assertRegex(result.stderr.decode(), rf"\Abezierbench: s\.toml:{number}:[1-9][0-9]*: ")

    def test_values(self):
        for key, value, needle in [
                ("kind", '"acuracy"', 'did you mean "accuracy"?'), ("kind", "3", "kind"), ("kind", '""', "kind"),
                ("curve", '"bezir"', 'did you mean "bezier"?'), ("curve", "[1]", "curve"),
                ("methods", '["de_castlejau"]', 'did you mean "de_casteljau"?'), ("methods", '["zz*"]', '"zz*"'),
                ("methods", '["direct", "direct"]', "twice"), ("methods", '"direct"', "methods"),
                ("methods", "[1]", "methods"), ("generator", '["continous"]', 'did you mean "continuous"?'),
                ("generator", "[]", "a value in it"), ("generator", '"report"', "generator"),
                ("baseline", '["exakt"]', 'did you mean "exact"?'), ("baseline", "[]", "a value in it"),
                ("published", '"report_table.csv"', 'did you mean "report_tables.csv"?'), ("published", "1", "published"),
                ("degree", "3", "degree"), ("degree", '["x"]', "whole number"), ("degree", "[1.5]", "whole number"),
                ("degree", "[]", "degree"), ("degree", "[-1]", "0 to"), ("degree", "[1024]", "0 to"),
                ("degree", "[99999999999]", "0 to"), ("degree", "[3, 3]", "twice"), ("degree", "[nan]", "whole number"),
                ("coordinate_range", "[nan]", "finite"), ("coordinate_range", "[inf]", "finite"),
                ("coordinate_range", '["nan"]', "finite"), ("coordinate_range", "[-1]", "negative"),
                ("coordinate_range", "[]", "a value in it"), ("coordinate_range", "[true]", "number"),
                ("coordinate_range", '["1e999"]', "number"), ("t_interval", "[[0, nan]]", "finite"),
                ("t_interval", "[[-inf, 1]]", "finite"), ("t_interval", "[[1, 0]]", "a <= b"),
                ("t_interval", "[0, 1]", "intervals"), ("t_interval", "[[0]]", "intervals"), ("t_interval", "[]", "a value in it"),
                ("dimension", "[4]", "1, 2 or 3"), ("dimension", "[]", "a value in it"), ("scalar", '["half"]', "scalar"),
                ("scalar", "[]", "a value in it"), ("trials", "0", "at least 1"), ("trials", "[5]", "whole number"),
                ("trials", "nan", "whole number"), ("replicates", "0", "at least 1"), ("modes", '["point"]', "timing"),
                ("id", '"a b"', "id"), ("id", '""', "id"), ("id", "7", "string"), ("title", "7", "string")]:
            with self.subTest(key=key, value=value):
                self.at(f"{key} =" if key not in ("id", "title") else key, lines_of(**{key: value}), needle,
                        key_line=7 if key == "id" else 14 if key == "title" else None)

    def test_values_that_do_not_fit_together(self):
        self.at("coordinate_range", lines_of(generator='["integer"]', coordinate_range="[10, 0.5]"), "0.5")
        self.at("coordinate_range", lines_of(scalar='["float"]', coordinate_range="[1e39]"), "float")
        self.at("generator", lines_of(generator='["weights_mild"]'), "only rational curves have")
        self.at("generator", lines_of(curve='"rational"', generator='["continuous"]'), "weights_mild, weights_wild")
        self.at("degree", lines_of(generator='["multiple_root"]', degree="[34]"), "up to degree 33")

    def test_structure(self):
        for lines, line, needle in [
                (HEAD, 1, "no study"), (HEAD[:1] + lines_of()[5:], 1, "[suite] is missing"),
                (lines_of()[1:], 1, "schema_version"), (["schema_version = 2"] + lines_of()[1:], 1, "schema_version"),
                (lines_of(kind=None), 6, "kind is missing"), (lines_of(id=None), 6, "id is missing"),
                (lines_of(degree=None), 6, "degree is missing"), (lines_of(degre="[3]"), 14, 'did you mean "degree"?'),
                (lines_of() + ["[suit]"], 14, 'did you mean "suite"?'),
                (HEAD + ["sed = 2"] + lines_of()[5:], 6, 'did you mean "seed"?'),
                (HEAD[:4] + ["seed = -1"] + lines_of()[5:], 5, "seed"),
                (HEAD[:4] + ["seed = nan"] + lines_of()[5:], 5, "seed"),
                (lines_of(STUDY, STUDY), 15, 'another study has the id "a"'),
                (lines_of() + ["dimension = ["], 14, "not TOML"), (lines_of() + ["degree = [3]"], 14, "not TOML"),
                (lines_of() + ['x = "a'], 14, "not TOML"), (["schema_version = = 1"], 1, "not TOML"), ([""], 1, "schema")]:
            with self.subTest(lines=lines):
                self.at("", lines, needle, key_line=line)

    def test_bytes_that_are_no_text(self):
        for content in (b"schema_version = 1\0\n", b"\xff\xfe\n", b"title = \"\x1b[31m\"\n", bytes(range(256))):
            with self.subTest(content=content[:30]):
                self.write("s.toml", content)
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], "s.toml:1:")

    def test_line_ends_and_byte_order_mark(self):
        self.write("s.toml", "\ufeff" + "\r\n".join(lines_of()) + "\r\n")
        self.bundle("s.toml")

    def test_ids_are_unique_over_files(self):
        self.suite()
        other = "\n".join(lines_of()).replace("tiny", "other")
        self.write("other.toml", other)
        self.write("fine.toml", other.replace('"a"', '"b"'))
        self.refused(USAGE, ["run", "s.toml", "other.toml", "--out", "b"], "other.toml", 'study "a"', '"tiny"', '"other"')
        self.refused(USAGE, ["run", "s.toml", "s.toml", "--out", "b"], "s.toml", 'the id "tiny"')
        self.bundle("s.toml", "fine.toml")
        self.bundle("b/suite.toml", name="again")  # the resolved suites are a suite file
        self.assertEqual(self.manifest("b"), self.manifest("again"))

    def test_what_the_plan_refuses(self):
        """At once, not after hours, with the place of the key; of the study where the key is left out."""
        for study, changes, key, needle in [
                (CONVERSION, {"curve": '"rational"', "methods": None}, "curve", "polynomial"),
                (TIMING, {"methods": '["gauss_legendre_24"]', "modes": '["one_shot"]'}, None, "tolerance"),
                (TIMING, {"methods": '["direct"]', "baseline": '"de_casteljau"'}, "baseline", "de_casteljau"),
                (STUDY, {"id": '"d"', "kind": '"derivative"', "order": "[1]", "curve": '"rational"'}, "curve", "derivatives"),
                (TIMING, {"kind": '"arc_length"', "tolerance": "[1e-6]", "t_interval": "[[0, 2]]"}, "t_interval", "within")]:
            asked = {**study, **changes}
            lines = lines_of({**STUDY, "degree": "[2]"}, asked)
            header = len(lines) - lines[::-1].index("[[study]]")
            found = [number for number, line in enumerate(lines, 1) if number > header and key and line.startswith(f"{key} =")]
            place = f"s.toml:{found[0]}:" if found else f"s.toml:{header}:1: "
            with self.subTest(asked=asked):
                self.write("s.toml", "\n".join(lines) + "\n")
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], f"bezierbench: {place}", needle)

    def test_file_that_cannot_be_read(self):
        for name in ("absent.toml", ".", "absent/s.toml"):
            with self.subTest(name=name):
                self.refused(USAGE, ["run", name, "--out", "b"], f"bezierbench: {name}: cannot be read")

    def test_methods_that_take_another_form(self):
        for changes in ({"methods": '["horner"]'}, {"baseline": '["power_sum"]'}, {"curve": '"polynomial"'}):
            with self.subTest(changes=changes):
                self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"], 'study "a"', "form")
        self.refused(USAGE, ["run", self.suite(CONVERSION, methods='["exact+exat"]'), "--out", "b"], '"exact"')


class Lists(Case):
    def test_methods(self):
        found = {(row["id"], row["problem"], row["form"]): row for row in self.our_methods()}
        self.assertEqual(list(next(iter(found.values()))), METHOD_COLUMNS)
        expected = ([(method, "evaluation", "bernstein") for method in BERNSTEIN]
                    + [(method, "evaluation", "power") for method in POWER]
                    + [(f"{step}:{method}", "evaluation", "bernstein") for step in TO_POWER for method in POWER]
                    + [(f"{step}:{method}", "evaluation", "power") for step in TO_BERNSTEIN for method in BERNSTEIN]
                    + [(step, "conversion", "bernstein") for step in TO_POWER]
                    + [(step, "conversion", "power") for step in TO_BERNSTEIN])
        self.assertEqual([key for key in expected if key not in found], [])
        for row in found.values():
            if row["problem"] in ("evaluation", "conversion"):
                self.assertEqual(row["min_degree"], "0")
                self.assertGreaterEqual(int(row["max_degree"]), 170)
            self.assertIn(row["bit_stable"], ("yes", "no"))
            self.assertTrue(row["citation"] and row["flops"], row)

    def test_others(self):
        shipped = rows(self.fine("list", "suites", "--format", "csv"))
        suites = {row["id"] for row in shipped}
        self.assertIn("report", suites)
        for row in shipped:
            if not row["id"].endswith("peers"):  # whose time is that of other libraries
                self.assertGreater(int(row["seconds"]), 0, row["id"])
        studies = rows(self.fine("list", "studies", "--format", "csv"))
        self.assertLessEqual({row["suite"] for row in studies}, suites)
        self.assertLessEqual({"2.2", "2.3.1-bezier", "2.4-polynomial"}, {row["id"] for row in studies})
        generators = {row["id"]: row for row in rows(self.fine("list", "generators", "--format", "csv"))}
        self.assertLessEqual({"continuous", "dyadic", "integer", "report"}, set(generators))
        self.assertLessEqual({"weights_mild", "weights_wild"}, {k for k, row in generators.items() if row["weights"]})
        for topic in ("methods", "suites", "studies", "generators"):
            self.assertNotEqual(self.fine("list", topic), self.fine("list", topic, "--format", "csv"))
            self.assertEqual(self.fine("list", "--format", "csv", topic), self.fine("list", topic, "--format", "csv"))


class StandardStreams(Case):
    def commands(self):
        self.write("c.csv", "x\n1\n2\n")
        return [["curve", "eval", "--curve", "c.csv", "--t", "0.5"], ["curve", "convert", "--curve", "c.csv", "--method",
                "exact"], ["list", "methods"], ["list", "methods", "--format", "csv"], ["--help"], ["--version"],
                ["run", self.suite(), "--out", "b", "--dry-run"]]

    def test_full_output(self):
        for command in self.commands():
            with self.subTest(command=command), open("/dev/full", "wb") as full:
                self.refused(INPUT_OUTPUT, command, "standard output", stdout=full)

    def test_closed_output(self):
        for command in self.commands():
            with self.subTest(command=command):
                self.refused(INPUT_OUTPUT, command, "standard output", preexec_fn=lambda: os.close(1))

    def test_broken_pipe(self):
        for command in self.commands():
            for restore_signals in (True, False):  # False: SIGPIPE ignored, as Python does
                with self.subTest(command=command, restore_signals=restore_signals):
                    reader, writer = os.pipe()
                    os.close(reader)
                    result = self.run_program(*command, stdout=writer, restore_signals=restore_signals)
                    os.close(writer)
                    if restore_signals:
                        self.assertEqual((result.returncode, result.stderr), (-signal.SIGPIPE, b""))
                    else:
                        self.assertEqual(result.returncode, INPUT_OUTPUT)
                        self.assert_one_line(result, "standard output")

    def test_messages_that_cannot_be_written(self):
        suite = self.suite()
        with open("/dev/full", "wb") as full:
            self.assertEqual(self.run_program("nonsense", stderr=full).returncode, USAGE)
            self.assertEqual(self.run_program("run", suite, "--out", "a", stderr=full).returncode, FINE)
            self.assertEqual(self.run_program("run", suite, "--out", "a", stderr=full).returncode, FINE)
        closed = self.run_program("run", suite, "--out", "b", preexec_fn=lambda: (os.close(0), os.close(1), os.close(2)))
        self.assertEqual(closed.returncode, FINE)
        self.assert_complete("a")
        self.assert_complete("b")


class Places(Case):
    """Where results go, and where they cannot."""

    def test_places_that_are_none(self):
        self.suite()
        self.write("file", "mine")
        self.write("full/mine.txt", "mine")
        self.write("full/suite.toml", "mine")
        (self.folder / "loop").symlink_to("loop")
        for out in ("file", "file/b", "file/deep/b", "full", "loop", "loop/b", "/dev/null", "/proc/b", "n" * 300):
            with self.subTest(out=out):
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", out], f"bezierbench: {out}: ", "choose")

    def test_damaged_bundle(self):
        self.bundle()
        for content in ("", "{", "[]", '{"schema_version": 9}'):
            with self.subTest(content=content):
                self.write("b/bundle.json", content)
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", "b"], "b/bundle.json")

    def test_existing_and_deep_folders(self):
        (self.folder / "empty").mkdir()
        self.bundle(self.suite(), name="empty")
        self.bundle("s.toml", name="deep/deeper/b")

    def test_no_room(self):
        self.suite(degree="[" + ", ".join(map(str, range(40))) + "]", methods=None, trials="1", dimension="[1, 2]")
        self.bundle("s.toml", name="good")
        sizes = {path.name: path.stat().st_size for path in (self.folder / "good").iterdir()}
        inputs = max(sizes[name] for name in ("suite.toml", "machine.json", "methods.csv"))
        self.assertGreater(sizes["accuracy.csv"], inputs + 1)
        nothing = 1 if HAS_THREAD_SANITIZER else 0
        for limit in (nothing, 100, sizes["suite.toml"], inputs, sizes["accuracy.csv"] - 1):
            with self.subTest(limit=limit):
                self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", f"b{limit}"], f"b{limit}/", "choose another --out",
                             unchanged=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assert_not_complete(f"b{limit}")
                self.bundle("s.toml", name=f"b{limit}")  # once there is room
                self.assertEqual(self.manifest(f"b{limit}"), self.manifest("good"))


class Interruption(Case):
    def interrupted(self, name, suite, which):
        with subprocess.Popen([PROGRAM, "run", suite, "--out", name], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            try:
                deadline = time.monotonic() + PATIENCE
                while not (self.folder / name / "bundle.json").exists() and time.monotonic() < deadline:
                    time.sleep(0.01)
                time.sleep(0.1)
                process.send_signal(which)
                out, err = process.communicate(timeout=PATIENCE)
            finally:
                process.kill()
        result = subprocess.CompletedProcess([], process.returncode, out, err)
        self.assertEqual((result.returncode, result.stdout), (INTERRUPTED, b""), result)
        self.assert_one_line(result, f"{name}: interrupted", "run the same command again")
        self.assertEqual(self.manifest(name)["state"], "partial")
        for left in ("accuracy.csv", "conversion.csv"):
            self.assertFalse((self.folder / name / left).exists())
        self.assertEqual([name for name in self.snapshot() if name.endswith(".tmp")], [])

    def test_long_studies_end_soon(self):
        most = str(2**63 - 1)
        for study in (STUDY, CONVERSION):
            for degree in ("[3]", "[500]"):
                for which in (signal.SIGINT, signal.SIGTERM):
                    with self.subTest(kind=study["kind"], degree=degree, signal=which):
                        suite = self.suite(study, degree=degree, trials=most, replicates="1",
                                           methods='["exact"]' if study is CONVERSION else None)
                        self.interrupted(f"b{len(list(self.folder.iterdir()))}", suite, which)

    def test_another_run_goes_on(self):
        self.interrupted("b", self.suite(trials="2000000000"), signal.SIGINT)
        self.refused(USAGE, ["run", self.suite(), "--out", "b"], "b: ", "suite", "choose another --out")


class Bundles(Case):
    def test_again_changes_nothing(self):
        self.bundle()
        before = self.snapshot()
        result = self.run_program("run", "s.toml", "--out", "b")
        self.assertEqual((result.returncode, result.stdout, result.stderr),
                         (FINE, b"", b"b: already complete, nothing to do\n"))
        self.assertEqual(self.fine("run", "s.toml", "--out", "b", "--quiet"), "")
        self.assertEqual(before, self.snapshot())

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

    def test_dry_run_counts_the_time_of_races(self):
        """Few evaluations, repeated until they can be timed."""
        degrees = str(list(range(1, 11)))
        self.assertLess(self.estimated(self.suite({**STUDY, "degree": degrees, "trials": "1"}))[0], 0.5)
        self.assertGreater(self.estimated(self.suite({**TIMING, "degree": degrees, "methods": '["direct", "de_casteljau"]'}))[0], 1)

    def estimated(self, suite, *options):
        """Seconds, megabytes of disk and of memory."""
        text = self.fine("run", suite, "--out", "dry", "--dry-run", *options)
        found = re.search(r"estimated +([\d.]+) s on one thread, ([\d.]+) MB of disk, ([\d.]+) MB of memory", text)
        return [float(number) for number in found.groups()]

    def test_dry_run_says_what_a_run_takes(self):
        """Within a factor of 2 on a machine at rest (scripts/check estimate); here of 4, for others may be at work."""
        suite = self.suite({**STUDY, "degree": "[4, 20, 60]", "methods": None, "trials": "3000"},
                           {**CONVERSION, "degree": "[5, 30]", "trials": "400", "methods": None},
                           {**TIMING, "modes": '["point"]', "methods": '["direct", "de_casteljau"]'})
        estimated = self.estimated(suite)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.bundle(suite, "--jobs", "1")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.assertLess(estimated[0] / seconds, 4)
        self.assertGreater(estimated[0] / seconds, 1 / 4)
        bundle = sum(path.stat().st_size for path in (self.folder / "b").iterdir()) / 1e6
        self.assertGreater(estimated[1], bundle / 2)  # files of blocks come on top

    def test_estimates_grow_with_trials(self):
        """Also where nothing could wait for the run that they speak of."""
        suite = self.suite({**STUDY, "degree": "[20]"})
        few, many = (self.estimated(suite, "--trials", str(trials))[0] for trials in (10**8, 10**12))
        self.assertGreater(many / few, 10**4 / 4)
        self.assertLess(many / few, 10**4 * 4)
        alone, repeated = (self.estimated(suite, "--trials", "1", "--set", f"replicates={n}")[2] for n in (1, 10**6))
        self.assertGreater(repeated - alone, 30)  # two methods, two statistics of 8 bytes each, a million times
        self.assertLess(repeated - alone, 500)

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
        self.assertEqual(text.decode(), of_bundle(self.folder / "b", 2))
        self.assertEqual({row["table"] for row in rows(text.decode())}, {"accuracy.csv", "conversion.csv", "worst.csv"})
        self.assertEqual(self.manifest("b")["accuracy_digest"], hashlib.sha256(text).hexdigest())

    def test_a_method_that_is_added_changes_no_digest(self):
        """Though it comes first and other rows of worst.csv are numbered anew."""
        self.bundle(self.suite(STUDY, CONVERSION))
        self.suite({**STUDY, "methods": '["horner_bernstein", "direct", "de_casteljau"]'}, CONVERSION)
        self.bundle("s.toml", name="more")
        before, after = (set((self.folder / name / "digests.csv").read_text().splitlines()) for name in ("b", "more"))
        self.assertLess(before, after)
        self.assertEqual({line.split(",")[2] for line in after - before}, {"horner_bernstein"})
        self.assertIn("by table, study and method: 5 agree, 2 only in b\n    only in b: accuracy.csv, study a, method horner_bernstein\n",
                      self.fine("compare", "b", "more"))

    def test_a_bundle_of_an_earlier_schema_version_is_not_continued(self):
        self.suite()
        self.fine("run", "s.toml", "--quiet", "--out", "b", "--shard", "1/2")
        self.write("b/bundle.json", json.dumps({**self.manifest("b"), "schema_version": 1}))
        self.refused(USAGE, ["run", "s.toml", "--out", "b"], "b: holds results of schema version 1, this run has 2; choose another --out")

    def test_verify_finds_damage(self):
        self.bundle()
        for name in ("accuracy.csv", "suite.toml", "machine.json"):
            with self.subTest(name=name):
                path = self.folder / "b" / name
                good = path.read_bytes()
                path.write_bytes(good[:-2] + bytes([good[-2] ^ 1]) + good[-1:])
                result = self.run_program("verify", "b")
                self.assertEqual((result.returncode, result.stdout), (FINDING, b""))
                self.assertIn(f"b/{name}: checksum differs", result.stderr.decode())
                path.write_bytes(good)
        self.assertEqual(self.fine("verify", "b").splitlines()[0], "b: fine")
        self.refused(INPUT_OUTPUT, ["verify", "absent"], "bezierbench: absent: ")

    def test_verify_says_how_much_the_timed_kernels_judged(self):
        """direct_pow has no kernel for groups; of de_casteljau the first trial of each block goes through both."""
        self.bundle(self.suite(degree="[4]", trials="1030", methods='["de_casteljau", "direct_pow"]'))
        counts = {row["method"]: int(row["own_kernel"]) for row in rows((self.folder / "b/reference.csv").read_text())}
        self.assertEqual(counts["direct_pow"], 1030)
        self.assertIn(counts["de_casteljau"], (2, 1030))  # the latter on a processor without kernels for groups
        told = self.fine("verify", "b").splitlines()[1]
        self.assertIn(f"of 2060 evaluations that accuracy studies judged, {sum(counts.values())} went through", told)

    def test_degrees_beyond_a_method(self):
        self.bundle(self.suite(degree="[170, 171]", trials="5", baseline='["exact", "direct"]'))
        table = rows((self.folder / "b/accuracy.csv").read_text())
        statuses = {(row["method"], row["degree"], row["baseline"]): row for row in table}
        self.assertEqual({key: row["status"] for key, row in statuses.items()},
                         {("direct", "170", "exact"): "ok", ("direct", "171", "exact"): "degree_unsupported",
                          ("de_casteljau", "170", "exact"): "ok", ("de_casteljau", "171", "exact"): "ok",
                          ("de_casteljau", "170", "direct"): "ok",
                          ("de_casteljau", "171", "direct"): "baseline_degree_unsupported"})
        columns = list(table[0])
        for row in table:
            numbers = [row[column] for column in columns[columns.index("status") + 1:]]
            if row["status"] == "ok":
                self.assertTrue(all(map(float, filter(None, numbers[:7]))), row)
            else:
                self.assertEqual(set(numbers), {""}, row)

    def test_no_method_to_time(self):
        self.bundle(self.suite(TIMING, degree="[171]", methods='["direct"]'))
        self.assertEqual(rows((self.folder / "b/timing.csv").read_text()), [])

    def test_timing(self):
        """What is in the files; never how long anything took."""
        modes = ["point", "batch", "latency", "one_shot"]
        self.bundle(self.suite(TIMING, degree="[1, 2, 3]", methods='["horner_bernstein", "de_casteljau"]',
                               scalar='["double", "float"]', modes=json.dumps(modes), baseline='"horner_bernstein"'))
        table = rows((self.folder / "b/timing.csv").read_text())
        timed = [row for row in table if row["method"] != "sentinel"]
        self.assertEqual(len({tuple(row[key] for key in ("method", "scalar", "degree", "mode")) for row in timed}),
                         2 * 2 * 3 * 4)
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
        complexity = rows((self.folder / "b/complexity.csv").read_text())
        self.assertEqual(len(complexity), 2 * 2 * 4)
        for row in complexity:
            self.assertEqual(row["claimed"], {"de_casteljau": "2", "horner_bernstein": "1"}[row["method"]])
            self.assertIn(row["verdict"], ("within", "above", "unresolved"))
        counters = json.loads((self.folder / "b/machine.json").read_text())["counters"]
        self.assertEqual(counters.startswith("unavailable: "), timed[0]["cycles"] == "")
        self.assertEqual(self.fine("verify", "b").splitlines()[0], "b: fine")

    def test_report_scorecard(self):
        self.bundle(REPORT_SUITE, "--only", "2.3.1-bezier", "--trials", "20", "--set", "replicates=20")
        cells = rows((self.folder / "b/scorecard.csv").read_text())
        self.assertEqual({(cell["table"], cell["curve"]) for cell in cells}, {("2.3.1", "bezier")})
        for cell in cells:
            self.assertIn(cell["verdict"], ("inside", "outside", "explained"))
            for column in ("published", "ours_median", "ours_p05", "ours_p95", "continuous_median", "against_exact"):
                self.assertGreaterEqual(float(cell[column]), 0)
            self.assertLessEqual(float(cell["ours_p05"]), float(cell["ours_p95"]))


if __name__ == "__main__":
    unittest.main()
