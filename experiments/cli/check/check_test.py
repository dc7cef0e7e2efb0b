#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`check` from outside, against bundles, programs and commits that are not what they were. Usage: check_test.py BEZIERBENCH"""
import os
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "external"))
from external_test import compiled  # noqa: E402
from program_case import (ENVIRONMENT, FINDING, FINE, INPUT_OUTPUT, PROGRAM, ROOT, STUDY, USAGE, Case)  # noqa: E402

# Stands for the program before a change: runs the real one, then rewrites the rows of the bundle that it wrote.
STUB = '''#!/usr/bin/python3
import csv, hashlib, pathlib, subprocess, sys
code = subprocess.run([{program!r}, *sys.argv[1:]]).returncode
out = pathlib.Path(sys.argv[sys.argv.index("--out") + 1])
path = out / {file!r}
if path.exists():
    with open(path, newline="") as text:
        table = list(csv.DictReader(text))
    for row in table:
        {change}
    with open(path, "w", newline="") as text:
        writer = csv.DictWriter(text, table[0].keys(), lineterminator="\\n")
        writer.writeheader()
        writer.writerows(table)
    names = sorted(one.name for one in out.iterdir() if one.is_file() and one.name != "SHA256SUMS")
    (out / "SHA256SUMS").write_text("".join(hashlib.sha256((out / name).read_bytes()).hexdigest() + "  " + name + "\\n"
                                            for name in names))
sys.exit(code)
'''
CMAKE = '''cmake_minimum_required(VERSION 3.22)
project(before NONE)
{fault}
add_custom_target(bezierbench COMMAND ${{CMAKE_COMMAND}} -E copy ${{CMAKE_SOURCE_DIR}}/stub ${{CMAKE_BINARY_DIR}}/bezierbench)
'''
PRESETS = '''{"version": 3, "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release",
  "cacheVariables": {"BEZIERBENCH_TESTS": "ON"}}]}
'''
DOUBLED = 'row["max_error_u"] = repr(2 * float(row["max_error_u"])) if row["degree"] == "8" else row["max_error_u"]'


