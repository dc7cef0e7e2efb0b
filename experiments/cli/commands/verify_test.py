# SPDX-License-Identifier: MIT
"""`verify` on bundles whose rows accuse a method; their checksums and digests are right."""
import contextlib
import csv
import hashlib
import os
import re
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), os.path.join(HERE, "../../..")]
from program_case import FINDING, FINE, Case, rows  # noqa: E402
from scripts import digests  # noqa: E402

ONE = {"curve": '"bernstein"', "degree": "[3]", "coordinate_range": "[1]", "trials": "5"}
STUDIES = [
    {**ONE, "id": '"a"', "kind": '"accuracy"', "methods": '["direct"]'},
    {**ONE, "id": '"t"', "kind": '"timing"', "modes": '["point"]', "methods": '["direct", "de_casteljau"]', "trials": None},
    {**ONE, "id": '"split"', "kind": '"subdivision"'},
    {**ONE, "id": '"length"', "kind": '"arc_length"', "tolerance": "[1e-3]", "trials": "2"},
    {**ONE, "id": '"foot"', "kind": '"projection"', "trials": "2"},
]

# Tables, fields by which a row is chosen, another field of it, and the finding.
ACCUSATIONS = (
    ("accuracy.csv", {"method": "direct", "baseline": "exact"}, {"bound_violations": "3"}, "3 bound violations"),
    ("timing.csv", {"method": "direct"}, {"checked": "no"}, "did not give what was judged"),
    ("subdivision.csv", {"method": "de_casteljau_split"}, {"points_off": "1"}, "1 points of a half off the curve"),
    ("arc_length.csv", {}, {"broken_promises": "2"}, "2 broken promises"),
    ("projection.csv", {"method": "subdivide_hull"}, {"missed": "1"}, "1 missed foot points"),
)


class Verify(Case):
    def sign(self, bundle):
        """Makes digests and checksums those of the files as they are, as whoever changes a bundle on purpose can."""
        folder = self.folder / bundle
        with contextlib.suppress(ValueError, LookupError, StopIteration, csv.Error, OSError):  # tables that cannot be read
            (folder / digests.NAME).write_text(digests.of_bundle(folder))
        manifest = (folder / "bundle.json").read_text()
        for key, file in (("accuracy_digest", digests.NAME), ("digest", "suite.toml")):
            sha = hashlib.sha256((folder / file).read_bytes()).hexdigest()
            manifest = re.sub(rf'("{key}": ")[0-9a-f]{{64}}', rf"\g<1>{sha}", manifest)
        (folder / "bundle.json").write_text(manifest)
        self.list_anew(bundle)

    def test_rows_that_accuse(self):
        self.bundle(self.suite(*STUDIES), timeout=600)
        for file, where, fields, needle in ACCUSATIONS:
            with self.subTest(file=file):
                path = self.folder / "b" / file
                written = path.read_text()
                table = rows(written)
                next(row for row in table if where.items() <= row.items()).update(fields)
                self.write_table(path, table)
                self.sign("b")
                result = self.run_program("verify", "b")
                self.assertEqual((result.returncode, result.stdout), (FINDING, b""), result.stderr)
                self.assertIn(needle, result.stderr.decode())
                self.assertEqual(result.stderr.count(b"\n"), 1)
                path.write_text(written)
        self.sign("b")
        self.assertEqual(self.run_program("verify", "b").returncode, FINE)


if __name__ == "__main__":
    unittest.main()
