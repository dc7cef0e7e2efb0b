#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sources.py finds a violation of each kind and accepts correct files."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import sources  # noqa: E402

LIST = """# Sources
### [Report 001] A report
- [de Boor 1978] A book.
- [Higham 2002] Another book.

| document | there | what | here | verdict |
|---|---|---|---|---|
""" + "".join(f"| {document} | 1 | a formula | `core/evaluate/a.hpp#[0, 1]` | right |\n" for document in sources.DOCUMENTS)
HEADER = """// SPDX-License-Identifier: MIT
// Formula: p = q_0 on [0, 1].
// Source: also [de Boor
//   1978].
// Cost: none.
// Bound: none, at degrees up to 1023.
// Fails: never.
struct A {
  static constexpr MethodInfo info{.id = "a", .citation = "[Higham 2002]; "
                                                          "[Report 001]"};
};
"""
LISTING = "id,citation\na,[Higham 2002]; bound derived here\npeer_a,A library\n"


def findings(header=HEADER, listed=LIST, listing=None, pages=()):
    with tempfile.TemporaryDirectory() as place:
        root = Path(place)
        for name, text in (("core/evaluate/a.hpp", header), ("core/evaluate/roster.hpp", '#include "core/evaluate/a.hpp"\n'),
                           (sources.SOURCES, listed), *pages):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return sources.findings(root, listing)[0]


class Sources(unittest.TestCase):
    def expect(self, wanted, **changes):
        found = findings(**changes)
        self.assertEqual(len(found), 1, found)
        self.assertIn(wanted, found[0])

    def test_right_sources_pass(self):
        self.assertEqual(findings(listing=LISTING), [])

    def test_an_unlisted_key_is_found(self):
        self.expect("[Farin 2002] is not listed", header=HEADER + "int n;  // [Farin 2002]\n")

    def test_an_unused_and_a_doubled_key_are_found(self):
        self.expect("nothing cites [Farin 2002]", listed="- [Farin 2002] A book.\n" + LIST)
        self.expect("[Higham 2002] is listed twice", listed="- [Higham 2002] The same book.\n" + LIST)

    def test_a_citation_without_its_key_is_found(self):
        for words in ("Higham 2002", "SIAM Review 46 (2004) 501-517", "seed report 001", "the documents 002"):
            self.expect("looks like a citation", header=HEADER + f"// As in {words}.\n")

    def test_numbers_in_brackets_are_no_citations(self):
        words = "// t in [1/2, 1] up to degree 1029; 20,000 pieces; [z^i] F; x[k + 16] at 2^1023.\n"
        self.assertEqual(findings(header=HEADER + words), [])

    def test_every_label_is_needed_in_order(self):
        for label in sources.REQUIRED:
            self.expect("must open with the lines", header=HEADER.replace(f"// {label}: ", "// "))
        swapped = HEADER.replace("// Cost:", "// Bound2:").replace("// Bound:", "// Cost:").replace("// Bound2:", "// Bound:")
        self.expect("must open with the lines", header=swapped)
        self.expect("must open with the lines", header=HEADER.replace("// Formula:", "// Name: a\n// Formula:"))

    def test_joined_labels_are_found(self):
        found = findings(header=HEADER.replace("none.\n// Bound:", "none. Bound:"))
        self.assertTrue(any("within another line" in line for line in found), found)

    def test_a_long_comment_is_found(self):
        self.expect("comments end at", header=HEADER + "// " + 40 * "abc " + "\n")

    def test_source_and_cost_may_be_missing(self):
        lines = "// Source: also [de Boor\n//   1978].\n// Cost: none.\n"
        self.assertEqual(findings(header=HEADER.replace(lines, "// [de Boor 1978]\n")), [])

    def test_a_method_that_cites_nothing_is_found(self):
        self.expect("`citation` cites nothing", header=HEADER.replace('[Higham 2002]; "', 'well known; "').replace(
            '"[Report 001]"', '"an old report"') + "// [Higham 2002] [Report 001]\n")
        self.expect("[Farin 2002] is not listed", header=HEADER.replace('"[Report 001]"', '"[Report 001]; [Farin " "2002]"'))

    def test_what_the_program_lists_begins_with_keys(self):
        self.expect("does not begin with a key", listing="id,citation\na,well known\n")
        self.expect("does not begin with a key", listing="id,citation\na,[Higham 2002]; well known\n")
        self.expect("[Farin 2002] is not listed", listing="id,citation\na,[Farin 2002]\n")
        self.expect("lists no methods", listing="id,citation\n")

    def test_a_long_proof_is_a_page_that_a_header_names(self):
        page, proof = "docs/proofs/a.md", "// Bound: none, at degrees up to 1023.\n"
        self.expect("has 7 lines; move the proof", header=HEADER.replace(proof, proof + "//   and so on\n" * 6))
        self.expect(f"{page} does not exist", header=HEADER.replace(proof, f"// Bound: u, by {page}.\n"))
        self.expect("no header names this page", pages=[(page, "# A\n")])
        self.expect(f"{page}: [Farin 2002] is not listed", header=HEADER.replace(proof, f"// Bound: u, by {page}.\n"),
                    pages=[(page, "By [Farin 2002].\n")])

    def test_a_row_without_its_place_is_found(self):
        row = "| 003 | 2 | a system | {} | {} |\n"
        for cells, wanted in ((("", "right"), "'a system' has no place"), (("core", "right"), "'a system' has no place"),
                              (("`core/b.hpp`", "right"), "core/b.hpp is not a file"), (("`core`", "right"), "core is not a file"),
                              (("`core/evaluate/a.hpp#[0, 2]`", "right"), "does not have the words '[0, 2]'"),
                              (("`core/evaluate/a.hpp`", "wrong"), "'wrong' is not a verdict"),
                              (("`core/evaluate/a.hpp` | more", "right"), "6 cells")):
            self.expect(wanted, listed=LIST + row.format(*cells))
        self.expect("'005' is not one of the documents", listed=LIST + row.format("`core/evaluate/a.hpp`", "right").replace("003", "005"))
        self.expect("no row of document 004", listed=LIST.replace("| 004 |", "| 003 |"))
        self.expect("no table with the head", listed=LIST.replace("verdict", "verdicts"))

    def test_a_core_without_methods_is_found(self):
        self.expect("no roster includes a method", header=HEADER.replace('.id = "a"', ""))


if __name__ == "__main__":
    unittest.main()