class Check(Case):
    def setUp(self):
        super().setUp()
        for name in ("temporary", "cache"):
            (self.folder / name).mkdir()
        self.environment = {**os.environ, "TMPDIR": str(self.folder / "temporary"), "XDG_CACHE_HOME": str(self.folder / "cache"),
                            "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CEILING_DIRECTORIES": str(self.folder.parent)}

    def check(self, code, *arguments, counts=False):
        """The lines of standard output. A finding is a line of standard error as well, and no bundle is left behind. Without counts
        there is no Valgrind on the path, which takes seconds."""
        environment = self.environment if counts else {**self.environment, "PATH": "/nonexistent"}
        result = self.run_program("check", *arguments, "--quiet", env=environment, timeout=600)
        self.assertEqual(result.returncode, code, result)
        if code == FINDING:
            self.assert_one_line(result, arguments[0])
        else:
            self.assertEqual(result.stderr, b"")
        self.assertEqual(os.listdir(self.folder / "temporary"), [])
        return result.stdout.decode().splitlines()

    def program(self, name="before", file="accuracy.csv", change="pass"):
        path = self.folder / self.write(name, STUB.format(program=PROGRAM, file=file, change=change))
        path.chmod(0o755)
        return name

    def judged(self, **changes):
        return self.bundle(self.suite(**{"degree": "[3, 8]", "methods": '["direct", "de_casteljau"]', **changes}))

    # Alone.

    def test_a_right_method(self):
        lines = self.check(FINE, "de_casteljau")
        self.assertEqual(lines[0], "verdict     de_casteljau: no problem was found")
        self.assertLessEqual(len(lines), 10)
        self.assertRegex(lines[1], r"^properties  (\d+) of \1 hold, in \d+ cases$")
        self.assertRegex(lines[2], r"^accuracy    \d+ rows of suite quick, \d+ trials; largest error \S+ u p~ at quick-bezier, ")
        self.assertRegex(lines[3], r"^bound       holds in every trial; the largest error is \S+ % of it$")

    def test_fits_the_terminal(self):
        self.assert_fits("check", "c2_natural")

    def test_methods_of_every_problem(self):
        problems = {}
        for row in self.our_methods():
            problems.setdefault((row["problem"], row["form"]), row["id"])
        self.assertGreater(len(problems), 10)
        for (problem, form), method in problems.items():
            with self.subTest(problem=problem, form=form, method=method):
                self.assertIn("no problem was found", self.check(FINE, method)[0])

    # Against a bundle.

    def test_the_same_bits_as_in_a_bundle(self):
        lines = self.check(FINE, "direct", "--against", self.judged())
        self.assertIn("  accuracy  the same bits in 2 of 2 rows", lines)
        self.assertIn("2 rows of b, 100 trials", lines[2])

    def test_other_bits_than_in_a_bundle(self):
        self.judged()

        def halve(row):
            if row["method"] == "direct" and row["degree"] == "8":
                row["max_error_u"] = repr(float(row["max_error_u"]) / 2)
        self.edit("b/accuracy.csv", halve)
        lines = self.check(FINDING, "direct", "--against", "b")
        self.assertEqual(lines[0], "verdict     direct: accuracy differs in 1 of 2 rows; 1 of 2 rows are less accurate by more than 5 %")
        changed = next(k for k, line in enumerate(lines) if "max_error_u" in line)
        before, after = lines[changed].split()[1:4:2]
        self.assertEqual(2 * float(before), float(after))
        self.assertIn("at a, degree 8", lines[changed])
        self.check(FINE, "de_casteljau", "--against", "b")  # the change is another method's

    def test_rows_that_a_bundle_has_alone(self):
        self.judged()
        self.edit("b/accuracy.csv", lambda row: row["method"] != "direct" or row["degree"] != "8")
        lines = self.check(FINDING, "direct", "--against", "b")
        self.assertIn("rows are missing or new", lines[0])
        self.assertIn("a row of accuracy.csv is new: study a, ", "\n".join(lines))

    # Against a program.

    def test_the_same_program(self):
        lines = self.check(FINE, "c2_natural", "--against", PROGRAM, "--pairs", "1")
        self.assertIn("  accuracy  the same bits in 1 of 1 rows", lines)
        self.assertIn("  times     0 slower, 0 faster, 0 same, 1 unresolved of 1; now over before, 1 pairs of runs", lines)
        lines = self.check(FINE, "horner", "--against", PROGRAM, "--pairs", "1", counts=True)
        self.assertTrue(lines[-2].endswith("of 4; now over before, 1 pairs of runs; 3 more with --all"), lines[-2])  # not resolved
        self.assertRegex(lines[-3], r"^  counts    (the same instructions in 4 of 4 races|none: .*)$")
        self.assertLessEqual(len(lines), 11)

    def test_a_program_with_other_errors(self):
        lines = self.check(FINDING, "horner", "--against", self.program(change=DOUBLED), "--pairs", "0", "--out", "kept")
        self.assertEqual(lines[0], "verdict     horner: accuracy differs in 2 of 32 rows")  # 2 is half of what it was
        self.assertIn("against     before", lines)
        self.assertIn("  times     none: --pairs 0 leaves them out", lines)
        result = self.run_program("compare", "kept/before", "kept/after", "--method", "horner")
        self.assertEqual(result.returncode, FINDING)
        self.assertIn("accuracy differs in 2 of ", result.stdout.decode().splitlines()[0])

    def test_a_program_with_other_times(self):
        """Eight pairs, the least with a verdict."""
        for factor, verdict, code in ((0.25, "slower", FINDING), (4, "faster", FINE)):
            change = f'row["median_ns"] = repr({factor} * float(row["median_ns"]))'
            program = self.program(f"before-{verdict}", "timing.csv", change)
            lines = self.check(code, "c2_natural", "--against", program, "--pairs", "8")
            self.assertEqual("1 of 1 times are slower by more than 5 %" in lines[0], verdict == "slower")
            self.assertRegex(lines[-1], rf"^ +\d+\.\d+ \[\S+, \S+\] {verdict} .* ns  quick-interpolation-times, one_shot")

    # Gates.

    def test_better_is_no_failure_of_a_gate(self):
        program = self.program(change=DOUBLED)
        gates = ["--fail-on", "less-accurate"]
        self.check(FINE, "horner", "--against", program, "--pairs", "0", *gates)
        halved = self.program("halved", change=DOUBLED.replace("2 *", "0.5 *"))
        lines = self.check(FINDING, "horner", "--against", halved, "--pairs", "0", *gates)
        self.assertEqual(lines[0], "verdict     horner: 2 of 32 rows are less accurate by more than 5 %")
        self.check(FINE, "horner", "--against", halved, "--pairs", "0", *gates, "--threshold", "1.5")
        text = "\n".join(self.check(FINDING, "horner", "--against", halved, "--pairs", "0", *gates, "--format", "markdown"))
        self.assertIn("| **fails** | less-accurate | 32 | 2 | 0 |", text)
        self.assertIn("max_error_u is 2 times as large", text)

    # External methods.

    def test_a_plugin_against_what_it_was(self):
        """Two shared objects of one id; the second takes a step with other roundings."""
        source = (ROOT / "experiments/examples/plugin/mine.c").read_text()
        changed = source.replace("(1 - t[k]) * b[i] + t[k] * b[i + 1]", "b[i] + t[k] * (b[i + 1] - b[i])")
        self.assertNotEqual(changed, source)
        for name, text in (("before", source), ("after", changed)):
            compiled(self.folder, self.folder / self.write(f"{name}.c", text), f"{name}.so")
        lines = self.check(FINDING, "plugin_mine", "--plugin", "after.so", "--against", "before.so", "--pairs", "1", counts=True)
        self.assertIn("accuracy differs in ", lines[0])
        self.assertTrue(any(line.startswith("  times     ") for line in lines), lines)
        self.check(FINE, "plugin_mine", "--plugin", "after.so", "--against", "after.so", "--pairs", "0")

    def test_a_command_against_what_it_was(self):
        command = f"{sys.executable} {ROOT}/experiments/examples/program/mine.py"
        lines = self.check(FINE, "program_mine", "--program", command, "--against", command)
        self.assertRegex("\n".join(lines), r"  accuracy  the same bits in (\d+) of \1 rows")

    def test_a_command_without_answers(self):
        result = self.run_program("check", "program_silent", "--program", "echo program_silent")
        self.assertEqual(result.returncode, FINDING, result)
        self.assertIn(b"it gives no answers in 8 of 8 rows", result.stdout)

    # Against a commit.

    def repository(self, fault=""):
        for name, text in (("CMakeLists.txt", CMAKE.format(fault=fault)), ("CMakePresets.json", PRESETS),
                           ("stub", STUB.format(program=PROGRAM, file="accuracy.csv", change=DOUBLED))):
            self.write(f"repository/{name}", text)
        folder = self.folder / "repository"
        (folder / "stub").chmod(0o755)
        for words in (["init", "--quiet"], ["add", "."], ["-c", "user.name=n", "-c", "user.email=e", "commit", "--quiet", "-m", "m"]):
            subprocess.run(["git", *words], cwd=folder, check=True, env=self.environment)
        return subprocess.run(["git", "rev-parse", "HEAD"], cwd=folder, check=True, capture_output=True, text=True,
                              env=self.environment).stdout.strip()

    def in_repository(self, *arguments):
        return subprocess.run([PROGRAM, "check", "horner", "--pairs", "0", *arguments], cwd=self.folder / "repository",
                              env=self.environment, check=False, capture_output=True, text=True, timeout=600)

    def test_a_commit_is_built_in_the_cache(self):
        commit = self.repository()
        for _ in range(2):  # the second time it is there
            result = self.in_repository("--against", "HEAD")
            self.assertEqual(result.returncode, FINDING, result.stderr)
            self.assertIn("accuracy differs in 2 of 32 rows", result.stdout)
            self.assertIn(f"against     commit {commit[:12]}", result.stdout)
            self.assertIn(f"cache/bezierbench/commits/{commit}", result.stderr)
        self.assertTrue((self.folder / f"cache/bezierbench/commits/{commit}/build/release/bezierbench").exists())
        self.assertFalse((self.folder / "repository/build").exists())

    def test_a_commit_that_cannot_be_built(self):
        commit = self.repository(fault='message(FATAL_ERROR "no")')
        result = self.in_repository("--against", "HEAD", "--quiet")
        self.assertEqual((result.returncode, result.stdout), (ENVIRONMENT, ""))
        self.assertIn(f"{commit}.log", result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)

    # What it refuses.

    def test_refusals(self):
        self.refused(USAGE, ["check"], "METHOD is required")
        self.refused(USAGE, ["check", "plugin_mine"], "plugin_mine: is external and was not given; give it with --plugin")
        self.refused(USAGE, ["check", "de_castlejau"], 'did you mean "de_casteljau"?')
        self.refused(USAGE, ["check", "direct", "--against", "nothing"], "--against nothing", env=self.environment)
        self.refused(USAGE, ["check", "direct", "--out", "cache"], "--out cache: exists")
        self.refused(INPUT_OUTPUT, ["check", "direct", "--against", "cache"], "cache: is not a bundle")
        self.bundle(self.suite(**{**STUDY, "methods": '["de_casteljau"]'}))
        self.refused(USAGE, ["check", "direct", "--against", "b"], "b: does not have errors of direct")
        (self.folder / self.write("refuses", "#!/bin/sh\nexit 2\n")).chmod(0o755)
        self.refused(USAGE, ["check", "c2_natural", "--against", "refuses", "--quiet", "--out", "kept"], "exit code 2")
        self.write("no_program", "x")
        self.refused(USAGE, ["check", "c2_natural", "--against", "no_program", "--quiet"], "no_program: cannot be started")


if __name__ == "__main__":
    unittest.main()
