# SPDX-License-Identifier: MIT
"""What a page says about columns and generators stands in the schema and in the bundle, and nowhere else."""

import json
import tempfile
import unittest

from . import fixture, schema
from .bundle import Bundle
from .chapters.provenance import how_measured, used_generators


def _blocks(without=()):
    with tempfile.TemporaryDirectory() as place:
        bundle = Bundle(fixture.write(f"{place}/b", without=without))
        return bundle, list(how_measured(bundle, ((), ())))


def _table(blocks, name):
    return next((block for block in blocks if block.kind == "table" and block.id == name), None)


class HowMeasured(unittest.TestCase):
    def test_every_declared_column_of_every_table_is_explained(self):
        bundle, blocks = _blocks()
        declared = json.loads(schema.FILE.read_text(encoding="utf-8"))["properties"]
        shown = {(file, label.strip("`"), cells[0].text) for group in _table(blocks, "columns").groups for file in group.key.split()
                 for label, cells in group.rows}
        expected = {(file, column, schema.description(file, column)) for file, table in bundle.tables.items() if file in declared
                    for column in table.columns if column in schema.columns(file)}
        self.assertEqual(shown, expected)
        self.assertGreater(len(expected), 200)
        self.assertFalse([one for one in expected if not one[2]])

    def test_generators_say_themselves_how_they_draw(self):
        bundle, blocks = _blocks()
        own = {row["id"]: row for row in fixture.generators()}
        used = used_generators(bundle)
        table = _table(blocks, "generators")
        self.assertEqual([group.key for group in table.groups], [one for one in used if one in own])
        for group in table.groups:
            self.assertEqual([cell.text for cell in group.rows[0][1]], [own[group.key][c] for c in ("coordinates", "t", "weights")])
        self.assertNotIn("unused", [group.key for group in table.groups])

    def test_what_a_bundle_does_not_say_is_not_made_up(self):
        bundle, blocks = _blocks(without=("generators.csv",))
        self.assertIsNone(_table(blocks, "generators"))
        words = " ".join(block.text for block in blocks if block.kind == "text")
        for one in used_generators(bundle):
            self.assertIn(f"`{one}`", words)
        _, blocks = _blocks()
        self.assertIn("`distant`", " ".join(block.text for block in blocks if block.kind == "text"))


if __name__ == "__main__":
    unittest.main()
