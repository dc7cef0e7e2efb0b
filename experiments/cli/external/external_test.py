# SPDX-License-Identifier: MIT
"""External methods: the examples in experiments/examples, and faulty methods."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program_case import FINDING, FINE, PROGRAM, ROOT, STUDY, TIMING, USAGE, Case, rows  # noqa: E402

EXAMPLES = ROOT / "experiments/examples"
INCLUDE = next((str(base / "include") for base in pathlib.Path(PROGRAM).parents
                if (base / "include/bezierbench/plugin.h").exists()), None)
ANSWER = f"{sys.executable} {EXAMPLES}/program/mine.py"
SMALL = {"trials": "300", "degree": "[1, 3]", "methods": '["de_casteljau", "horner_bernstein"]'}


def compiled(folder, source, name, *options):
    """A shared object from C or C++; the test is skipped where there is no compiler."""
    compiler = shutil.which("c++" if str(source).endswith("cpp") else "cc")
    if compiler is None or INCLUDE is None:
        raise unittest.SkipTest("no C compiler, or no bezierbench/plugin.h beside the program")
    out = folder / name
    subprocess.run([compiler, "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC", f"-I{INCLUDE}",
                    *options, str(source), "-o", str(out)], check=True)
    return out


class External(Case):
    def program(self, name, text):
        return f"{sys.executable} {self.folder / self.write(name + '.py', text)}"

    def external_rows(self, bundle, table="accuracy.csv", external=True):
        return [row for row in self.table(f"{bundle}/{table}")
                if row["method"].startswith(("plugin_", "program_", "answers_", "own_")) == external]

    def assert_others_unchanged(self, with_external, without, tables=("accuracy.csv", "worst.csv", "reference.csv")):
        """All deterministic rows of other methods are those of a run without the method, byte for byte."""
        theirs_only = {row["method"] for table in tables for row in self.external_rows(with_external, table)}
        for name in (*tables, "digests.csv"):
            lines = (self.folder / without / name).read_text().splitlines()
            theirs = (self.folder / with_external / name).read_text().splitlines()
            self.assertEqual([line for line in theirs if not theirs_only.intersection(line.split(","))], lines, name)

    def assert_numbers_of(self, given, ours):
        """Rows of an external method have the numbers of our method, which computes the same."""
        numbers = [key for key in given[0] if key.endswith(("_error", "_error_u", "_ulp", "_relative")) or key == "non_finite"]
        self.assertEqual(len(given), len(ours))
        for a, b in zip(given, ours):
            self.assertEqual([a["status"], *(a[key] for key in numbers)], ["ok", *(b[key] for key in numbers)])

    def ours(self, bundle, method="de_casteljau"):
        return [row for row in self.external_rows(bundle, external=False) if row["method"] == method]

    def replayed(self, bundle, method, *options):
        worst = [row for row in self.external_rows(bundle, "worst.csv") if row["method"] == method]
        self.assertTrue(worst)
        self.assertIn(": the same\n", self.fine("replay", bundle, worst[0]["worst_id"], *options))
        return worst[0]["worst_id"]


class Page(unittest.TestCase):
    def test_the_snippet_is_the_example(self):
        """The program in docs/own_method.md is the text of an example below its opening comment."""
        text = (EXAMPLES / "cpp/mine.cpp").read_text()
        self.assertIn("\n" + text[text.index("#include"):] + "```\n", (ROOT / "docs/own_method.md").read_text())


class Ways(External):
    def test_program(self):
        suite = self.suite(**SMALL)
        self.bundle(suite, name="without")
        self.bundle(suite, "--program", ANSWER)
        self.assert_others_unchanged("b", "without")
        self.assert_numbers_of(self.external_rows("b"), self.ours("b"))
        self.assertIn("program_mine", (self.folder / "b/suite.toml").read_text())
        worst = self.replayed("b", "program_mine", "--program", ANSWER)
        self.refused(USAGE, ["replay", "b", worst], "program_mine")
        # The same command again has nothing to do; another method is another run; shards come to the same bytes.
        self.assertEqual(self.fine("run", suite, "--program", ANSWER, "--quiet", "--out", "b"), "")
        self.refused(USAGE, ["run", suite, "--out", "b"], "resolved suite")
        for k in (1, 2):
            self.fine("run", suite, "--program", ANSWER, "--quiet", "--shard", f"{k}/2", "--out", f"shard{k}")
        self.fine("merge", "--quiet", "shard1", "shard2", "--out", "merged")
        for name in ("accuracy.csv", "worst.csv", "suite.toml", "digests.csv", "methods.csv"):
            self.assertEqual((self.folder / "merged" / name).read_bytes(), (self.folder / "b" / name).read_bytes(), name)

    def test_a_merge_names_the_study_of_missing_blocks(self):
        """Also after a study without methods of ours, which has no job of its own."""
        suite = self.suite({**STUDY, "id": '"theirs"', "methods": '["program_mine"]'}, {**STUDY, "id": '"ours"'})
        self.fine("run", suite, "--program", ANSWER, "--quiet", "--shard", "1/9", "--out", "s")
        self.refused(FINDING, ["merge", "s", "--out", "m"], "blocks are missing, the first of study \"theirs, program_mine\"")

    def test_replicates(self):
        """Blocks of several replicates go into one process; the numbers are those of our method."""
        suite = self.suite(**{**SMALL, "trials": "30", "replicates": "70", "baseline": '["exact", "horner_bernstein"]'})
        self.bundle(suite, "--program", ANSWER)
        self.assert_numbers_of(self.external_rows("b"), self.ours("b"))

    def test_plugin(self):
        mine = compiled(self.folder, EXAMPLES / "plugin/mine.c", "mine.so")
        timing = {**TIMING, "modes": '["point"]', "methods": '["de_casteljau"]'}
        suite = self.suite({**STUDY, **SMALL}, timing)
        self.bundle(suite, name="without")
        self.bundle(suite, "--plugin", mine)
        self.assert_others_unchanged("b", "without")
        self.assert_numbers_of(self.external_rows("b"), self.ours("b"))
        self.replayed("b", "plugin_mine", "--plugin", mine)
        timed, = self.external_rows("b", "timing.csv")
        self.assertEqual((timed["checked"], timed["relative_to"], timed["mode"]), ("yes", "de_casteljau", "point"))
        self.assertGreater(float(timed["median_ns"]), 0)

    def test_float(self):
        """A plug-in in float only and a command in both precisions have the numbers of our method in theirs."""
        command = self.program("rounds", """
            import struct, sys
            def rounded(x): return struct.unpack("f", struct.pack("f", x))[0] if scalar == "float" else x
            *_, dimension, degree, count, scalar = (sys.stdin.readline() + " double").split()[:7]
            print("program_rounds bernstein float double")
            for line in sys.stdin:
                t, *b = map(float.fromhex, line.split())
                while len(b) > int(dimension):
                    b = [rounded(rounded(rounded(1 - t) * x) + rounded(t * y)) for x, y in zip(b, b[int(dimension):])]
                print(*b)
            """.replace("\n            ", "\n"))
        optional = compiled(self.folder, EXAMPLES / "plugin/optional.c", "optional.so")
        both = {"scalar": '["float", "double"]'}
        suite = self.suite({**STUDY, **SMALL, **both}, {**TIMING, **both, "modes": '["point"]', "methods": '["de_casteljau"]'})
        given = ("--program", command, "--plugin", optional)
        self.bundle(suite, "--no-timing", name="without")
        self.bundle(suite, *given)
        self.assert_numbers_of([row for row in self.external_rows("b") if row["method"] == "program_rounds"], self.ours("b"))
        in_float = [row for row in self.external_rows("b") if row["method"] == "plugin_optional"]
        self.assert_numbers_of(in_float, [row for row in self.ours("b") if row["scalar"] == "float"])
        self.assertEqual([(row["method"], row["scalar"], row["checked"]) for row in self.external_rows("b", "timing.csv")],
                         [("plugin_optional", "float", "yes")])
        for method in ("program_rounds", "plugin_optional"):
            self.replayed("b", method, *given)
        self.refused(USAGE, ["run", self.suite(**SMALL), "--out", "c", "--plugin", optional], "study a: it is in double only")

    def test_other_problems(self):
        """The halves of a plug-in have the numbers of our method; lengths by chords have the error of chords, the fourth part
        with twice as many; the nearest of 501 points is at most 1/1000 of t away."""
        text = """
            import math, sys
            header = (sys.stdin.readline() + " double none").split()[:8]
            dimension, problem = int(header[3]), header[7]
            print("program_chords_STEPS bernstein 1 20 arc_length projection")
            def point(t):
                row = b
                while len(row) > 1:
                    row = [[(1 - t) * x + t * y for x, y in zip(p, q)] for p, q in zip(row, row[1:])]
                return row[0]
            for line in sys.stdin:
                numbers = [float.fromhex(word) for word in line.split()]
                count = 3 if problem == "arc_length" else dimension
                given, rest = numbers[:count], numbers[count:]
                b = [rest[k:k + dimension] for k in range(0, len(rest), dimension)]
                if problem == "arc_length":
                    ends = [point(given[0] + (given[1] - given[0]) * k / STEPS) for k in range(STEPS + 1)]
                    print(math.fsum(map(math.dist, ends, ends[1:])))
                else:
                    distance, t = min((math.dist(point(k / 500), given), k / 500) for k in range(501))
                    print(t, distance)
            """.replace("\n            ", "\n")
        optional = compiled(self.folder, EXAMPLES / "plugin/optional.c", "optional.so")
        commands = [word for steps in ("100", "200") for word in ("--program", self.program(f"chords{steps}", text.replace("STEPS", steps)))]
        common = {"curve": '"bernstein"', "degree": "[3]"}
        suite = self.suite({"id": '"length"', "kind": '"arc_length"', **common, "trials": "20", "t_interval": "[[0.25, 0.5]]",
                            "tolerance": "[1e-3, 1e-6]"},
                           {"id": '"nearest"', "kind": '"projection"', **common, "trials": "5"},
                           {"id": '"halves"', "kind": '"subdivision"', **common, "trials": "300"})
        self.bundle(suite, name="without")
        self.bundle(suite, *commands, "--plugin", optional)
        self.assert_others_unchanged("b", "without", ("arc_length.csv", "projection.csv", "subdivision.csv"))
        given = self.external_rows("b", "subdivision.csv")
        ours = self.external_rows("b", "subdivision.csv", external=False)
        self.assert_numbers_of(given, [row for row in ours if row["method"] == "de_casteljau_split"])
        lengths = self.external_rows("b", "arc_length.csv")
        self.assertEqual([row["tolerance"] for row in lengths], ["0.001", "1e-06"] * 2)
        for coarse, fine in zip(lengths[:2], lengths[2:]):
            self.assertAlmostEqual(float(coarse["mean_error"]) / float(fine["mean_error"]), 4, delta=0.1)
        for row in self.external_rows("b", "projection.csv"):
            self.assertLessEqual(float(row["p50_t_error"]), 1 / 1000, row)
        broken = text.replace("STEPS", "0").replace("/ 0)", "/ 1)").replace("print(math", "sys.exit(3); print(math")
        result = self.run_program("run", suite, "--only", "length", "--program", self.program("broken", broken), "--quiet", "--out", "d")
        self.assertEqual(result.returncode, FINE, result)
        self.assert_complete("d")
        self.assertEqual({(row["status"], row["max_error"], row["non_finite"]) for row in self.external_rows("d", "arc_length.csv")},
                         {("exited", "", "")})

    def test_answers(self):
        suite = self.suite(**{**SMALL, "trials": "50"})
        seed = ("--seed", 2**53 + 1)  # which no double has
        self.fine("inputs", suite, *seed, "--out", "questions.csv")
        answered = subprocess.run([sys.executable, EXAMPLES / "answers/answer.py", self.folder / "questions.csv"],
                                  check=True, capture_output=True, text=True).stdout
        self.write("mine.csv", answered)
        self.bundle(suite, *seed, name="without")
        judged = rows(self.fine("judge", "mine.csv"))
        self.assertEqual([row["method"] for row in judged], ["answers_mine"] * 2)
        self.assert_numbers_of(judged, self.ours("without"))
        self.assertEqual(self.fine("judge", "mine.csv", "--out", "b"), "")
        self.assert_complete("b")
        self.assertEqual(self.external_rows("b"), judged)
        self.replayed("b", "answers_mine", "--answers", "mine.csv")
        # A cell with a missing answer, or with an input that is not the suite's, has no numbers.
        lines = answered.splitlines()
        lines[1] = lines[1].rsplit(",", 3)[0] + ",,,"
        self.write("gap.csv", "\n".join(lines) + "\n")
        result = self.run_program("judge", "gap.csv")
        self.assertEqual((result.returncode, [row["status"] for row in rows(result.stdout.decode())]),
                         (FINDING, ["missing", "ok"]))
        # A changed input is not in the suite, and neither is any input of a study that does not exist.
        changed = answered.splitlines()
        fields = changed[2].split(",")
        fields[12] = "0x1.8p-1"  # t
        self.write("changed.csv", "\n".join([*changed[:2], ",".join(fields), *changed[3:]]) + "\n")
        result = self.run_program("judge", "changed.csv")
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"changed.csv:3: 1 input is not in this suite", result.stderr)
        self.write("renamed.csv", answered.replace(",a,", ",b,"))
        result = self.run_program("judge", "renamed.csv")
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"suite tiny with this seed has no study b with these 100 inputs", result.stderr)
        for wrong in ("1e300", "1.5", "nan"):
            self.write("wrong.csv", answered.replace(f",{seed[1]},", f",{wrong},"))
            self.refused(4, ["judge", "wrong.csv"], "seed is not a whole number")

    def test_own(self):
        program = pathlib.Path(os.environ.get("BEZIERBENCH_OWN") or
                               pathlib.Path(PROGRAM).parent / "examples/bezierbench_own_example")
        if not program.exists():
            self.skipTest("the example of the harness is not built: experiments/examples/cpp")
        methods = '["de_casteljau_lerp"]'
        both = {"scalar": '["float", "double"]', "methods": methods}
        suite = self.suite({**STUDY, **SMALL, **both}, {**TIMING, **both, "modes": '["point"]'})
        self.bundle(suite, name="without")
        subprocess.run([program, "run", suite, "--quiet", "--out", "b"], cwd=self.folder, check=True)
        self.assert_complete("b")
        self.assert_others_unchanged("b", "without")
        self.assert_numbers_of(self.external_rows("b"), self.ours("b", "de_casteljau_lerp"))
        self.assertEqual([(row["scalar"], row["checked"]) for row in self.external_rows("b", "timing.csv")],
                         [("float", "yes"), ("double", "yes")])
        listed = subprocess.run([program, "list", "methods", "--format", "csv"], check=True, capture_output=True, text=True)
        self.assertEqual(rows(listed.stdout)[-1]["id"], "own_lerp")
        worst = self.external_rows("b", "worst.csv")[0]["worst_id"]
        replayed = subprocess.run([program, "replay", "b", worst], cwd=self.folder, check=True, capture_output=True, text=True)
        self.assertIn(": the same\n", replayed.stdout)


class Faults(External):
    FAULTS = ["ok", "crashed", "timed_out", "non_finite", "refused", "exited"]

    def test_faulty_plugins(self):
        plugins = [compiled(self.folder, EXAMPLES / "plugin/faulty.c", f"faulty{k}.so", f"-DFAULT={k}")
                   for k in range(len(self.FAULTS))]
        throws = compiled(self.folder, self.folder / self.write("throws.cpp", """
            #include <bezierbench/plugin.h>
            extern "C" {
            static void* prepare(const struct bezierbench_curve*) { throw 1; }
            static void evaluate(const void*, const double*, size_t, double*) {}
            static const struct bezierbench_method method = {1, "plugin_throws", "", BEZIERBENCH_BERNSTEIN, 0, 100,
                                                             prepare, evaluate, nullptr};
            const struct bezierbench_method* bezierbench_plugin(void) { return &method; }
            }"""), "throws.so")
        suite = self.suite(**{**SMALL, "degree": "[3]"})
        self.bundle(suite, name="without")
        given = [word for plugin in [*plugins, throws] for word in ("--plugin", str(plugin))]
        result = self.run_program("run", suite, *given, "--external-seconds", "5", "--quiet", "--out", "b")
        self.assertEqual((result.returncode, result.stdout), (FINE, b""), result.stderr)
        self.assertIn(b"plugin_faulty_1: crashed in study a: signal 6", result.stderr)
        self.assert_complete("b")
        self.assert_others_unchanged("b", "without")
        status = {row["method"]: row["status"] for row in self.external_rows("b")}
        expected = {f"plugin_faulty_{k}": word for k, word in enumerate(self.FAULTS)}
        self.assertEqual(status, {**expected, "plugin_throws": "threw"})
        for row in self.external_rows("b"):
            self.assertEqual(bool(row["max_error"]), row["status"] == "ok", row)
        wrong = next(row for row in self.external_rows("b") if row["method"] == "plugin_faulty_0")
        self.assertGreater(float(wrong["max_error_u"]), 1e12)  # the first control point in place of the curve's

    def test_faulty_programs(self):
        answer = "import sys\ncount = int(sys.stdin.readline().split()[-1])\nprint('program_NAME')\n"
        texts = {"malformed": "print('0 word\\n' * count)", "few": "print('0 0\\n' * (count - 1))",
                 "exits": "sys.exit(count > 0)", "hangs": "\nwhile count > 0: pass",
                 "dies": "import os\nif count > 0: os.abort()", "nan": "print('nan nan\\n' * count)",
                 "some": "if count > 0: print('nan 0\\n' + '0 0\\n' * (count - 1))"}
        given = [word for name, text in texts.items()
                 for word in ("--program", self.program(name, answer.replace("NAME", name) + text))]
        suite = self.suite(**{**SMALL, "degree": "[3]"})
        self.bundle(suite, name="without")
        result = self.run_program("run", suite, *given, "--external-seconds", "5", "--quiet", "--out", "b")
        self.assertEqual((result.returncode, result.stdout), (FINE, b""), result.stderr)
        self.assert_complete("b")
        self.assert_others_unchanged("b", "without")
        status = {row["method"][len("program_"):]: row["status"] for row in self.external_rows("b")}
        self.assertEqual(status, {"malformed": "malformed", "few": "malformed", "exits": "exited",
                                  "hangs": "timed_out", "dies": "crashed", "nan": "non_finite", "some": "ok"})
        self.assertEqual([row["non_finite"] for row in self.external_rows("b") if row["method"] == "program_some"], ["1"])
        self.assertIn(b"program_some: non_finite in study a: 1 of 600 coordinates", result.stderr)
        self.assertIn(b"program_nan: non_finite in study a: 600 of 600 coordinates", result.stderr)

    def test_a_failure_while_timed_leaves_no_time(self):
        given = [word for k in (1, 4) for word in
                 ("--plugin", compiled(self.folder, EXAMPLES / "plugin/faulty.c", f"faulty{k}.so", f"-DFAULT={k}"))]
        suite = self.suite({**TIMING, "modes": '["point"]', "methods": '["de_casteljau"]'})
        result = self.run_program("run", suite, *given, "--quiet", "--out", "b", timeout=600)
        self.assertEqual((result.returncode, result.stdout), (FINE, b""), result.stderr)
        self.assert_complete("b")
        self.assertEqual(self.external_rows("b", "timing.csv"), [])
        self.assertEqual([(row["method"], row["degree"], row["mode"], row["status"]) for row in self.external_rows("b", "untimed.csv")],
                         [("plugin_faulty_1", "3", "point", "crashed"), ("plugin_faulty_4", "3", "point", "refused")])

    def test_faults_only_while_timed(self):
        """The race has the status of the fault; wrong answers are a finding of the run."""
        words = ["exited", "timed_out", "wrong"]
        given = [word for k in range(len(words)) for word in
                 ("--plugin", compiled(self.folder, EXAMPLES / "plugin/late.c", f"late{k}.so", f"-DFAULT={k}"))]
        suite = self.suite({**TIMING, "modes": '["point"]', "methods": '["de_casteljau"]'})
        start = time.monotonic()
        result = self.run_program("run", suite, *given, "--external-seconds", "3", "--quiet", "--out", "b", timeout=600)
        self.assertLess(time.monotonic() - start, 100)  # one repetition runs into the limit, not each
        self.assertEqual({row["method"]: row["status"] for row in self.external_rows("b", "untimed.csv")},
                         {f"plugin_late_{k}": word for k, word in enumerate(words) if word != "wrong"})
        timed, = self.external_rows("b", "timing.csv")
        self.assertEqual((timed["method"], timed["checked"]), ("plugin_late_2", "no"))
        self.assertEqual(result.returncode, FINDING)
        self.assertIn(b"what was timed did not give what was judged: study t, method plugin_late_2", result.stderr)
        self.assertEqual(self.run_program("verify", "b").returncode, FINDING)

    def test_a_method_that_no_study_uses_is_refused(self):
        length = {"id": '"length"', "kind": '"arc_length"', "curve": '"bernstein"', "degree": "[3]", "trials": "2", "tolerance": "[1e-3]"}
        self.refused(USAGE, ["run", self.suite(length), "--out", "b", "--program", ANSWER],
                     "program_mine: no study asks it, of study length: it is of kind arc_length")
        suite = self.suite({**STUDY, **SMALL}, length, {**STUDY, "id": '"power"', "curve": '"power"', "methods": '["horner"]'},
                           {**STUDY, "id": '"float"', "scalar": '["float"]'}, TIMING)
        told = self.run_program("run", suite, "--out", "b", "--program", ANSWER, "--dry-run").stderr.decode()
        for sentence in ("length: it is of kind arc_length", "power: its curves are in power form, the method takes bernstein form",
                         "float: it is in float only", "t: its methods are timed, and only a shared object or a compiled-in method can be timed"):
            self.assertIn(f"program_mine: is not asked in study {sentence}\n", told)
        high = self.program("high", "import sys\nsys.stdin.read()\nprint('program_high bernstein 7 9')")
        self.refused(USAGE, ["run", self.suite(**SMALL), "--out", "b", "--program", high],
                     "program_high: no study asks it, of study a: its degrees are 1, 3, the method takes 7 to 9")
        self.refused(USAGE, ["run", self.suite(**{**SMALL, "methods": '["program_high"]'}), "--out", "b", "--program", high],
                     "s.toml:", "program_high", "its degrees are 1, 3, the method takes 7 to 9")

    def test_invalid_methods_are_refused(self):
        suite = self.suite(**SMALL)
        self.write("text.so", "no shared object")
        self.write("leaves.c", "#include <stdlib.h>\n__attribute__((constructor)) static void leave(void) { exit(0); }\n")
        compiled(self.folder, self.folder / "leaves.c", "leaves.so")
        for option, value, needle in (("--program", "exit 3", "code 3"), ("--plugin", "leaves.so", "ended with code 0 before it had answered"), ("--program", "true", "wrote no line"),
                                      ("--program", "echo mine", "program_"), ("--program", "echo program_a round", "form"),
                                      ("--program", "echo program_a power 3 2", "degrees"), ("--plugin", "text.so", "text.so"),
                                      ("--plugin", "none.so", "none.so")):
            code = USAGE if value != "none.so" else 4
            self.refused(code, ["run", suite, "--out", "b", option, value], needle)
        self.refused(USAGE, ["run", suite, "--out", "b", "--program", ANSWER, "--program", ANSWER], "program_mine")
        self.refused(4, ["judge", suite], "s.toml")

    def test_a_suite_names_them(self):
        suite = self.suite(**{**SMALL, "methods": '["program_mine"]'})
        self.refused(USAGE, ["run", suite, "--out", "b"], "program_mine")
        self.bundle(suite, "--program", ANSWER)
        self.assertEqual([row["method"] for row in self.table("b/accuracy.csv")], ["program_mine"] * 2)
        for changes in ({"curve": '"power"'}, {"scalar": '["float"]'}, {"kind": '"search"', "budget": "100"}):
            wrong = self.suite(**{**SMALL, "methods": '["program_mine"]', **changes}, name="wrong.toml")
            self.refused(USAGE, ["run", wrong, "--out", "d", "--program", ANSWER], "wrong.toml", "program_mine")
        # The bundle's own suite names a method that must be given again: nothing is started because a file names it.
        self.refused(USAGE, ["run", "b/suite.toml", "--out", "c"], "program_mine")


if __name__ == "__main__":
    unittest.main()
