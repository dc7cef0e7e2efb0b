# SPDX-License-Identifier: MIT
"""Facts about all inputs: properties that each method keeps or breaks, errors at every float, inputs next to rounding boundaries."""

from decimal import Decimal

from ..document import Cell, Group, Table, Text
from ..guarantee_words import MARKS, SEARCHES, WORDS, of_all, share, with_share
from ..rows import distinct, grouped
from ..tables import listed
from ..wording import count, general, large, percent
from .parts import chapter, figure, tables_of


def _by_method(table_id, caption, head, groups):
    """Methods down, each with a line (label, texts) for each property."""
    return Table(id=table_id, caption=caption, head=head, row_head="property", groups=tuple(
        Group(f"`{method}`", method, tuple((label, [c if isinstance(c, Cell) else Cell(c, c) for c in cells]) for label, cells in lines))
        for method, lines in groups))


def _matrix(study, rows):
    """Methods down, properties across: the verdicts over all degrees and scalar types."""
    properties, cells = distinct(rows, "property"), grouped(rows, "method", "property")

    def cell(method, name):
        own = cells.get((method, name))
        return Cell(with_share(own), of_all(own), MARKS[of_all(own)]) if own else Cell()
    return listed(f"{study}-matrix", "What each method keeps, over all degrees and scalar types; in brackets the largest share of random inputs "
                  "that break it", ("method", *(p.replace("_", " ") for p in properties)),
                  [(f"`{m}`", *(cell(m, p) for p in properties)) for m in distinct(rows, "method")])


def _open(study, rows):
    """The cells that are neither proved nor broken, with the inputs tried."""
    def line(name, scalar, cells):
        tried, nearest = min(r["trials"] + r["searched"] for r in cells), [r["largest"] for r in cells if isinstance(r["largest"], float)]
        return f"{name.replace('_', ' ')}, {scalar}", [", ".join(f"{r['degree']:g}" for r in cells), Cell(large(tried), f"{tried:g}"),
                                                       Cell(general(max(nearest)), repr(max(nearest))) if nearest else Cell()]
    return _by_method(f"{study}-open", "Neither proved nor broken: degrees, inputs tried at each degree, and the best attempt",
                      ("degrees", "inputs", "best attempt, ulp"),
                      [(method, [line(*key, cells) for key, cells in grouped(own, "property", "scalar").items()])
                       for method, own in grouped(rows, "method").items()])


def _counterexamples(study, rows):
    """The smallest input that breaks a property, at the lowest degree where one does."""
    def line(name, cells):
        row = min(cells, key=lambda r: (r["degree"], len(r.text("coefficients")) + len(r.text("t"))))
        broken = share([row])
        return name.replace("_", " "), [f"{row['degree']:g}, {row['scalar']}", percent(broken) if broken is not None else "", general(row["largest"]),
                                        row.text("t") + (f" and {row.text('t_next')}" if row.text("t_next") else ""),
                                        row.text("coefficients") + (f"; moved by {row.text('offset')}" if row.text("offset") else "")]
    return _by_method(f"{study}-counterexamples", "The smallest counterexample that a search found, at the lowest degree with one: share of random "
                      "inputs that break it, largest excess in ulp, t, control points axis by axis",
                      ("degree", "share", "largest", "t", "control points"),
                      [(method, [line(*item) for item in grouped(own, "property").items()]) for method, own in grouped(rows, "method").items()])


@tables_of("guarantees")
def study_tables(bundle, study):
    """The matrix, the open cells, the counterexamples."""
    rows = bundle.judged("guarantees.csv").some(study=study)
    by = {verdict: [r for r in rows if r["verdict"] == verdict] for verdict in WORDS}
    yield _matrix(study, rows)
    yield Text(f"{count(len(rows), 'cell')} of one method, scalar type, degree and property: "
               + ", ".join(f"{len(own)} {WORDS[v]}" for v, own in by.items()) + ".")
    if by["not_refuted"]:
        yield _open(study, by["not_refuted"])
    if by["refuted"]:
        yield _counterexamples(study, by["refuted"])


