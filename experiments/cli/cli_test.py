#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The program from outside: exit codes, one-line messages, no file half-written. Usage: cli_test.py BEZIERBENCH"""
import csv
import decimal
import hashlib
import io
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.path.abspath(os.environ.get("BEZIERBENCH") or sys.argv.pop(1))
ROOT = pathlib.Path(__file__).resolve().parents[2]
REPORT_SUITE = ROOT / "experiments/suites/report.toml"

FINE, FINDING, USAGE, INPUT_OUTPUT, INTERRUPTED = 0, 1, 2, 4, 130
IN_MEMORY = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # where thousands of fsyncs take seconds only
ADVICE = r"; |must|write|see|from|did you mean|is empty"

METHOD_COLUMNS = ["id", "problem", "form", "min_degree", "max_degree", "bound", "bit_stable", "flops", "citation"]
PROJECT_COLUMNS = ["method", "t", "distance", "candidates", "exact_t", "exact_distance", "error"]
EVAL_COLUMNS = ["method", "t", "axis", "value", "exact", "error", "error_ulp", "error_u", "bound_u"]
BERNSTEIN = ["direct", "direct_pow", "de_casteljau", "de_casteljau_lerp", "horner_bernstein"]
POWER = ["power_sum", "horner"]
TO_POWER = ["factorial", "differences", "exact"]
TO_BERNSTEIN = ["forward_substitution", "positive_sum", "triangle", "exact"]

HEAD = ['schema_version = 1', '[suite]', 'id = "tiny"', 'title = "Tiny"', 'seed = 1']
STUDY = {"id": '"a"', "kind": '"accuracy"', "curve": '"bezier"', "degree": "[3]", "coordinate_range": "[1]",
         "trials": "50", "methods": '["direct", "de_casteljau"]'}
CONVERSION = {"id": '"c"', "kind": '"conversion"', "curve": '"bezier"', "degree": "[3, 5]",
              "coordinate_range": "[1]", "trials": "5", "replicates": "4",
              "methods": '["factorial+forward_substitution"]'}
TIMING = {"id": '"t"', "kind": '"timing"', "curve": '"bezier"', "degree": "[3]", "coordinate_range": "[1]"}


def lines_of(*studies, **changes):
    """The lines of a suite; `changes` go to its first study, None leaves a key out."""
    studies = [dict(study) for study in studies or [STUDY]]
    studies[0].update(changes)
    lines = list(HEAD)
    for study in studies:
        lines += ["[[study]]"] + [f"{key} = {value}" for key, value in study.items() if value is not None]
    return lines


def rows(text):
    return list(csv.DictReader(io.StringIO(text), strict=True))


