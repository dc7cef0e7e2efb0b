# SPDX-License-Identifier: MIT
"""The page of results/audit, from the rows of audit.csv."""

from __future__ import annotations

from collections.abc import Iterable

from libraries import LIBRARIES, Library, Question

Row = dict[str, str]
PROBLEMS = {
    "length": "the length of a curve", "approximate_length": "the length, by the library's fast function",
    "flattened_length": "the length of the library's polygon", "point": "the point at a drawn t",
    "split": "both halves at a drawn t: the coordinate of a control point that is farthest from the exact one",
    "ends": "the same halves: how far the ends have moved, or the halves lie apart where they meet",
    "nearest": "how much farther than the nearest point of the curve the answered one is, from a point in twice the box of the control points",
    "distance": "the same question: the distance that the library states, against the true one",
    "at_length": "the point at a drawn part of the length",
    "quadratics": "quadratics for a cubic: the largest distance at equal parameters, in units of the tolerance; at least the deviation",
    "moved": "how many quadratics more or fewer a curve has when it is moved by a power of two, at least its size, without rounding",
    "easing": "y at 64 x of every easing curve", "monotone": "steps backwards among 2^20 equal ones of increasing easing curves: how many are larger than 1e-12, and the largest"}
SOURCES = {"npm": "npm", "debian": "Debian 12, python3-fonttools", "rust": "Debian 12, Rust sources"}

HEAD = """# Audit of other libraries

Written by `scripts/check audit`; every number is a sum or an extreme over [audit.csv](audit.csv), which has a row for each library, set,
degree and question, and its worst case. The libraries answer live, at the versions below, for the plane cubics and quadratics of the
[shipped sets](../../reference/curves/sets/README.md), none left out; curves in space and rational ones are not part of it. Answers are
judged by the exact functions of `libbezierbench`; every worst case is computed again without it, in rational arithmetic or by sums of
chords and control polygons that enclose the length.

*Off* counts the answers with an error above the expectation: what the library documents, or, where it documents nothing, what a user
expects. An answer that is off is a fault only where the library promised more. The Rust sources of Debian 12 are of 2019 to 2021, its fontTools
of 2022: later versions may answer otherwise. `paper` has no quadratics of its own. *Median* is that of the sets' medians.
"""

TAIL = """
## How to repeat it

    scripts/build release bezierbench_c
    scripts/check audit                    # installs the libraries in build/audit, writes this folder
    scripts/check audit --compare          # exit 1 where an answer of the same version is another one

`--libraries`, `--sets` and `--count` ask less. What cannot be installed is named and left out. npm, apt-get and cargo are required for
an install; the Rust libraries are built offline. Numbers in the table are hexadecimal, so that each worst case can be computed from its
row; `question` is what follows the control points: t, a point, a length, or a tolerance. The control points stay under the licences of
their sets. A library is a line of `scripts/audit/libraries.py` and an adapter beside it.
"""


def _of(rows: Iterable[Row], library: Library, question: Question) -> list[Row]:
    expectation = f"{question.expectation:g}"
    return [row for row in rows if (row["library"], row["version"], row["problem"], row["expectation"], row["unit"]) == (
        library.name, library.version, question.problem, expectation, question.unit) and int(row["degree"]) in question.degrees]


def _coordinates(row: Row) -> str:
    values = [float.fromhex(value) for value in row["control_points"].split()]
    return " ".join(f"({x:.6g}, {y:.6g})" for x, y in zip(values[::2], values[1::2]))


def written(rows: list[Row]) -> str:
    lines = [HEAD, "## What was found", "",
             "| library | version | question | degree | expectation | answered | off | median | largest | worst |", "|---|---|---|---|---|---|---|---|---|---|"]
    for library in LIBRARIES:
        for question in library.questions:
            for degree in question.degrees:
                found = [row for row in _of(rows, library, question) if row["degree"] == str(degree)]
                if not found:
                    continue
                answered, off = (sum(int(row[field]) for row in found) for field in ("answered", "off"))
                refused = sum(int(row["asked"]) for row in found) - answered
                errors = [row for row in found if row["max"]]
                worst = max(errors, key=lambda row: float(row["max"]), default={"max": "nan", "set": ""})
                medians = sorted(float(row["median"]) for row in errors) or [float("nan")]
                lines.append(f"| {library.name} | {library.version} | {question.problem} | {degree} | {question.expectation:g} {question.unit} | "
                             f"{answered:,}{f', {refused:,} refused' if refused else ''} | {f'**{off:,}**' if off else 0} | "
                             f"{medians[len(medians) // 2]:.3g} | {float(worst['max']):.3g} | {worst['set']} |")
    lines += ["", "The questions:", "", *(f"- `{name}`: {text}" for name, text in PROBLEMS.items()), "", "## What the libraries say", "",
              "| library | version | from | asked for | expectation | why |", "|---|---|---|---|---|---|"]
    for library in LIBRARIES:
        for question in library.questions:
            if _of(rows, library, question):
                lines.append(f"| {library.name} | {library.version} | {SOURCES[library.source]} | {question.problem} | "
                             f"{question.expectation:g} {question.unit} | {question.why} |")
    lines += ["", *(f"- {library.name} {library.version}: {library.note}." for library in LIBRARIES if library.note), "", "## Worst cases", "",
              "The answer farthest from the truth for every question of which any answer is off: six digits here, all bits in audit.csv.", "",
              "| library | asked for | error | curve | control points | answer | exact |", "|---|---|---|---|---|---|---|"]
    for library in LIBRARIES:
        for question in library.questions:
            if found := [row for row in _of(rows, library, question) if int(row["off"])]:
                worst = max(found, key=lambda row: float(row["max"]))
                shown = slice(-2, None) if question.problem == "ends" else slice(4)  # the last control point
                answer, exact = (", ".join(f"{float.fromhex(value):.17g}" if question.problem == "ends" else f"{float.fromhex(value):.10g}"
                                           for value in worst[field].split()[shown]) for field in ("answer", "exact"))
                lines.append(f"| {library.name} {library.version} | {question.problem} | {float(worst['max']):.3g} {question.unit} | "
                             f"{worst['set']} `{worst['worst_curve']}` | {_coordinates(worst)} | {answer} | {exact} |")
    lines += ["", *(f"- {row['library']} {row['version']} has no answer to `{row['problem']}` for {row['set']} `{row['unanswered']}`."
                    for row in rows if row["unanswered"])]
    return "\n".join(lines) + "\n" + TAIL
