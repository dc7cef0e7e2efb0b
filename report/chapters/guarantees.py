# SPDX-License-Identifier: MIT
"""What each method keeps of a curve's properties: the matrix of verdicts, the open cells, the smallest counterexamples."""

from ..document import Cell, Group, Table, Text
from ..guarantee_words import MARKS, WORDS, of_all, share, with_share
from ..wording import count, general, large, percent
from .suite_parts import figure

TITLE = "What each method keeps"
SUITE = KIND = "guarantees"


def _grouped(rows, *columns):
    """Rows by their values in these columns, in the order of the file."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[c] for c in columns), []).append(row)
    return groups


def _matrix(study, rows):
    """Methods down, properties across: the verdicts over all degrees and scalar types."""
    properties = list(dict.fromkeys(r["property"] for r in rows))
    cells = _grouped(rows, "method", "property")

    def cell(method, name):
        own = cells.get((method, name))
        return Cell(with_share(own), of_all(own), MARKS[of_all(own)]) if own else Cell()

    methods = dict.fromkeys(r["method"] for r in rows)
    groups = tuple(Group(f"`{m}`", m, (("", [cell(m, p) for p in properties]),)) for m in methods)
    return Table(id=f"{study}-matrix", caption="What each method keeps, over all degrees and scalar types; in brackets the largest "
                 "share of random inputs that break it", caption_zh="各方法所保持的性质", groups=groups,
                 head=tuple(p.replace("_", " ") for p in properties))


def _open(study, rows):
    """The cells that are neither proved nor broken, with what was tried."""
    groups = []
    for (method,), own in _grouped([r for r in rows if r["verdict"] == "not_refuted"], "method").items():
        lines = []
        for (name, scalar), cells in _grouped(own, "property", "scalar").items():
            tried = min(r["trials"] + r["searched"] for r in cells)
            nearest = [r["largest"] for r in cells if isinstance(r["largest"], float)]
            degrees = ", ".join(f"{r['degree']:g}" for r in cells)
            lines.append((f"{name.replace('_', ' ')}, {scalar}", [Cell(degrees, degrees), Cell(large(tried), f"{tried:g}"),
                                                                  Cell(general(max(nearest)), repr(max(nearest))) if nearest else Cell()]))
        groups.append(Group(f"`{method}`", method, tuple(lines)))
    return Table(id=f"{study}-open", caption="Neither proved nor broken: degrees, inputs tried at each degree, and the best attempt",
                 caption_zh="既未证明亦未推翻者", groups=tuple(groups), head=("degrees", "inputs", "best attempt, ulp"), row_head="property")


def _counterexamples(study, rows):
    """The smallest input that breaks a property, at the lowest degree where one does."""
    groups = []
    for (method,), own in _grouped([r for r in rows if r["verdict"] == "refuted"], "method").items():
        lines = []
        for (name,), cells in _grouped(own, "property").items():
            row = min(cells, key=lambda r: (r["degree"], len(r.text("coefficients")) + len(r.text("t"))))
            broken = share([row])
            shown = [f"{row['degree']:g}, {row['scalar']}", percent(broken) if broken is not None else "", general(row["largest"]),
                     row.text("t") + (f" and {row.text('t_next')}" if row.text("t_next") else ""),
                     row.text("coefficients") + (f"; moved by {row.text('offset')}" if row.text("offset") else "")]
            lines.append((name.replace("_", " "), [Cell(text, text) for text in shown]))
        groups.append(Group(f"`{method}`", method, tuple(lines)))
    return Table(id=f"{study}-counterexamples", caption="The smallest counterexample that a search found, at the lowest degree with one: "
                 "share of random inputs that break it, largest excess in ulp, t, control points axis by axis",
                 caption_zh="搜索所得最小反例", groups=tuple(groups), head=("degree", "share", "largest", "t", "control points"),
                 row_head="property")


def study_tables(bundle, study):
    """The matrix, the open cells, the counterexamples."""
    rows = bundle.judged("guarantees.csv").some(study=study)
    yield _matrix(study, rows)
    left = [r for r in rows if r["verdict"] == "not_refuted"]
    verdicts = ", ".join(f"{sum(r['verdict'] == v for r in rows)} {WORDS[v]}" for v in WORDS)
    yield Text(f"{count(len(rows), 'cell')} of one method, scalar type, degree and property: {verdicts}.")
    if left:
        yield _open(study, left)
    if any(r["verdict"] == "refuted" for r in rows):
        yield _counterexamples(study, rows)


def blocks(bundle, _findings):
    """The figure, then the tables of each study."""
    table = bundle.judged("guarantees.csv").of_suite(SUITE)
    yield Text("Yes or no: does the curve end exactly in its last point, is a constant reproduced, does a point stay between its "
               "control points? A property is `proved` where the method's header in core/evaluate has the proof, broken where an "
               "input was found that breaks it, and open where neither is the case.")
    yield from figure("guarantee_matrix", bundle)
    for study in table.distinct("study"):
        yield from study_tables(bundle, study)
    yield Text("The statements stand in experiments/guarantees, one file each, with what they say of subnormal numbers and overflow: "
               "a value that is not finite counts against `finite` and `total` alone. Shares are of inputs with full significands; "
               "counterexamples are sought among few bits, neighbours of powers of two, the largest and the smallest numbers, too, and "
               "then made smaller. Every one is exact in hexadecimal: `bezierbench replay BUNDLE ID` tries it again, with the id of its "
               "row in guarantees.csv.")
