# SPDX-License-Identifier: MIT
"""Damaged and forged bundles: one line and exit code 4, or what was asked for with --damaged; never a traceback or a file elsewhere."""

import contextlib
import io
import os
import random
import tempfile
import unittest
from pathlib import Path

from . import fixture
from .__main__ import main
from .bundle import Bundle, BundleError
from .page_test import Page
from scripts.hostile_bundle import damaged  # noqa: E402

SEEDS = range(int(os.environ.get("BEZIERBENCH_MUTATIONS", "25")))
SMALL = [f for f in fixture.FILES if f not in ("scorecard.csv", "audit.csv")]


def run(*arguments):
    """(exit code, standard output, standard error) of the report in this process."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main([str(one) for one in arguments])
    return code, out.getvalue(), err.getvalue()


class Damage(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        self.bundle = fixture.write(self.place / "bundle", without=SMALL)

    def refused(self, words):
        code, out, err = run(self.bundle, "--summary")
        self.assertEqual((code, out, err.count("\n")), (4, "", 1), err)
        self.assertIn(words, err)

    def test_what_is_not_as_it_was_written_is_refused(self):
        sums = (self.bundle / "SHA256SUMS").read_text()
        other = (self.bundle / "scorecard.csv").read_text().replace("inside", "outside", 1)
        for name, data, words in (("scorecard.csv", other, "scorecard.csv: is not what SHA256SUMS lists"),
                                  ("audit.csv", None, "audit.csv: is missing"), ("suite.toml", None, "suite.toml: is missing"),
                                  ("machine.json", "{}", "machine.json: is not what"), ("extra.csv", "study\nx\n", "extra.csv: is not in SHA256SUMS"),
                                  ("SHA256SUMS", None, "SHA256SUMS: is missing"), ("SHA256SUMS", "x\n", "SHA256SUMS:1: is not a line of sha256sum"),
                                  ("SHA256SUMS", sums + f"{'0' * 64}  ../x\n", "is not a line of sha256sum"),
                                  ("SHA256SUMS", sums + sums, "lists a file twice")):
            with self.subTest(name=name, words=words):
                path = self.bundle / name
                before = path.read_text() if path.exists() else None
                path.unlink() if data is None else path.write_text(data)
                self.refused(words)
                self.refused("--damaged")
                path.unlink(missing_ok=True) if before is None else path.write_text(before)
        self.assertEqual(run(self.bundle, "--summary")[0], 0)

    def test_damage_that_is_asked_for_is_said_first_and_on_the_page(self):
        path = self.bundle / "scorecard.csv"
        path.write_text(path.read_text().replace("inside", "outside", 1))
        for arguments in (("--summary",), ("--out", self.place / "out")):
            code, out, err = run(self.bundle, "--damaged", *arguments)
            self.assertEqual((code, err), (0, ""))
            self.assertRegex(out.splitlines()[0], "damaged: scorecard.csv is not what SHA256SUMS lists")
        for page in ("report.html", "report.md"):
            text = (self.place / "out" / page).read_text()
            self.assertLess(text.index("This bundle is damaged: scorecard.csv"), text.index("What was found"))

    def test_a_sound_bundle_is_not_called_damaged(self):
        code, out, _ = run(self.bundle, "--damaged", "--out", self.place / "out")
        self.assertEqual((code, "damaged" in out), (0, False))
        self.assertNotIn("This bundle is damaged", (self.place / "out/report.html").read_text())

    def test_text_where_a_number_is_due_is_refused_in_every_column_that_is_declared(self):
        def change(at, row):
            if at == "accuracy.csv":
                row["p50_condition"] = "NaN"
        with self.assertRaisesRegex(BundleError, "accuracy.csv:2: `p50_condition` is 'NaN', a number was expected"):
            Bundle(fixture.write(self.place / "b", change))


class Mutations(unittest.TestCase):
    """Files of the bundle are few in each run, so that it is quick and its changes matter."""

    def judge(self, place, seed):
        rng = random.Random(~seed)
        kept = rng.sample(sorted(fixture.FILES), rng.randint(1, 3))
        bundle, out = place / "bundle", place / "out"
        fixture.write(bundle, without=[f for f in fixture.FILES if f not in kept])
        done = f"seed {seed}: {damaged(bundle, rng)}"
        before = sorted(place.rglob("*"))
        arguments = [bundle, *(["--damaged"] if seed % 8 == 0 else []), *(["--summary"] if seed % 3 else ["--out", out])]
        code, said, err = run(*arguments)
        self.assertIn(code, (0, 4), done)
        self.assertEqual(err.count("\n"), 1 if code else 0, (done, err))
        self.assertLess(len(err), 2000, done)
        self.assertIsNone(regular_text(said + err), done)
        written = [path for path in sorted(place.rglob("*")) if path not in before and out not in (path, *path.parents)]
        self.assertEqual(written, [], done)
        if out.exists():
            page = Page((out / "report.html").read_text(encoding="utf-8"))
            self.assertEqual((page.problems + page.open, len(page.ids)), ([], len(set(page.ids))), done)
        return code

    def test_every_change_ends_in_one_line_or_a_page(self):
        codes = []
        for seed in SEEDS:
            with self.subTest(seed=seed), tempfile.TemporaryDirectory() as place:
                codes.append(self.judge(Path(place), seed))
        self.assertEqual(set(codes), {0, 4})


def regular_text(text):
    """The first character of a message that acts on a terminal; None where there is none."""
    return next((c for c in text if c < " " and c != "\n" or c in "\x7f\u202e\u2028"), None)


if __name__ == "__main__":
    unittest.main()
