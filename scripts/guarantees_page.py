#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Writes docs/guarantees.md: what each method keeps, from a bundle of the suite `guarantees`, and the statements, from the
comments of experiments/guarantees/statements.hpp.

guarantees_page.py BUNDLE           writes the page
guarantees_page.py BUNDLE --check   compares, and exits 1 where the page differs
"""
import argparse
import itertools
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle  # noqa: E402
from report.chapters.guarantees import study_tables  # noqa: E402
from report.wording import large  # noqa: E402

PAGE = ROOT / "docs" / "guarantees.md"
STATEMENTS = ROOT / "experiments/guarantees/statements.hpp"
OPENING = """# What each method keeps

Which properties of the exact curve a method keeps: proved, broken by an input, or open.

Does the curve end exactly in its last point? Is a constant reproduced? Does a point stay between its control points? Here every
method has an answer for each such property, over degrees {degrees} in {scalars}: **proved** where the method's header in
[core/evaluate](../core/evaluate) has the proof, or names its page of [proofs](proofs/README.md); **broken** where an input was found that breaks it, with the largest share of
{trials} random inputs of full significands that do (no share: none of these, but a special one does); **open** where neither is the
case. Where degrees differ, n says which.

This page is written by `scripts/guarantees_page.py` from a bundle of `bezierbench run guarantees`, which also has every
counterexample in hexadecimal, in `guarantees.csv`; `bezierbench replay BUNDLE ID` tries one again. `scripts/check guarantees`
tries to refute the methods that keep the ends, constants, the hull, monotone sequences, reversal and finiteness, all six, and
says with how many inputs: by default 10^9 for each.
"""


def statement(name):
    """The comment of the property's class."""
    lines = STATEMENTS.read_text(encoding="utf-8").splitlines()
    first = next(at for at, line in enumerate(lines) if line.startswith(f"/// {name}: "))
    comment = itertools.takewhile(lambda line: line.startswith("///"), lines[first:])
    text = " ".join(line.removeprefix("///").strip() for line in comment).removeprefix(f"{name}: ")
    return text.replace("see Finite", "see `finite`").replace("*", r"\*").replace("|", r"\|")


def markdown(table):
    """Group labels, then the cells."""
    head = [table.group_head] if table.single else [table.group_head, table.row_head]
    lines = ["| " + " | ".join([*head, *table.head]) + " |", "|" + "---|" * (len(head) + len(table.head))]
    for group in table.groups:
        for label, cells in group.rows:
            lines.append("| " + " | ".join([group.label, *([] if table.single else [label]), *(cell.text for cell in cells)]) + " |")
    return "\n".join(lines)


def page(bundle):
    rows = bundle.judged("guarantees.csv").of_suite("guarantees").rows
    parts = [OPENING.format(degrees=", ".join(f"{n:g}" for n in sorted({r["degree"] for r in rows})),
                            scalars=" and ".join(dict.fromkeys(r["scalar"] for r in rows)), trials=large(max(r["trials"] for r in rows)))]
    for study in dict.fromkeys(r["study"] for r in rows):
        for block in study_tables(bundle, study):
            if block.kind == "text":
                parts.append(block.text + "\n")
            elif block.id.endswith(("-matrix", "-open")):
                parts.append(f"## {block.caption}\n\n{markdown(block)}\n")
    parts.append("## The statements\n")
    parts += [f"**{name}**: {statement(name)}\n" for name in dict.fromkeys(r["property"] for r in rows)]
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bundle", type=Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    text = page(Bundle(options.bundle))
    if options.check:
        if PAGE.read_text(encoding="utf-8") == text:
            return 0
        print(f"{PAGE.relative_to(ROOT)} differs from what {options.bundle} gives; run scripts/guarantees_page.py on it", file=sys.stderr)
        return 1
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
