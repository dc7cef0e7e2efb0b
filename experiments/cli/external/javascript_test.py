# SPDX-License-Identifier: MIT
"""Libraries of the npm registry as methods: experiments/examples/javascript. Skipped (code 77) where node or a library is
missing; `npm install --prefix build/javascript bezier-js paper` installs them."""
import os
import pathlib
import shutil
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program_case import ROOT, Case, rows  # noqa: E402

EXAMPLES = ROOT / "experiments/examples/javascript"
MODULES = pathlib.Path(os.environ.get("BEZIERBENCH_NODE_MODULES") or ROOT / "build/javascript/node_modules")


class JavaScript(Case):
    def judged(self, name, degrees):
        """The row of each degree; errors are those of a method that works in double and is not wrong."""
        (self.folder / "node_modules").symlink_to(MODULES.resolve())
        self.write(name, (EXAMPLES / name).read_bytes())
        self.bundle(self.suite(trials="300", degree=degrees), "--program", f"node {name}")
        found = [row for row in rows((self.folder / "b/accuracy.csv").read_text()) if row["method"].startswith("program_")]
        for row in found:
            if row["status"] == "ok":
                self.assertLess(float(row["max_error_u"]), 30, row)
        return [(row["method"], row["degree"], row["status"]) for row in found]

    def test_bezier_js(self):
        self.assertEqual(self.judged("mine.mjs", "[1, 3, 5]"), [("program_bezier_js", n, "ok") for n in "135"])

    def test_paper(self):
        self.assertEqual(self.judged("paper.mjs", "[2, 3]"),
                         [("program_paper", "2", "degree_unsupported"), ("program_paper", "3", "ok")])


if __name__ == "__main__":
    missing = [name for name in ("bezier-js", "paper") if not (MODULES / name).exists()]
    if shutil.which("node") is None or missing:
        print("skipped: node or these libraries are missing:", *missing)
        sys.exit(77)
    unittest.main()
