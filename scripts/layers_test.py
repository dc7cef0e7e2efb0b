#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""layers.py finds a violation of each kind and accepts what the table allows."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import layers  # noqa: E402

ALLOWED = [
    ("core/evaluate/methods/horner.hpp", '#include "core/method.hpp"'),
    ("core/evaluate/methods/horner.hpp", "#include <Eigen/Core>"),
    ("core/evaluate/methods/horner.hpp", "#include <cmath>"),
    ("core/evaluate/methods/horner.hpp", "// #include <iostream>"),
    ("core/convert/exact.hpp", "#include <boost/multiprecision/cpp_int.hpp>"),
    ("reference/exact.cpp", '#include "core/curve_view.hpp"'),
    ("reference/exact.cpp", "#include <gmpxx.h>"),
    ("experiments/suite/parse.cpp", "#include <toml++/toml.h>"),
    ("experiments/suite/parse.cpp", '#include "experiments/failure.hpp"'),
    ("experiments/bundle/write.cpp", "#include <unistd.h>"),
    ("experiments/cli/main.cpp", '#include "experiments/studies/accuracy/accuracy.hpp"'),
    ("experiments/cli/commands/doctor.cpp", '#include "build_facts.hpp"'),
    ("bindings/c/exact_bound.cpp", '#include "reference/error/trial_scale.hpp"'),
    ("core/evaluate/horner_test.cpp", '#include "experiments/cli/run.hpp"'),
]

FORBIDDEN = [
    # a folder further down the pipeline
    ("core/evaluate/methods/horner.hpp", '#include "reference/exact.hpp"'),
    ("core/evaluate/methods/horner.hpp", '#include "experiments/failure.hpp"'),
    ("experiments/suite/parse.cpp", '#include "experiments/sample/sample.hpp"'),
    ("experiments/studies/accuracy/accuracy.cpp", '#include "experiments/cli/options.hpp"'),
    ("bindings/c/exact_bound.cpp", '#include "experiments/metric/tally.hpp"'),
    ("reference/exact.hpp", '#include "core/bound/error_bound.hpp"'),
    # the right folder, the wrong file
    ("reference/exact.hpp", '#include "core/evaluate/methods/horner.hpp"'),
    ("experiments/suite/parse.cpp", '#include "core/evaluate/roster.hpp"'),
    # other spellings of a path: with dots, angle brackets, blanks
    ("reference/exact.hpp", '#include "reference/../core/evaluate/methods/horner.hpp"'),
    ("reference/exact.hpp", "#include <core/evaluate/methods/horner.hpp>"),
    ("reference/exact.hpp", '  #  include   "core/evaluate/methods/horner.hpp"'),
    # a path that does not begin at the root
    ("core/evaluate/methods/horner.hpp", '#include "curve.hpp"'),
    ("core/evaluate/methods/horner.hpp", '#include "../curve.hpp"'),
    ("experiments/bundle/write.cpp", '#include "build_facts.hpp"'),
    # impure headers in core
    *[("core/curve.hpp", f"#include <{header}>") for header in "iostream fstream cstdio chrono random thread".split()],
    ("core/curve.hpp", "#include <unistd.h>"),
    # a package of another folder
    ("core/convert/differences.hpp", "#include <boost/multiprecision/cpp_int.hpp>"),
    ("core/convert/exact.hpp", "#include <gmpxx.h>"),
    ("core/convert/exact.hpp", "#include <boost/multiprecision/gmp.hpp>"),
    ("experiments/studies/accuracy/accuracy.cpp", "#include <toml++/toml.h>"),
    # a package that no folder may include
    ("experiments/cli/main.cpp", "#include <boost/spirit.hpp>"),
]


class Layers(unittest.TestCase):
    def violations(self, path, line):
        with tempfile.TemporaryDirectory() as place:
            file = Path(place, path)
            file.parent.mkdir(parents=True)
            file.write_text(f"#pragma once\n{line}\n", encoding="utf-8")
            return layers.check(Path(place))[0]

    def test_allowed(self):
        for path, line in ALLOWED:
            with self.subTest(path=path, line=line):
                self.assertEqual(self.violations(path, line), [])

    def test_forbidden(self):
        for path, line in FORBIDDEN:
            with self.subTest(path=path, line=line):
                found = self.violations(path, line)
                self.assertEqual(len(found), 1)
                self.assertTrue(found[0].startswith(f"{path}:2: "), found[0])

    def test_program(self):
        def run(*arguments):
            command = [sys.executable, "-B", layers.__file__, *arguments]
            return subprocess.run(command, capture_output=True, text=True, check=False)

        with tempfile.TemporaryDirectory() as place:
            file = Path(place, "core/curve.hpp")
            file.parent.mkdir()
            file.write_text("#include <cmath>\n", encoding="utf-8")
            self.assertEqual(run(place).returncode, 0)
            file.write_text("#include <cmath>\n#include <random>\n", encoding="utf-8")
            result = run(place)
            self.assertEqual(result.returncode, 1)
            self.assertIn("core/curve.hpp:2: core may not include <random>", result.stdout)
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(run(empty).returncode, 1, "reading no file proves nothing")


if __name__ == "__main__":
    unittest.main()
