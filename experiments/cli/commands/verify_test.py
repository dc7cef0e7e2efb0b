# SPDX-License-Identifier: MIT
"""`verify` on bundles whose tables somebody changed, with checksums and digests that are right again."""
import contextlib
import csv
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, ".."), os.path.join(HERE, "../../..")]
from program_case import CONVERSION, FINDING, FINE, PROGRAM, STUDY, Case, rows  # noqa: E402
from scripts import digests  # noqa: E402

ONE = {"curve": '"bernstein"', "degree": "[3]", "coordinate_range": "[1]", "trials": "5"}
STUDIES = [
    {**STUDY, "degree": "[2, 3]", "trials": "20", "baseline": '["exact", "de_casteljau"]',
     "methods": '["direct", "de_casteljau", "direct_pow"]'},
    {**STUDY, "id": '"other"', "trials": "20"},
    CONVERSION,
    {**ONE, "id": '"s"', "kind": '"search"', "methods": '["direct", "de_casteljau"]', "budget": "20"},
    {**ONE, "id": '"t"', "kind": '"timing"', "modes": '["point"]', "methods": '["direct", "de_casteljau"]', "trials": None},
    {**ONE, "id": '"keeps"', "kind": '"guarantees"', "coordinate_range": None, "trials": "50", "budget": "200",
     "methods": '["direct", "de_casteljau"]'},
    {**ONE, "id": '"derivative"', "kind": '"derivative"', "order": "[1]"},
    {**ONE, "id": '"split"', "kind": '"subdivision"'},
    {**ONE, "id": '"length"', "kind": '"arc_length"', "tolerance": "[1e-3, 1e-6]", "trials": "2"},
    {**ONE, "id": '"foot"', "kind": '"projection"', "trials": "2"},
]


def where(**fields):
    """Whether a row has these fields."""
    return lambda row: all(row[column] == field for column, field in fields.items())


def without(is_meant):
    return lambda table: [row for row in table if not is_meant(row)]


def with_fields(is_meant, **fields):
    """The first such row gets other fields."""
    def change(table):
        next(row for row in table if is_meant(row)).update(fields)
        return table
    return change


def with_copy(is_meant, **fields):
    """A copy of the first such row is added, with other fields."""
    return lambda table: [*table, {**next(row for row in table if is_meant(row)), **fields}]


DIRECT, DE_CASTELJAU, ANY = where(method="direct"), where(method="de_casteljau"), where()
FOUND = where(method="direct", baseline="exact")

# What somebody does to which tables, and what the finding has.
FORGERIES = {
    "all rows of a method gone": ({file: without(DE_CASTELJAU) for file in ("accuracy.csv", "worst.csv", "reference.csv")},
                                  "accuracy.csv: the row with study a, form bernstein, method de_casteljau"),
    "one cell gone": ({"accuracy.csv": without(where(study="a", method="direct", degree="2"))}, "degree 2"),
    "one baseline gone": ({"accuracy.csv": without(where(baseline="de_casteljau"))}, "baseline de_casteljau is missing"),
    "a study's rows gone": ({file: without(where(study="other")) for file in
                             ("accuracy.csv", "worst.csv", "reference.csv", "audit.csv")}, "has no row of study other"),
    "a row twice": ({"accuracy.csv": with_copy(DIRECT)}, "repeats the row of line 2"),
    "trials": ({"accuracy.csv": with_fields(DIRECT, trials="999")}, "trials 999"),
    "a study that is not there": ({"accuracy.csv": with_copy(DIRECT, study="more")}, "its study is not one of"),
    "worst rows gone": ({"worst.csv": without(DIRECT)}, "accuracy.csv has it"),
    "a worst row more": ({"worst.csv": with_copy(DIRECT, degree="9", worst_id="w99")}, "there is no such row in accuracy.csv"),
    "a maximum below the mean": ({"accuracy.csv": with_fields(FOUND, max_error="1e-30")}, "rms_error is above max_error"),
    "violations": ({"accuracy.csv": with_fields(FOUND, bound_violations="3")}, "3 bound violations"),
    "the sentinel gone": ({"timing.csv": without(where(method="sentinel"))}, "method sentinel"),
    "an interval beside its median": ({"timing.csv": with_fields(DIRECT, low_ns="1e9")}, "low_ns is above median_ns"),
    "what was timed is another thing": ({"timing.csv": with_fields(DIRECT, checked="no")}, "did not give what was judged"),
    "halves off the curve": ({"subdivision.csv": with_fields(where(method="de_casteljau_split"), points_off="1")},
                             "1 points of a half off the curve"),
    "a broken junction": ({"subdivision.csv": with_fields(where(method="de_casteljau_split"), broken_promises="1")},
                          "1 broken promises"),
    "broken promises": ({"arc_length.csv": with_fields(ANY, broken_promises="2")}, "2 broken promises"),
    "a missed foot point": ({"projection.csv": with_fields(where(method="subdivide_hull"), missed="1")}, "1 missed foot points"),
    "refuted made proved": ({"guarantees.csv": with_fields(where(verdict="refuted"), verdict="proved")}, "not refuted"),
    "refuted made proved, and its count with it": (
        {"guarantees.csv": with_fields(where(verdict="refuted"), verdict="proved", broken="0")}, "not proved according to"),
    "a property of nobody": ({"guarantees.csv": with_fields(ANY, method="1,5")}, 'suite.toml asks for no row'),
    "a method not listed": ({"methods.csv": without(where(id="direct"))}, "methods.csv does not list its method direct"),
    "another bound": ({"methods.csv": with_fields(where(id="direct"), bound="gamma_1 p~")}, "id direct"),
}


