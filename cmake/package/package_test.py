#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""package_test.py PREFIX: the package that is installed under PREFIX, seen from a project outside the tree.

With the name of a compiler instead of a test, `package_test.py PREFIX --alone g++`, it compiles every header by itself.
"""
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OUTSIDE = Path(__file__).resolve().parent / "outside"
RESULTS = [ROOT / "results/baseline/worst.csv", ROOT / "results/hard_cases/hard_cases.csv"]
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Werror"]
STRICT = ["-std=c++20", *WARNINGS]
STRICT_C = ["-std=c99", "-Wpedantic", *WARNINGS]
POINT = """#include <bezierbench/evaluate.hpp>
#include <vector>
int main() {
  const std::vector<std::array<double, 1>> points{{1.0}, {2.0}};
  return bezierbench::evaluate(points, 0.5)[0] == 1.5 ? 0 : 1;
}
"""
PREFIX = Path()  # set by main


FRONTS = ("evaluate.hpp", "flatten.hpp", "ease.hpp", "box.hpp")  # of core/api, which are installed at the top
HARNESS = ("bezierbench/harness.hpp", "bezierbench/own_method.hpp")  # those of the other component


def run(*command, cwd=None, **variables):
    return subprocess.run([str(word) for word in command], cwd=cwd, env=dict(os.environ, **variables), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)


def pkg_config(*arguments):
    done = run("pkg-config", *arguments, PKG_CONFIG_PATH=str(next(PREFIX.glob("lib/**/pkgconfig"))))
    assert done.returncode == 0, done.stdout
    flags = done.stdout.split()
    # Eigen's headers are not ours to keep free of warnings.
    return [flag.replace("-I", "-isystem", 1) if "eigen" in flag else flag for flag in flags]


def compilers():
    return [name for name in ("g++", "clang++") if shutil.which(name)]


def headers(pattern="*.hpp"):
    place = PREFIX / "include"
    return sorted(file.relative_to(place).as_posix() for file in (place / "bezierbench").rglob(pattern))


class Package(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="bezierbench-package-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def configure(self, source, *options):
        return run("cmake", "-G", "Ninja", "-S", source, "-B", self.folder / "build", f"-DCMAKE_PREFIX_PATH={PREFIX}", *options)

    def project(self, *lines):
        text = "cmake_minimum_required(VERSION 3.22)\nproject(p CXX)\n" + "\n".join(lines) + "\n"
        (self.folder / "CMakeLists.txt").write_text(text, encoding="utf-8")
        return self.configure(self.folder)

    def compile(self, text, *options, compiler="g++", output="program"):
        (self.folder / "one.cpp").write_text(text, encoding="utf-8")
        return run(compiler, *STRICT, *options, "one.cpp", "-o", output, cwd=self.folder)

    def test_a_project_outside_has_the_committed_bits(self):
        for compiler in compilers():
            with self.subTest(compiler=compiler):
                shutil.rmtree(self.folder / "build", ignore_errors=True)
                # Both contract where nobody forbids it, Clang within expressions.
                flags = "-O1 -march=native -Wall -Wextra -Wconversion -Werror"
                done = self.configure(OUTSIDE, f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}",
                                      "-DCMAKE_BUILD_TYPE=None")
                self.assertEqual(done.returncode, 0, done.stdout)
                done = run("cmake", "--build", self.folder / "build")
                self.assertEqual(done.returncode, 0, done.stdout)
                done = run(self.folder / "build/known_bits", *RESULTS)
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertRegex(done.stdout, r"^\d{4} agree, 0 differ\n$")
                self.assertEqual(run(self.folder / "build/headers_only").returncode, 0)
                if "bezierbench/batch.hpp" in headers():
                    self.assertEqual(run(self.folder / "build/c_library").returncode, 0)

    def test_pkg_config_carries_the_arithmetic(self):
        flags = pkg_config("--cflags", "bezierbench-methods")
        for flag in ("-ffp-contract=off", "-fno-fast-math", "-DEIGEN_DONT_VECTORIZE"):
            self.assertIn(flag, flags)
        names = [file.stem for file in PREFIX.glob("lib/**/pkgconfig/*.pc")]
        self.assertEqual(len(names), 4 if (PREFIX / "bin/bezierbench").exists() else 2)
        for name in names:
            libraries = [flag for flag in pkg_config("--libs", name) if flag.startswith("-lbezierbench")]
            self.assertEqual(bool(libraries), name != "bezierbench-methods", name)
            self.assertEqual(pkg_config("--modversion", name), ["1.0.0"])
        done = self.compile(POINT, *flags)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(run(self.folder / "program").returncode, 0)
        text = POINT.replace("evaluate(", "exact(").replace("evaluate.hpp", "exact.hpp")
        (self.folder / "two.cpp").write_text(text, encoding="utf-8")
        done = run("g++", *STRICT, *pkg_config("--cflags", "bezierbench-reference"), "two.cpp", "-o", "two",
                   *pkg_config("--libs", "bezierbench-reference"), cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(run(self.folder / "two").returncode, 0)

    def test_headers_refuse_options_that_leave_ieee_arithmetic(self):
        flags = [flag for flag in pkg_config("--cflags", "bezierbench-methods") if flag != "-fno-fast-math"]
        refused = {"g++": ["-ffast-math", "-ffinite-math-only", "-funsafe-math-optimizations", "-freciprocal-math",
                           "-fno-signed-zeros"],
                   "clang++": ["-ffast-math", "-ffinite-math-only"]}
        for compiler in compilers():
            for option in refused[compiler]:
                for header in ("evaluate.hpp", "core/binomial.hpp"):
                    with self.subTest(compiler=compiler, option=option, header=header):
                        done = self.compile(f"#include <bezierbench/{header}>\n", *flags, option, "-E",
                                            compiler=compiler)
                        self.assertNotEqual(done.returncode, 0)
                        self.assertIn("bezierbench: compiled with", done.stdout)

    def test_all_headers_together(self):
        text = "".join(f"#include <{header}>\n" for header in headers()) + "int main() {}\n"
        for compiler in compilers():
            with self.subTest(compiler=compiler):
                done = self.compile(text, *pkg_config("--cflags", "bezierbench-methods"), "-fsyntax-only",
                                    compiler=compiler)
                self.assertEqual(done.returncode, 0, done.stdout)

    def test_all_headers_of_core_but_those_of_batches_are_there(self):
        core = [str(path.relative_to(ROOT)) for path in (ROOT / "core").rglob("*.hpp") if not path.name.endswith("_test.hpp")]
        wanted = {f"bezierbench/{name}" for name in core if not name.startswith("core/batch/")}
        at_the_top = {f"bezierbench/core/api/{name}" for name in FRONTS}
        self.assertLessEqual(wanted - at_the_top | {f"bezierbench/{name}" for name in FRONTS}, set(headers()))

    def test_methods_need_eigen_alone(self):
        methods = [header for header in headers() if header.startswith("bezierbench/core/")]
        for header in [*(f"bezierbench/{name}" for name in FRONTS), *methods]:
            text = (PREFIX / "include" / header).read_text(encoding="utf-8")
            for included in re.findall(r"^ *# *include +(\S+)", text, re.MULTILINE):
                self.assertRegex(included, r'^(<[a-z_]+>|<Eigen/\w+>|"bezierbench/(core/\S+|evaluate\.hpp)")$', header)

    def test_headers_name_each_other_as_they_are_installed(self):
        for header in headers():
            text = (PREFIX / "include" / header).read_text(encoding="utf-8")
            self.assertNotRegex(text, r'#include "(core|reference|experiments)/', header)
            if header in ("bezierbench/batch.hpp", "bezierbench/roots_and_parts.hpp"):  # the library computes
                continue
            by_core = header in HARNESS and '#include "bezierbench/core/' in text
            self.assertTrue(by_core or "floating_point.hpp" in header or "floating_point.hpp" in text, header)

    def test_a_project_that_contains_this_one_builds_what_it_links(self):
        (self.folder / "main.cpp").write_text(POINT, encoding="utf-8")
        done = self.project("include(FetchContent)", f"FetchContent_Declare(bezierbench SOURCE_DIR {ROOT})", "enable_testing()",
                            "FetchContent_MakeAvailable(bezierbench)", "add_executable(main main.cpp)",
                            "target_link_libraries(main PRIVATE bezierbench::methods)")
        self.assertEqual(done.returncode, 0, done.stdout)
        done = run("cmake", "--build", self.folder / "build")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Linking CXX executable main", done.stdout)
        self.assertEqual(done.stdout.count("Building CXX object"), 1, done.stdout)
        self.assertEqual(run(self.folder / "build/main").returncode, 0)
        self.assertIn("Total Tests: 0", run("ctest", "--test-dir", self.folder / "build", "-N").stdout)
        run("cmake", "--install", self.folder / "build", "--prefix", self.folder / "prefix")
        self.assertFalse((self.folder / "prefix").exists())

    def test_a_fused_method_that_the_options_make_slow_warns(self):
        if "FP_FAST_FMA" in run("g++", "-x", "c++", "-include", "cmath", "-dM", "-E", "/dev/null").stdout:
            self.skipTest("std::fma is an instruction here without an option")
        text = POINT.replace("evaluate(points", "evaluate<bezierbench::HornerBernsteinFma>(points")
        for options, warns in (("", True), ("-march=x86-64-v3", False), ("-DBEZIERBENCH_SLOW_FMA", False)):
            with self.subTest(options=options):
                (self.folder / "main.cpp").write_text(text, encoding="utf-8")
                done = self.project("find_package(bezierbench 1 CONFIG REQUIRED)", f"set(CMAKE_CXX_FLAGS {options})",
                                    "add_executable(main main.cpp)", "target_link_libraries(main PRIVATE bezierbench::methods)")
                self.assertEqual(done.returncode, 0, done.stdout)
                done = run("cmake", "--build", self.folder / "build", "--clean-first")
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertEqual("std::fma is a call" in done.stdout, warns, done.stdout)

    def test_find_package_says_what_is_missing(self):
        self.assertEqual(self.project("find_package(bezierbench 1 CONFIG REQUIRED)",
                                      "get_target_property(x bezierbench::methods TYPE)").returncode, 0)
        self.assertEqual(self.project("find_package(bezierbench CONFIG REQUIRED COMPONENTS reference)",
                                      "get_target_property(x bezierbench::reference TYPE)").returncode, 0)
        done = self.project("find_package(bezierbench CONFIG REQUIRED COMPONENTS nothing)")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("component nothing is not installed", done.stdout)
        self.assertEqual(self.project("find_package(bezierbench CONFIG OPTIONAL_COMPONENTS nothing)").returncode, 0)
        self.assertNotEqual(self.project("find_package(bezierbench 2 CONFIG REQUIRED)").returncode, 0)


def alone(compiler):
    """Compiles each header by itself, those of C with both standards; prints those that fail."""
    in_cpp = ["-x", "c++", *STRICT, *pkg_config("--cflags", "bezierbench-methods")]
    in_c = ["-x", "c", *STRICT_C, f"-I{PREFIX / 'include'}"]
    of_c = headers("*.h")
    tries = [(header, in_cpp) for header in headers() + of_c] + [(header, in_c) for header in of_c]

    def refused(header, options):
        done = subprocess.run([compiler, *options, "-fsyntax-only", "-"], text=True, input=f"#include <{header}>\n",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return f"{header}: {done.stdout}" if done.returncode else ""

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        findings = [finding for finding in pool.map(lambda one: refused(*one), tries) if finding]
    print("\n".join(findings + [f"{len(headers())} headers of C++ and {len(of_c)} of C, {len(findings)} do not compile alone "
                                f"with {compiler}"]))
    return 1 if findings or not of_c else 0


if __name__ == "__main__":
    PREFIX = Path(sys.argv[1]).resolve()
    if sys.argv[2:3] == ["--alone"]:
        sys.exit(alone(sys.argv[3]))
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