class Case(unittest.TestCase):
    place = None  # where the test's folder is; None: the usual place for temporary files

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bezierbench-cli-", dir=self.place)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    # What a test needs to have, and to do.

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def suite(self, *studies, name="s.toml", **changes):
        return self.write(name, "\n".join(lines_of(*studies, **changes)) + "\n")

    def run_program(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL,
                   "timeout": 60, **options}
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, check=False, **options)

    def snapshot(self, folder="."):
        """Every name below a folder, with the bytes of files and the targets of links."""
        found = {}
        for path in sorted((self.folder / folder).rglob("*")):
            name = str(path.relative_to(self.folder))
            found[name] = os.readlink(path) if path.is_symlink() else path.is_dir() or path.read_bytes()
        return found

    def manifest(self, bundle):
        return json.loads((self.folder / bundle / "bundle.json").read_text())

    # What is expected.

    def assert_one_line(self, result, *needles):
        message = result.stderr.decode()
        self.assertRegex(message, r"\Abezierbench: [^\n]+\n\Z")
        self.assertTrue(message[:-1].isprintable(), message)
        self.assertRegex(message, ADVICE)
        for needle in needles:
            self.assertIn(needle, message)

    def refused(self, code, arguments, *needles, unchanged=True, alone=True, **options):
        """The program ends with `code` and one line that has the needles, prints nothing and changes no file; `alone`
        says whether no other writes there at the same time."""
        before = self.snapshot() if alone else None
        result = self.run_program(*arguments, **options)
        self.assertEqual(result.returncode, code, result)
        self.assertIn(result.stdout, (b"", None))
        self.assert_one_line(result, *needles)
        if not alone:
            return result
        after = self.snapshot()
        self.assertEqual([name for name in after if name.endswith(".tmp")], [])
        if unchanged:
            self.assertEqual(before, after)
        return result

    def fine(self, *arguments, **options):
        """The program's standard output; standard error stays empty."""
        result = self.run_program(*arguments, **options)
        self.assertEqual((result.returncode, result.stderr or b""), (FINE, b""), result)
        return (result.stdout or b"").decode()

    def our_methods(self):
        """The lines of `list methods` without those of other libraries, which a build may have as well."""
        return [row for row in rows(self.fine("list", "methods", "--format", "csv")) if not row["id"].startswith("peer_")]

    def bundle(self, *arguments, name="b", **options):
        """A complete bundle whose checksums hold."""
        arguments = arguments or [self.suite()]
        self.assertEqual(self.fine("run", *arguments, "--quiet", "--out", name, **options), "")
        self.assert_complete(name)
        return name

    def assert_complete(self, name):
        self.assertEqual(self.manifest(name)["state"], "complete")
        self.assertFalse((self.folder / name / "blocks").exists())
        subprocess.run(["sha256sum", "--check", "--strict", "--quiet", "SHA256SUMS"], cwd=self.folder / name,
                       check=True, capture_output=True)
        self.assertEqual(self.fine("verify", name), f"{name}: fine\n")

    def assert_not_complete(self, name):
        if (self.folder / name / "bundle.json").exists():
            self.assertEqual(self.manifest(name)["state"], "partial")


