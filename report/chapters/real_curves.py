# SPDX-License-Identifier: MIT
"""Real curves: what methods do on the curves of sets, and what is the other way round on random ones."""

from .. import inputs
from ..document import Bullets, Cell, Group, Heading, Table, Text
from ..findings.real_curves import CLEAR, KIND, judged, kinds, reversals, share
from ..methods import form
from ..rows import distinct, grouped
from ..tables import by_axis, one
from ..wording import count, general, large, listing, shortest, span
from .parts import chapter, figure

MOST_KINDS, FEWEST = 4, 3  # kinds of curves with tables; methods that a sentence names
ERRORS = {"mean_error_u": "mean / (u p~)", "max_error_u": "largest / (u p~)", "max_error_size": "largest / size"}
ORDERS = {"misrounded": ("share misrounded", share), "mean_error_u": ("mean error / (u p~)", general)}


@chapter("Real curves", whole=True)
def real_curves(bundle, findings):
    """The source report's conclusion, a figure, then for each kind of curves what is misrounded, the errors, and what reverses."""
    rows = judged(bundle)
    for said in (f for f in findings[0] if f.id == "via_power_worse_on_sets"):
        yield Text(f"**{said.headline}** The source report: “{said.claim}” ({said.place}). {' '.join(said.detail)}")
    found = kinds(rows)
    yield Bullets(tuple(map(_fewest, list(found.values())[:MOST_KINDS])))
    yield Text("Each of these shares is that on the set where it is largest.")
    yield from figure("curves_of_sets", bundle)
    yield from figure("misrounded_by_distance", bundle)
    for own in list(found.values())[:MOST_KINDS]:
        yield Heading(_named(own))
        yield _misrounded(own)
        yield _errors(own)
        yield from _reversed(rows, own)
    yield Text("A coordinate is misrounded where it is not the number nearest to the true one; shares are of all coordinates of the trials. The size of a "
               "curve is the largest extent of its control points along an axis. Curves as stored keep their numbers, of which many have few "
               "digits; translated ones lie at a random place of a page, as an outline that is drawn."
               + (f" {count(len(found) - MOST_KINDS, 'other kind')} of curves, of fewer trials, in the tables of the studies: "
                  f"{listing(map(_named, list(found.values())[MOST_KINDS:]))}." if len(found) > MOST_KINDS else ""))


def _named(rows):
    """`Bézier curves of degree 3, 2 axes`"""
    row = rows[0]
    return f"{form(row['form'])[0]} of degree {shortest(row['degree'])}, {count(int(row['dimension']), 'axis', 'axes')}"


def _id(rows):
    return "-".join(str(shortest(v) if isinstance(v, float) else v) for v in (rows[0][c] for c in KIND))


def _worst(rows, column):
    """{method: the row of its largest value}, the smallest of these first."""
    largest = {method: max((r for r in own if r[column] is not None), key=lambda r: r[column], default=own[0]) for method, own in grouped(rows, "method").items()}
    return dict(sorted(largest.items(), key=lambda item: item[1][column] or 0))


def _fewest(rows):
    """Who misrounds least, in the first type, and who most; each on the set where it misrounds most."""
    scalar = rows[0]["scalar"]
    worst = {method: row["misrounded"] for method, row in _worst([r for r in rows if r["scalar"] == scalar], "misrounded").items()}
    right, others = [m for m in worst if not worst[m]], [m for m in worst if worst[m]]
    none = f"{listing(f'`{m}`' for m in right)} {'misrounds' if len(right) == 1 else 'misround'} no coordinate; " if right else ""
    most = f"; most by `{others[-1]}`, {share(worst[others[-1]])}" if len(others) > FEWEST else ""
    return (f"{_named(rows)}, {scalar}: {none}fewest {'of the others' if right else 'are misrounded'} by "
            f"{listing(f'`{m}`, {share(worst[m])}' for m in others[:FEWEST])}{most}.")


def _misrounded(rows):
    """Sets across, methods down, those that misround least first."""
    ordered = [r for method in _worst(rows, "misrounded") for r in rows if r["method"] == method]
    lines = [(f"{scalar}, {inputs.PLACED[placement]}", one("misrounded", share), {"scalar": scalar, "generator": placement})
             for scalar in distinct(rows, "scalar") for placement in distinct(rows, "generator")]
    trials = {r["curves"]: r["trials"] for r in rows}
    return by_axis(ordered, "curves", f"real-misrounded-{_id(rows)}", f"Share of misrounded coordinates, {_named(rows)} "
                   f"({', '.join(f'{name}: {large(n)} trials' for name, n in trials.items())})", lines,
                   values=distinct(rows, "curves"), row_head="type, curves")


def _errors(rows):
    """The largest value over the sets of each measure, for each placement."""
    placements = distinct(rows, "generator")

    def cells(own):
        for column in ERRORS:
            for placement in placements:
                at = max((r for r in own if r["generator"] == placement and r[column] is not None), key=lambda r: r[column], default=None)
                yield Cell(general(at[column]), at.text(column)) if at else Cell()
    groups = [Group(f"`{method}`", method, tuple((scalar, list(cells(own))) for scalar, own in grouped((r for r in rows if r["method"] == method), "scalar").items()))
              for method in _worst(rows, "misrounded")]
    return Table(id=f"real-errors-{_id(rows)}", caption=f"Errors, each the largest over the sets, {_named(rows)}",
                 head=tuple(f"{what}, {inputs.PLACED[placement]}" for what in ERRORS.values() for placement in placements), groups=tuple(groups), row_head="type")


def _reversed(rows, own):
    """Methods that are worse than others on random curves and better on sets, in the first type: those which they pass."""
    scalar = own[0]["scalar"]
    found = {}
    for measure in ORDERS:
        for one in reversals(rows, own, scalar, measure):
            found.setdefault(one.passing["method"], {}).setdefault(measure, []).append(one)
    if found:
        yield Table(id=f"real-reversed-{_id(own)}", caption=f"Methods that pass others: worse on random curves and better on those of sets, each by a factor of "
                    f"at least {CLEAR}, {_named(own)}, {scalar}", group_head="method", row_head="measure",
                    head=("on random curves", "on sets", "passes on every set", "on some sets"),
                    groups=tuple(Group(f"`{method}`", method, tuple((ORDERS[measure][0], _passes(some, measure)) for measure, some in by.items()))
                                 for method, by in found.items()))


def _passes(found, measure):
    write, passing = ORDERS[measure][1], found[0].passing
    values = [r[measure] for r in found[0].on_sets]
    names = [listing(f"`{one.passed['method']}`" for one in found if (one.turned == len(one.on_sets)) == every) for every in (True, False)]
    return [Cell(write(passing[measure]), passing.text(measure)), Cell(span(min(values), max(values), write)), *(Cell(text, text.replace("`", "")) for text in names)]