class Signed(Case):
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


class Forgeries(Signed):
    def setUp(self):
        super().setUp()
        self.bundle(self.suite(*STUDIES), timeout=600)

    def change(self, bundle, file, change):
        path = self.folder / bundle / file
        table = rows(path.read_text())
        header = list(table[0])
        out = io.StringIO()
        writer = csv.DictWriter(out, header, lineterminator="\n")
        writer.writeheader()
        writer.writerows(change(table))
        self.assertNotEqual(out.getvalue(), path.read_text())
        path.write_text(out.getvalue())

    def test_each_is_found(self):
        in_repository = b"unknown" not in subprocess.run([PROGRAM, "--version"], check=True, capture_output=True).stdout
        for name, (changes, needle) in FORGERIES.items():
            if name == "another bound" and not in_repository:
                continue  # builds without a commit may be of other sources
            with self.subTest(name=name):
                shutil.rmtree(self.folder / "f", ignore_errors=True)
                shutil.copytree(self.folder / "b", self.folder / "f")
                for file, change in changes.items():
                    self.change("f", file, change)
                self.sign("f")
                result = self.run_program("verify", "f")
                self.assertEqual((result.returncode, result.stdout), (FINDING, b""), result.stderr)
                self.assertIn(needle, result.stderr.decode())
                self.assertNotIn("SHA256SUMS", result.stderr.decode())

    def test_signing_alone_is_fine(self):
        self.sign("b")
        self.assertEqual(self.run_program("verify", "b").returncode, FINE)

    def test_a_method_of_another_build_is_not_accused(self):
        """Neither its rows nor, of a list that is shorter than this build's, the rows that are not there."""
        def by_peer(table):
            return [*table, *({**row, "method": "peer_absent"} for row in table if DE_CASTELJAU(row) and row["study"] == "other")]
        self.change("b", "methods.csv", with_copy(where(id="direct"), id="peer_absent"))
        for file in ("accuracy.csv", "reference.csv", "worst.csv"):
            self.change("b", file, by_peer)
        self.change("b", "methods.csv", with_fields(where(id="direct"), citation="[Another 2000]"))
        self.change("b", "search.csv", without(DIRECT))
        manifest = self.folder / "b/bundle.json"
        commit = self.manifest("b")["git_commit"]
        manifest.write_text(manifest.read_text().replace(commit, "0" * 40))
        self.sign("b")
        self.assertEqual(self.fine("verify", "b").splitlines()[0], "b: fine")


class Schema(Signed):
    def test_schema_and_required_tables(self):
        """With checksums that are right."""
        self.bundle()
        for name, change, needle in [
                ("accuracy.csv", lambda text: re.sub(",exact,ok,", ",exact,fine,", text, count=1), "status is"),
                ("accuracy.csv", lambda text: text.replace("p50_error", "median"), "column 'median'"),
                ("machine.json", lambda text: text.replace('"caches"', '"caches_"'), "caches"),
                ("bundle.json", lambda text: text.replace('"seed": 1', '"seed": 7'), "seed is 7, in suite.toml 1"),
                ("bundle.json", lambda text: text.replace('"git_clean"', '"git_clear"'), "git_clean"),
                ("suite.toml", lambda text: text.replace("seed = 1", "seed = 2"), "seed is 1, in suite.toml 2"),
                ("suite.toml", lambda text: text.replace('id = "a"', 'id = "z"'), "its study is not one of those"),
                ("accuracy.csv", None, "accuracy.csv: is missing, a study"),
                ("reference.csv", None, "reference.csv: is missing, a study")]:
            with self.subTest(name=name, needle=needle):
                shutil.rmtree(self.folder / "c", ignore_errors=True)
                shutil.copytree(self.folder / "b", self.folder / "c")
                path = self.folder / "c" / name
                if change is None:
                    path.unlink()
                else:
                    text = change(path.read_text())
                    self.assertNotEqual(text, path.read_text())
                    path.write_text(text)
                self.sign("c")
                result = self.run_program("verify", "c")
                self.assertEqual((result.returncode, result.stdout), (FINDING, b""), result)
                self.assertIn(needle, result.stderr.decode())

    def test_a_foreign_folder_is_one_line(self):
        for number in range(5):
            self.write(f"thesis/{number}.tex", "x")
        result = self.run_program("verify", "thesis")
        self.assertEqual(result.returncode, FINDING)
        self.assert_one_line(result, "thesis: is not a bundle")


if __name__ == "__main__":
    unittest.main()
