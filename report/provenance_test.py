# SPDX-License-Identifier: MIT
"""What the numbers rest on: the comparison with other bundles, machine first; columns and generators as schema and bundle explain them."""

import json
import tempfile
import unittest
from pathlib import Path

from . import fixture, schema
from .bundle import Bundle, BundleError, Missing
from .chapters import provenance
from .fixture import ACCURACY, FACT, SENTINEL, TIME, of_kind


class Comparison(unittest.TestCase):
    def blocks(self, rows, facts=()):
        return list(provenance.comparison(fixture.bundle(comparison=dict(rows=rows, facts=facts)), ()))

    def words(self, *arguments):
        return [block.text for block in self.blocks(*arguments) if block.kind == "text"]

    def table(self, table_id, *arguments):
        return of_kind(self.blocks(*arguments), "table")[table_id]

    def test_without_a_comparison_it_is_left_out(self):
        with self.assertRaises(Missing):
            list(provenance.comparison(fixture.bundle(), ()))

    def test_machines_come_first(self):
        tables = of_kind(self.blocks([ACCURACY, TIME], [FACT]), "table")
        self.assertEqual(list(tables), ["comparison-1-machines", "comparison-1-times-t", "comparison-standings"])
        self.assertEqual(tables["comparison-1-machines"].csv()[1], [["build.compiler", "GNU 12.2.0", "Clang 14.0.6"]])
        self.assertIn("Machines and builds do not differ", self.words([ACCURACY])[1])

    def test_accuracy(self):
        self.assertIn("identical, bit for bit, in all 2 common rows", self.words([ACCURACY, ACCURACY])[2])
        other = {**ACCURACY, "b": "2e-10", "verdict": "different"}
        self.assertIn("**differs** in 1 of 2 common rows", self.words([ACCURACY, other])[2])
        rows = self.table("comparison-1-accuracy", [ACCURACY, other]).csv()[1]
        self.assertEqual(rows, [["s", "direct", "4", "accuracy.csv", "max_error", "1e-10", "2e-10"]])
        status = {**other, "column": "status", "a": "ok", "b": "degree_unsupported"}
        self.assertEqual(self.table("comparison-1-accuracy", [status]).csv()[1][0][-1], "degree_unsupported")

    def test_times_with_their_verdicts_and_standings(self):
        tables = of_kind(self.blocks([TIME, SENTINEL]), "table")
        self.assertEqual(fixture.texts(tables["comparison-1-times-t"]), {("direct", "point"): ["1.100 [1.090 – 1.120] slower"],
                                                                         ("direct", "point, in sentinels"): ["1.001 [0.995 – 1.005]"]})
        standings = tables["comparison-standings"]
        self.assertEqual([row[0] for row in standings.csv()[1]], ["a", "x/b"])
        self.assertEqual([texts[-2:] for texts in fixture.texts(standings).values()], [["1.000", "1.000"], ["1.100", ""]])

    def test_what_is_no_comparison_is_refused(self):
        with tempfile.TemporaryDirectory() as place:
            bundle, comparison = fixture.write(f"{place}/b"), fixture.write_comparison(f"{place}/c")
            with self.assertRaisesRegex(BundleError, "nowhere: no such directory"):
                Bundle(bundle, Path(place) / "nowhere")
            (comparison / "facts.csv").unlink()
            with self.assertRaisesRegex(BundleError, "facts.csv: missing; write it again with `bezierbench compare"):
                Bundle(bundle, comparison)


class HowMeasured(unittest.TestCase):
    """What a page says about columns and generators stands in the schema and in the bundle, and nowhere else."""

    def blocks(self, **more):
        bundle = fixture.bundle(**more)
        blocks = list(provenance.how_measured(bundle, ((), ())))
        return bundle, of_kind(blocks, "table"), " ".join(block.text for block in blocks if block.kind == "text")

    def test_every_declared_column_of_every_table_is_explained(self):
        bundle, tables, _ = self.blocks()
        declared = json.loads(schema.FILE.read_text(encoding="utf-8"))["properties"]
        shown = {(file, label.strip("`"), cells[0].text) for group in tables["columns"].groups for file in group.key.split()
                 for label, cells in group.rows}
        expected = {(file, column, schema.description(file, column)) for file, table in bundle.tables.items() if file in declared
                    for column in table.columns if column in schema.columns(file)}
        self.assertEqual(shown, expected)
        self.assertGreater(len(expected), 200)
        self.assertFalse([one for one in expected if not one[2]])

    def test_generators_say_themselves_how_they_draw(self):
        bundle, tables, words = self.blocks()
        own = {row["id"]: row for row in fixture.generators()}
        self.assertIn("unused", own)
        self.assertEqual({key: texts for (key, _), texts in fixture.texts(tables["generators"]).items()},
                         {one: [own[one][c] for c in ("coordinates", "t", "weights")] for one in provenance.used_generators(bundle) if one in own})
        self.assertIn("`distant`", words)

    def test_what_a_bundle_does_not_say_is_not_made_up(self):
        bundle, tables, words = self.blocks(without=("generators.csv",))
        self.assertNotIn("generators", tables)
        for one in provenance.used_generators(bundle):
            self.assertIn(f"`{one}`", words)


if __name__ == "__main__":
    unittest.main()
