# SPDX-License-Identifier: MIT
"""All findings, in the order of the page."""

from importlib import import_module

from ..bundle import Missing, decided_by

NAMES = """cells_inside bounds_hold yardstick_ranking common_rounding forward_substitution range_bend round_trip_grid
           de_casteljau_flat factorial_overflow timings_quantised printed_slip via_power_worse growth_with_degree growth_with_t
           conversion_dominates time_order sample_maximum ladder_best ladder_growth regimes_parameter regimes_range regimes_degree
           regimes_float regimes_dimension conditioning conversion_norm conversion_parts conversion_growth worst_bounds worst_gain
           rational_weights projection_isolate projection_printed choosing roofline roofline_subnormal peers_accuracy peers_cache
           derivative_as_printed derivative_distant derivative_bounds arc_length_promise arc_length_cost
           inverse_arc_length_brackets inverse_arc_length_unguarded inverse_arc_length_spacing
           fitting_promise fitting_source subdivision_halves subdivision_best grid_growth bspline_recurrence interpolation_residuals interpolation_time
           fitting_time derivative_time
           arc_length_time arc_length_time_fastest inverse_arc_length_time projection_time projection_time_fastest""".split()
ROSTER = tuple(import_module(f".{name}", __package__) for name in NAMES)


def _found(module, bundle):
    try:
        return module.find(bundle)
    except ZeroDivisionError:
        raise Missing("a ratio that it needs divides by an error or time of 0") from None


def find_all(bundle):
    """(findings, [(name, what the bundle lacks)]); the second list has the findings that cannot be decided."""
    found, undecided = [], []
    for module in ROSTER:
        suite = getattr(module, "SUITE", "report")
        if suite and not bundle.has_suite(suite):
            continue
        name = module.__name__.rsplit(".", 1)[-1]
        try:
            with decided_by(bundle, f"the finding '{name.replace('_', ' ')}'"):
                found.append(_found(module, bundle))
        except Missing as lack:
            if suite:  # nobody asked for what any bundle may have
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