@chapter("What each method keeps", suite="guarantees", kind="guarantees")
def guarantees(bundle, _findings):
    """The figure, then the tables of each study."""
    table = bundle.judged("guarantees.csv").of_suite("guarantees")
    yield Text("Yes or no: does the curve end exactly in its last point, is a constant reproduced, does a point stay between its control points? A "
               "property is `proved` where the method's header in core/evaluate has the proof, broken where an input was found that breaks it, and "
               "open where neither is the case.")
    yield from figure("guarantee_matrix", bundle)
    for study in table.distinct("study"):
        yield from study_tables(bundle, study)
    yield Text("The properties are defined in experiments/guarantees, one file each, also for subnormal numbers and overflow: a value that is not "
               "finite counts against `finite` and `total` alone. Shares are of inputs with full significands; counterexamples are sought also among "
               "numbers of few bits, neighbours of powers of two, the largest and the smallest numbers, and then made smaller. Every one is exact in "
               "hexadecimal: `bezierbench replay BUNDLE ID` tries it again, with the id of its row in guarantees.csv.")


COUNTS = ("misrounded", "non_monotone", "out_of_hull")


@tables_of("exhaustive")
def _at_every_float(bundle, study):
    """A table of each interval: curves, each with its methods."""
    def cells(row):
        error = row["max_error_ulp"]
        return [Cell("not finite", "", "outside") if error is None else Cell(general(error, 6), row.text("max_error_ulp")),
                Cell(f"{float.fromhex(row.text('worst_t')):.9g}", row.text("worst_t")),
                *(Cell(large(row[column]), row.text(column)) for column in COUNTS)]
    for number, rows in enumerate(grouped(bundle["exhaustive.csv"].some(study=study), "interval", "curves").values(), 1):
        shown = f"[{float(rows[0].text('t_min')):.9g}, {float(rows[0].text('t_max')):.9g}]"
        whose = f", curves of the set {rows[0]['curves']}" if rows[0]["curves"] else ""
        yield Table(id=f"{study}-{number}", caption=f"The largest error at the {large(rows[0]['points'])} floats t of {shown}{whose}, and the numbers of "
                    "misrounded points, of steps that are not monotone and of points outside the hull",
                    groups=tuple(Group(f"`{curve}`, degree {own[0]['degree']:g}", curve, tuple((f"`{r['method']}`", cells(r)) for r in own))
                                 for curve, own in grouped(rows, "curve_id").items()),
                    head=("largest error, ulp", "at t", *(column.replace("_", " ") for column in COUNTS)), group_head="curve", row_head="method")
    yield Text("Every float t of the interval was evaluated in float, so that these are facts about all inputs, not estimates. An error is that of a "
               "coordinate, in the spacing of floats at its true value. A point is misrounded where a coordinate is not the float nearest to the true "
               "value; a step from a t to the next is not monotone where a coordinate goes against its control coordinates, where these never "
               "decrease or never increase.")


@tables_of("hard_cases")
def _hard_cases(bundle, study):
    """The families of inputs, each with its searches: how many cases were kept, and how near to a rounding boundary the nearest lies."""
    rows = bundle["hard_cases.csv"].some(study=study)

    def cells(own):
        text = min((r.text("distance_ulp") for r in own), key=Decimal)
        least = Decimal(text)
        return [Cell(str(len(own)), str(len(own))), Cell(general(float(least)) if float(least) or not least else f"{least:.2e}", text)]
    groups = []
    for (family, scalar), own in grouped(rows, "family", "scalar").items():
        by = grouped(own, "search")
        groups.append(Group(f"`{family}`, {scalar}", f"{family} {scalar}", tuple((words, cells(by[s])) for s, words in SEARCHES.items() if s in by)))
    yield Table(id=f"{study}-families", caption=f"Inputs kept by family ({large(max(r['drawn'] for r in rows))} drawn for each family): cases, and the "
                "smallest distance of an exact value from a rounding boundary in ulp", groups=tuple(groups), head=("cases", "smallest distance"),
                group_head="family", row_head="search")