class CommandLine(Case):
    def test_parser_says_one_line(self):
        suite = self.suite()
        for arguments, needle in [
                ([], "subcommand"), (["rnu"], "rnu: unknown; did you mean \"run\"?"), (["list"], "subcommand"),
                (["list", "method"], "did you mean \"methods\"?"), (["curve"], "subcommand"),
                (["curve", "evl"], "did you mean \"eval\"?"), (["--nonsense"], "--help"),
                (["run"], "suites"), (["run", suite], "--out"), (["run", suite, "--out"], "--out"),
                (["run", "--out", "b"], "suites"), (["run", suite, "--out", "b", "--nonsense"], "--nonsense"),
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

    def test_what_is_not_there_yet(self):
        """Kinds and curves that no study takes are refused at once, not after hours."""
        for changes in ({"curve": '"rational"', "kind": '"conversion"', "methods": None}, {"kind": '"fitting"', "tolerance": "[1]"}):
            with self.subTest(changes=changes):
                self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"], 'study "a"')

    def test_file_that_cannot_be_read(self):
        for name in ("absent.toml", ".", "absent/s.toml"):
            with self.subTest(name=name):
                self.refused(USAGE, ["run", name, "--out", "b"], f"bezierbench: {name}: cannot be read")

    def test_methods_that_take_another_form(self):
        for changes in ({"methods": '["horner"]'}, {"baseline": '["power_sum"]'}, {"curve": '"polynomial"'}):
            with self.subTest(changes=changes):
                self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"], 'study "a"', "form")
        self.refused(USAGE, ["run", self.suite(CONVERSION, methods='["exact+exat"]'), "--out", "b"], '"exact"')


class Curves(Case):
    def setUp(self):
        super().setUp()
        self.curve = self.write("c.csv", "x,y\n0,0\n1,2\n3,1\n")

    def test_files_that_are_no_curve(self):
        for content, *needles in [
                ("", "c.csv:1: ", "empty"), ("x,y\n", "no coefficients"), ("x,y\n1,2\n3\n", "c.csv:3: ", "1 field"),
                ("x\n1,2\n", "c.csv:2: ", "2 fields"), ("x,y\n1,nan\n", "c.csv:2: ", "row 1, column y", '"nan"'),
                ("x,y\n1,2\ninf,1\n", "c.csv:3: ", "row 2, column x"), ("x\n-inf\n", "c.csv:2: ", '"-inf"'),
                ("x,y\n1,two\n", "c.csv:2: ", '"two"'), ("x\n1e999\n", "c.csv:2: "), ("x,y\n1,\n", "c.csv:2: ", "column y"),
                ("x\n 1\n", "c.csv:2: "), ("x\n1\n\n", "c.csv:3: "), ("a,b\n1,2\n", "c.csv:1: ", "a,b"),
                ("1,2\n3,4\n", "c.csv:1: "), ("y\n1\n", "c.csv:1: "), ("w\n1\n", "c.csv:1: "), ("x,x\n1,2\n", "c.csv:1: ", "twice"),
                ("x,y,z,v\n1,2,3,4\n", "c.csv:1: "), ("x,\n1,2\n", "c.csv:1: "), ("x\n1\0\n", "c.csv:2: ", "NUL"),
                ("x\n\x1b[31m\n", "c.csv:2: "), ('x\n"1\n', "c.csv:2: "), ('x\n"a\nb"\n', "c.csv:2: "),
                ("x\n" + "1\n" * 1025, "c.csv", "1025"), ("x,w,v\n1,1,1\n", "c.csv:1: "), ("x,z,w\n1,1,1\n", "c.csv:1: "),
                ("x,y,w\n1,2,3\n1,2,nan\n", "c.csv:3: ", "row 2, column w"), ("x,w\n1,inf\n", "c.csv:2: ", "column w"),
                ("x,w\n1,\n", "c.csv:2: ", "column w"), ("x,w\n1,0\n2,-0\n", "c.csv:2: ", "rows 1 to 2, column w", "0")]:
            with self.subTest(content=content[:30]):
                self.write("c.csv", content)
                self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", "c.csv", "--t", "0.5"], *needles)
                self.refused(INPUT_OUTPUT, ["curve", "convert", "--curve", "c.csv", "--method", "exact"], *needles)

    def test_files_that_cannot_be_read(self):
        for name in ("absent.csv", ".", "c.csv/c.csv"):
            with self.subTest(name=name):
                self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", name, "--t", "0"], f"bezierbench: {name}: ")

    def test_parameters(self):
        for t in ("nan", "inf", "-inf", "1e999", "half", "", "0.5x", "0,5"):
            with self.subTest(t=t):
                self.refused(USAGE, ["curve", "eval", "--curve", "c.csv", f"--t={t}"], "--t")

    def test_methods_that_do_not_apply(self):
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        convert = ["curve", "convert", "--curve", "c.csv"]
        for arguments, *needles in [
                (evaluate + ["--method", "hroner"], 'did you mean "horner"?'), (evaluate + ["--method", "zzz"], "zzz"),
                (evaluate + ["--method", "horner"], "horner", "bernstein form"),
                (evaluate + ["--form", "power", "--method", "direct"], "direct", "power form"),
                (evaluate + ["--method", "direct", "--method", "horner"], "horner"),
                (evaluate + ["--method", "factorial"], "factorial"), (convert + ["--method", "exat"], '"exact"'),
                (convert + ["--method", "direct"], "direct"), (convert + ["--method", "triangle"], "bernstein form"),
                (convert + ["--form", "power", "--method", "differences"], "power form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, arguments, *needles)

    def test_degree_beyond_a_method(self):
        self.write("c.csv", "x\n" + "1\n" * 172)
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        self.refused(USAGE, evaluate + ["--method", "direct"], "direct", "170", "171")
        self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", "factorial"], "170", "171")
        found = [row["method"] for row in rows(self.fine(*evaluate))]  # without --method: all that apply
        self.assertIn("de_casteljau", found)
        self.assertNotIn("direct", found)
        self.write("c.csv", "x\n" + "1\n" * 171)
        self.assertEqual(rows(self.fine(*evaluate, "--method", "direct"))[0]["exact"], "1")

    def test_output(self):
        text = self.fine("curve", "eval", "--curve", "c.csv", "--t", "-0.5", "0x1p-1", "--t", "1e-3", "--method",
                         "direct", "--method", "de_casteljau")
        found = rows(text)
        self.assertEqual(list(found[0]), EVAL_COLUMNS)
        self.assertEqual([(row["method"], float(row["t"]), row["axis"]) for row in found],
                         [(method, t, axis) for method in ("direct", "de_casteljau") for t in (-0.5, 0.5, 1e-3)
                          for axis in "xy"])
        for row in found:
            for column in EVAL_COLUMNS[3:8]:
                self.assertEqual(repr(float(row[column])), repr(float(row[column]) + 0.0))
        self.assertEqual([float(row["value"]) for row in found[2:4]], [1.25, 1.25])

    def test_derivative(self):
        self.write("w.csv", "x,y\n1,1\n3,1\n4,2\n6,3\n")  # the worked example of the seed document 000
        text = self.fine("curve", "derivative", "--curve", "w.csv", "--order", "2", "--t", "0", "--t", "0.5")
        found = rows(text)
        self.assertEqual(list(found[0]), EVAL_COLUMNS[:2] + ["order"] + EVAL_COLUMNS[2:])
        for row in found:
            truth = {("0", "x"): -6, ("0", "y"): 6, ("0.5", "x"): 0, ("0.5", "y"): 3}[row["t"], row["axis"]]
            self.assertEqual((float(row["exact"]), row["order"]), (truth, "2"))
            self.assertEqual(row["value"] == row["exact"], row["method"] != "seed_000" or row["t"] == "0")
        self.write("r.csv", "x,w\n0,1\n1,2\n")
        derivative = ["curve", "derivative", "--t", "0.5", "--curve"]
        for arguments, *needles in [
                (["w.csv", "--order", "-1"], "--order"), (["w.csv", "--order", "1.5"], "--order"), (["w.csv"], "--order"),
                (["r.csv", "--order", "1"], "r.csv", "column w"),
                (["w.csv", "--order", "1", "--method", "seed_00"], 'did you mean "seed_000"?'),
                (["w.csv", "--order", "1", "--method", "power_derivative"], "bernstein form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, derivative + arguments, *needles)

    def test_length(self):
        columns = ["method", "length", "error_estimate", "evaluations", "converged", "exact", "error"]
        self.write("cusp.csv", "x,y\n3,-3\n-1,3\n-1,-3\n3,3\n")  # 3 (u^2, u^3), u = 2t - 1: (13 sqrt(13) - 8) 2/9
        truth = decimal.Decimal("8.63825924022930240234")
        length = ["curve", "length", "--curve", "cusp.csv"]
        found = rows(self.fine(*length, "--tolerance", "1e-6"))
        self.assertEqual(list(found[0]), columns)
        self.assertEqual([row["converged"] for row in found], ["yes", "no", "yes", "yes"])
        for row in found:
            self.assertLess(abs(decimal.Decimal(row["exact"]) - truth), 1e-19)
            error = abs(decimal.Decimal(row["length"]) - decimal.Decimal(row["exact"]))
            self.assertLess(abs(float(error) - float(row["error"])), 1e-15)
            if row["converged"] == "yes":
                self.assertLessEqual(float(row["error"]), float(row["error_estimate"]))
                self.assertLessEqual(float(row["error"]), 1e-6 * float(row["exact"]))
        half = rows(self.fine(*length, "--to", "0.5", "--method", "gauss_legendre_adaptive"))
        self.assertLess(abs(decimal.Decimal(half[0]["exact"]) - truth / 2), 1e-19)
        for arguments, *needles in [
                (["--from", "0.6", "--to", "0.5"], "--from 0.6"), (["--to", "1.5"], "--to 1.5"), (["--tolerance", "0"], "--tolerance"),
                (["--form", "power"], "power form", "curve convert"),
                (["--method", "chord_sums"], 'did you mean "chord_sum"?')]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, length + arguments, *needles)

    def test_every_listed_method_evaluates(self):
        for form in ("bernstein", "power"):
            found = rows(self.fine("curve", "eval", "--curve", "c.csv", "--form", form, "--t", "0.25"))
            listed = self.our_methods()
            self.assertEqual(list(dict.fromkeys(row["method"] for row in found)),
                             [row["id"] for row in listed if row["problem"] == "evaluation" and row["form"] == form])
            for row in found:
                self.assertLessEqual(float(row["error_ulp"]), 4, row)

    def test_rational(self):
        """The quarter circle ((1-t^2)/(1+t^2), 2t/(1+t^2)): at 1/2 it is 3-4-5."""
        self.write("c.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        text = self.fine(*evaluate)
        found = rows(text)
        listed = rows(self.fine("list", "methods", "--format", "csv"))
        self.assertEqual(list(dict.fromkeys(row["method"] for row in found)),
                         [row["id"] for row in listed if row["form"] == "rational"])
        for row in found:
            self.assertEqual(row["exact"], {"x": "0.6", "y": "0.8"}[row["axis"]])
            self.assertLessEqual(float(row["error_ulp"]), 4, row)
        self.assertTrue(any(row["bound_u"] for row in found))
        self.write("c.csv", "w,y,x\n1,0,1\n1,1,1\n2,1,0\n")  # columns are found by name
        self.assertEqual(self.fine(*evaluate), text)
        for method in ("horner", "compensated_de_casteljau"):
            self.refused(USAGE, evaluate + ["--method", method], method, "column w")
        self.refused(USAGE, evaluate + ["--form", "power"], "--form power", "column w")
        self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", "exact"], "exact", "column w")
        self.refused(USAGE, ["curve", "eval", "--curve", self.write("p.csv", "x\n1\n"), "--t", "0", "--method",
                             "de_casteljau_farin"], "de_casteljau_farin", "column w")

    def test_rational_with_weights_of_both_signs(self):
        self.write("c.csv", "x,w\n1,1\n2,-3\n")  # the weights sum to 1 - 4t
        found = rows(self.fine("curve", "eval", "--curve", "c.csv", "--t", "0.5", "--method", "de_casteljau"))
        self.assertEqual([(row["exact"], row["value"], row["bound_u"]) for row in found], [("2.5", "2.5", "")])
        self.refused(USAGE, ["curve", "eval", "--curve", "c.csv", "--t", "0.5", "--t", "0.25"], "--t 0.25", "c.csv")

    def test_same_numbers_however_written(self):
        values = [(0.1, -1e-310), (1e308, 5e-324), (-3.25, 7.0)]
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.1"]
        texts = []
        for write, end in ((repr, "\n"), (float.hex, "\n"), (repr, "\r\n"), (lambda x: f'"{x!r}"', "\r\n")):
            self.write("c.csv", end.join(["x,y"] + [",".join(map(write, row)) for row in values]) + end)
            texts.append(self.fine(*evaluate))
            texts.append(self.fine(*evaluate[:-1], float.hex(0.1)))
        self.assertEqual(len(set(texts)), 1)
        self.write("c.csv", "\ufeffx,y\n" + "\n".join(f"{x!r},{y!r}" for x, y in values))  # no line end at the end
        self.assertEqual(self.fine(*evaluate), texts[0])

    def test_projection(self):
        self.write("c.csv", "x,y\n8,5\n-4,0\n6,3\n9,7\n")
        project = ["curve", "project", "--curve", "c.csv"]
        found = rows(self.fine(*project, "--point", "6,4"))
        self.assertEqual(list(found[0]), PROJECT_COLUMNS)
        self.assertEqual([row["method"] for row in found],
                         [row["id"] for row in self.our_methods() if row["problem"] == "projection"])
        for row in found:
            self.assertAlmostEqual(float(row["exact_t"]), 0.064530, 6)
            self.assertAlmostEqual(float(row["exact_distance"]), 0.141664, 6)
            self.assertAlmostEqual(float(row["error"]), float(row["distance"]) - float(row["exact_distance"]), 15)
        errors = {row["method"]: float(row["error"]) for row in found}
        self.assertLess(errors["quintic_isolate"], 1e-15)
        self.assertGreater(min(errors["scan_bisect"], errors["quintic_seed_002"]), 0.1)
        for arguments, *needles in [
                (["--point", "6"], "--point 6", "2"), (["--point", "6,4,1"], "3 coordinates"), (["--point", "6,nan"], "--point"),
                (["--point", ""], "--point"), (["--point", "6,"], "--point"), (["--point", "6,4", "--method", "direct"], "direct"),
                (["--point", "6,4", "--method", "scan_bisec"], '"scan_bisect"'),
                (["--point", "6,4", "--form", "power"], "power form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, project + arguments, *needles)
        self.write("c.csv", "x,y,z\n8,5,1\n-4,0,2\n")
        self.refused(USAGE, project + ["--point", "1,2,3", "--method", "quintic_seed_002"], "quintic_seed_002", "degree 1")
        self.assertEqual(len(rows(self.fine(*project, "--point", "1,2,-3"))), 5)
        self.write("c.csv", "x,y,w\n8,5,1\n-4,0,2\n")
        self.refused(USAGE, project + ["--point", "1,2"], "weights")
        self.refused(INPUT_OUTPUT, ["curve", "project", "--curve", "absent.csv", "--point", "1,2"], "absent.csv")

    def test_conversions_both_ways(self):
        for to_power in TO_POWER:
            self.write("q.csv", self.fine("curve", "convert", "--curve", "c.csv", "--method", to_power))
            self.assertEqual(rows((self.folder / "q.csv").read_text()),
                             [{"x": "0", "y": "0"}, {"x": "2", "y": "4"}, {"x": "1", "y": "-3"}])
            for to_bernstein in TO_BERNSTEIN:
                back = self.fine("curve", "convert", "--curve", "q.csv", "--form", "power", "--method", to_bernstein)
                for row, expected in zip(rows(back), rows((self.folder / "c.csv").read_text()), strict=True):
                    for axis in "xy":
                        self.assertAlmostEqual(float(row[axis]), float(expected[axis]), places=14)


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
        suites = {row["id"] for row in rows(self.fine("list", "suites", "--format", "csv"))}
        self.assertIn("report", suites)
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
        for content in ("", "{", "[]", '{"schema_version": 2}'):
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
        for limit in (0, 100, sizes["suite.toml"], inputs, sizes["accuracy.csv"] - 1):
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
                deadline = time.monotonic() + 20
                while not (self.folder / name / "bundle.json").exists() and time.monotonic() < deadline:
                    time.sleep(0.01)
                time.sleep(0.1)
                process.send_signal(which)
                out, err = process.communicate(timeout=20)
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
        lines = ""
        for name in ("accuracy.csv", "conversion.csv", "worst.csv"):
            lines += hashlib.sha256((self.folder / "b" / name).read_bytes()).hexdigest() + f"  {name}\n"
        self.assertEqual(self.manifest("b")["accuracy_digest"], hashlib.sha256(lines.encode()).hexdigest())

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
        self.assertEqual(self.fine("verify", "b"), "b: fine\n")
        self.refused(INPUT_OUTPUT, ["verify", "absent"], "bezierbench: absent: ")

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
        self.assertEqual(self.fine("verify", "b"), "b: fine\n")

    def test_timing_against_a_method_that_does_not_race(self):
        self.refused(USAGE, ["run", self.suite(TIMING, methods='["direct"]', baseline='"de_casteljau"'), "--out", "b"],
                     'study "t"', "de_casteljau")

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
