# SPDX-License-Identifier: MIT
"""What methods do on the curves of sets, and which of it is the other way round on random ones."""

from dataclasses import dataclass
from itertools import permutations

from .. import inputs
from ..bundle import Missing, Row
from ..rows import distinct, fits, grouped
from ..wording import general, shortest
from .conclusions import METHOD, POWER_WORSE
from .finding import finding, verdict

KIND = ("form", "degree", "dimension")
RANDOM = "continuous"  # what every random curve of the published numbers is drawn by
POWER = (METHOD, "differences:horner", "differences:horner_fma")  # power form: the report's path, and two that convert by differences
ENOUGH = 100  # trials below which a share on a set says little; sets of fewer are left out where others have more
CLEAR = 1.1  # two methods differ where the larger value is at least so many times the smaller one


def judged(bundle):
    """Rows against the exact value that state a share of misrounded coordinates, of curves that are not lines."""
    rows = [r for r in bundle.exact().rows
            if r["status"] == "ok" and r["misrounded"] is not None and r["degree"] > 1]
    if not any(r["curves"] for r in rows):
        raise Missing("`accuracy.csv` has no row of a curve set with a share of misrounded coordinates")
    enough = [r for r in rows if not r["curves"] or r["trials"] >= ENOUGH]
    return enough if any(r["curves"] for r in enough) else rows


def kinds(rows):
    """{(form, degree, dimension): rows on sets}, those of most curves first."""
    found = grouped((r for r in rows if r["curves"]), *KIND)
    return dict(sorted(found.items(), key=lambda item: -sum({r["curves"]: r["trials"] for r in item[1]}.values())))


def share(value):
    """A share as a percentage with two digits: 1.9 %."""
    return f"{general(100 * value, 2)} %"


@dataclass(frozen=True)
class Reversal:
    """A method that another passes: better on random curves and worse on sets, by one measure."""

    passed: Row  # both on random curves
    passing: Row
    on_sets: tuple  # rows of the passing method on the sets and placements that judge both
    turned: int  # on so many of them it is better


def reversals(rows, own, scalar, measure):
    """The Reversals among the methods of one kind of curves; none where the bundle has no random curves of that kind."""
    like = {**{c: own[0][c] for c in KIND}, "curves": None, "generator": RANDOM, "interval": (0, 1), "scalar": scalar}
    random = {r["method"]: r for r in reversed(rows) if fits(r, like)}
    cells = [{r["method"]: r for r in cell} for cell in grouped((r for r in own if r["scalar"] == scalar), *inputs.ONE_SET).values()]
    found = []
    for passing, passed in permutations(reversed(random), 2):
        pairs = [(cell[passing], cell[passed]) for cell in cells if passing in cell and passed in cell]
        turned = sum(clearly(a[measure], b[measure]) for a, b in pairs)
        if turned and clearly(random[passed][measure], random[passing][measure]):
            found.append(Reversal(random[passed], random[passing], tuple(a for a, _ in pairs), turned))
    return found


def clearly(less, more):
    return less * CLEAR <= more > 0


@finding(suite=None, about="conclusion", **POWER_WORSE)
def via_power_worse_on_sets(bundle):
    """Holds where de Casteljau misrounds less and errs less, on average and at most, than each path through the power form on every set."""
    cells = [{r["method"]: r for r in cell} for cell in
             grouped((r for r in judged(bundle) if r["curves"] and r["form"] == "bernstein"), "degree", "scalar", *inputs.ONE_SET).values()]
    pairs = [(cell["de_casteljau"], cell[path]) for cell in cells for path in POWER if "de_casteljau" in cell and path in cell]
    if not pairs:
        raise Missing("`accuracy.csv` has no set with both de Casteljau and the power form")
    misrounded, mean, largest = (sum(a[column] < b[column] for a, b in pairs) for column in ("misrounded", "mean_error_u", "max_error_u"))
    for_it, against = (end(pairs, key=lambda pair: pair[0]["misrounded"] - pair[1]["misrounded"]) for end in (max, min))

    def said(pair):
        a, b = pair
        return (f"`{b['method']}` misrounds {share(b['misrounded'])} of the coordinates and de Casteljau {share(a['misrounded'])} "
                f"({inputs.words(a)}, degree {shortest(a['degree'])}, {a['scalar']})")
    n, sets = len(pairs), len(distinct((a for a, _ in pairs), "curves"))
    return verdict(
        min(misrounded, mean, largest) == n, f"On real curves, too, de Casteljau is more accurate than the power form, in all {n} comparisons.",
        f"On real curves de Casteljau is {'not always' if misrounded else 'never'} more accurate than the power form: it misrounds fewer coordinates in "
        f"{misrounded or 'none'} of {n} comparisons.",
        f"A comparison is of one path through the power form on {'the set' if sets == 1 else f'one of {sets} sets'}, at one placement, degree and type. De "
        f"Casteljau has the smaller mean error over u p~ in {mean} and the smaller largest one in {largest} of them.",
        f"Most in favour of the power form: {said(for_it)}. Most in favour of de Casteljau: {said(against)}.", rows=[r for pair in pairs for r in pair])
