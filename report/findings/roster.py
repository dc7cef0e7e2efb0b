# SPDX-License-Identifier: MIT
"""All findings, in the order of the page."""

from ..bundle import Missing, decided_by
from . import printed_tables, printed_times, conclusions, real_curves, evaluators, conversion, times, curves, splines  # noqa: F401, I001  declare them in this order
from .finding import ROSTER


def _found(find, bundle):
    try:
        return find(bundle)
    except ZeroDivisionError:
        raise Missing("a ratio divides by an error or time of 0") from None


def find_all(bundle):
    """(findings, [(name, what is missing in the bundle)]); the second list has the findings that cannot be decided."""
    found, undecided, drawn = [], [], bundle.drawn()
    for find, suite in ROSTER:
        if suite and not drawn.has_suite(suite):
            continue
        name = find.__name__
        try:
            with decided_by(bundle, f"the finding '{name.replace('_', ' ')}'"):
                found.append(_found(find, drawn if suite else bundle))
        except Missing as lack:
            if suite:  # one of any bundle is left out in silence
                undecided.append((name, str(lack)))
    return found, undecided


# (heading, which findings belong under it). A finding moves to another heading when the data reverse it.
GROUPS = (
    ("How well the tables are reproduced", lambda f: f.about == "reproduction"),
    ("Conclusions of the report that do not hold, and why",
     lambda f: f.about == "correction" and f.holds or f.about == "conclusion" and not f.holds),
    ("Conclusions of the report that hold",
     lambda f: f.about == "conclusion" and f.holds or f.about == "correction" and not f.holds),
    ("Worth knowing", lambda f: f.about == "note"),
    ("What the suites show", lambda f: f.about == "suite"),
)


def grouped(findings):
    """(heading, findings) for the groups that have any."""
    groups = [(heading, [f for f in findings if belongs(f)]) for heading, belongs in GROUPS]
    return [(heading, members) for heading, members in groups if members]
