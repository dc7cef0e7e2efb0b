# SPDX-License-Identifier: MIT
"""A small hand-made bundle for the tests: round numbers with the shape of the real ones."""

import csv
import hashlib
import json
import math
from pathlib import Path

from . import schema
from .columns import COMPARISON

DEGREES, RANGES, INTERVALS = (4, 20), (100, 10000, 1000000), ((0, 0.2), (0.4, 0.6), (0.8, 1))
PATHS = {"bezier": ("de_casteljau", "factorial:power_sum"),
         "polynomial": ("forward_substitution:de_casteljau", "forward_substitution:direct")}
MEAN = {("de_casteljau", 4): 7e-11, ("de_casteljau", 20): 9.5e-11, ("factorial:power_sum", 4): 3e-10,
        ("factorial:power_sum", 20): 1.2e-3, ("forward_substitution:de_casteljau", 4): 1.4e-10,
        ("forward_substitution:de_casteljau", 20): 7.5e-4, ("forward_substitution:direct", 4): 1.3e-10,
        ("forward_substitution:direct", 20): 7.5e-4}
# Columns that apply to some rows only; bundles of older programs have none of them.
SOMETIMES = ("mean_error_ulp", "max_error_ulp", "mean_relative", "p50_relative", "max_relative", "p50_condition", "max_condition",
             "mean_conversion_error", "max_conversion_error", "mean_one_minus_t_error", "max_one_minus_t_error",
             "mean_evaluation_error", "max_evaluation_error")
U = 2.0 ** -53
BEND = {100: 3.0, 10000: 1.1, 1000000: 1.0}  # error over range on the report's grid


def _score(table, curve, method, statistic, degree, coordinate_range, interval, median, **more):
    row = dict(table=table, curve=curve, method=method, statistic=statistic, degree=degree, coordinate_range=coordinate_range,
               t_min=interval[0], t_max=interval[1], published=median * 1.02, ours_median=median, ours_p05=median * 0.95,
               ours_p95=median * 1.05, continuous_median=median, against_exact=median, verdict="inside", note="")
    return {**row, **more}


def scorecard():
    """Printed cells of 2.3.1, 2.3.2, 2.3.3 and 2.2; two of them are the slip."""
    rows = []
    for curve, methods in PATHS.items():
        for statistic, size in (("mean_error", 1), ("max_error", 30)):
            for m in methods:
                rows += [_score("2.3.1", curve, m, statistic, n, 1000000, (0, 1), MEAN[m, n] * size) for n in DEGREES]
    for curve, methods in PATHS.items():
        for statistic, size in (("mean_error", 1), ("max_error", 30)):
            for m in methods:
                for r in RANGES:
                    base = MEAN[m, 20] * size * r / 1e6
                    bent = base * (BEND[r] if m == "factorial:power_sum" else 1)
                    more = dict(continuous_median=base * 3)
                    if curve == "polynomial" and statistic == "max_error" and r == 10000:
                        more.update(published=bent * 10, verdict="explained", note="likely a slip")
                    rows.append(_score("2.3.2", curve, m, statistic, 20, r, (0, 1), bent, **more))
    for curve, methods in PATHS.items():
        for m in methods:
            steps = (1.2, 0.8, 1.1) if m == "de_casteljau" else (1e-6, 1e-2, 3)
            rows += [_score("2.3.3", curve, m, statistic, 20, 1000, i, MEAN[m, 20] / 1e3 * k * size)
                     for statistic, size in (("mean_error", 1), ("max_error", 30)) for i, k in zip(INTERVALS, steps)]
    for limit, n in (("1e-5", 190), ("1e-3", 197), ("0.1", 200)):
        rows.append(_score("2.2", "bezier", "factorial+forward_substitution+factorial", f"count_within_{limit}", "1..20",
                           1000000, ("", ""), n, published=n, ours_p05=n - 4, ours_p95=n + 4))
    return rows


def scorecard_timing():
    times = {"direct": 0.03, "de_casteljau": 0.06, "factorial:power_sum": 0.2, "power_sum": 0.01,
             "forward_substitution:direct": 0.3, "forward_substitution:de_casteljau": 0.4}
    rows = []
    for method, time in times.items():
        curve = "polynomial" if method.startswith(("power", "forward")) else "bezier"
        for n in DEGREES:
            row = _score("2.4", curve, method, "total_time", n, 1000000, (0, 1), time * n / 4, continuous_median="",
                         against_exact="", published=1 if time < 0.1 else 7, verdict="untestable" if time < 0.1 else "outside")
            rows.append({**row, "prepared_median": time * n / 12})
    return rows


def _judged(study, method, degree, mean, generator="continuous", baseline="exact", coordinate_range=1000000, interval=(0, 1),
            **more):
    row = dict(study=study, curve="polynomial" if "polynomial" in study else "bezier", method=method, scalar="double",
               dimension=2, degree=degree, coordinate_range=coordinate_range, t_min=interval[0], t_max=interval[1],
               generator=generator, trials=1000, baseline=baseline, status="ok", mean_error=mean, rms_error=mean,
               p50_error=mean, p99_error=mean * 5, max_error=mean * 60, mean_error_u=mean * 1e10, max_error_u=mean * 1e11,
               bound_u=mean * 1e12, bound_violations=0, non_finite=0)
    return {**row, **dict.fromkeys(SOMETIMES, ""), **more}


def _suites():
    """Rows of the other suites, by mean error over u p~."""
    def row(study, method, degree, mean_u, *rest, **more):
        return _judged(study, method, degree, mean_u * 1e-10, *rest, **more)
    ladder = {"bezier": {"de_casteljau": (0.5, 1.5), "compensated_de_casteljau": (0.25, 0.125), "factorial:power_sum": (1, 1e17)},
              "polynomial": {"horner": (0.5, 0.5), "forward_substitution:direct": (1, 1e17)}}
    rows = [row(f"ladder-{curve}", m, n, u, g) for curve, methods in ladder.items() for m, ends in methods.items()
            for n, u in zip(DEGREES, ends) for g in ("continuous", "integer")]
    rows += [row("regimes-parameter", m, 20, u, interval=i) for m in ("de_casteljau", "wozny_chudy")
             for i, u in (((0, 0.001), 2), ((1, 2), 1))]
    rows += [row("regimes-range", m, 20, u, coordinate_range=r) for m, u in (("de_casteljau", 1.5), ("factorial:power_sum", 1e6))
             for r in (1e-300, 1, 1e300)]
    rows += [row("regimes-degree", "de_casteljau", n, 2) for n in (100, 1023)]
    rows += [row("regimes-float", "de_casteljau", n, 1, scalar=s) for s in ("float", "double") for n in DEGREES]
    rows += [row("regimes-dimension", "de_casteljau", 20, 1, dimension=d) for d in (1, 2, 3)]
    rows += [row("conditioning-bernstein", m, 5, 1, "multiple_root", interval=i, p50_condition=c, max_condition=3 * c,
                 p50_relative=max(U / 2, c * U ** k), max_relative=max(U, 3 * c * U ** k))
             for m, k in (("de_casteljau", 1), ("compensated_de_casteljau", 2))
             for c, i in ((1, (0, 0.25)), (1e10, (0.76, 0.78)), (1e20, (0.751, 0.752)), (1e36, (0.7501, 0.7502)))]
    rows += [_judged("conversion-paths-to-power", m, 20, e[0], interval=i, mean_conversion_error=e[1], mean_one_minus_t_error=e[2],
                     mean_evaluation_error=e[3], max_conversion_error=e[1], max_one_minus_t_error=e[2], max_evaluation_error=e[3])
             for m, errors in (("de_casteljau", ((2e-10, 0, 1e-10, 1e-10), (1e-10, 0, 0, 1e-10))),
                               ("factorial:horner", ((3e-9, 2e-9, 0, 1e-9), (4e-3, 3e-3, 0, 1e-3))))
             for i, e in zip(((0, 0.2), (0.8, 1)), errors)]
    rows += [row("rational-ladder", m, n, u * (1.5 if g == "weights_wild" else 1), g, curve="rational")
             for m, u in (("direct", 1), ("de_casteljau", 1.25)) for n in DEGREES for g in ("weights_mild", "weights_wild")]
    rows += [row("peers-bezier", "de_casteljau", n, 0.5) for n in DEGREES]
    return rows


PEERS = {"peer_gsl": (0.5, 0.5), "peer_sisl": (0.5, 0.6), "peer_occt_bsplclib": (0.5, 0.5), "peer_occt_cached": (2, 1e8)}


def unstable():
    """Methods of other libraries."""
    return [_judged("peers-bezier", m, n, u * 1e-10) for m, ends in PEERS.items() for n, u in zip(DEGREES, ends)]


def accuracy():
    rows = []
    for n in DEGREES:
        k = 1 + n / 20
        rows += [_judged("2.3.1-bezier", "de_casteljau", n, 0.9e-10, baseline="direct"),
                 _judged("2.3.1-bezier", "de_casteljau", n, 1.3e-10), _judged("2.3.1-bezier", "direct", n, 1.35e-10)]
        for curve, methods in PATHS.items():
            yardstick = "direct" if curve == "bezier" else "power_sum"
            rows += [_judged(f"2.3.1-{curve}", m, n, MEAN[m, n], "report", yardstick) for m in methods]
        for method, mean in (("direct", 0.75e-10), ("de_casteljau", 0.7e-10)):
            rows += [_judged("truth-bezier", method, n, mean * k), _judged("truth-bezier", method, n, mean * k / 2, "dyadic")]
        rows += [_judged("truth-bezier", "factorial:power_sum", n, MEAN["factorial:power_sum", n]),
                 _judged("truth-polynomial", "forward_substitution:de_casteljau", n, MEAN["forward_substitution:direct", n]),
                 _judged("truth-polynomial", "positive_sum:de_casteljau", n, 2e-10 * k)]
    rows += [_judged("truth-bezier", m, 21, 1e-10) for m in ("direct", "factorial:power_sum")]
    for r in RANGES:
        rows += [_judged("2.3.2-bezier", "factorial:power_sum", 20, r * 1e-9 * bend, g, "direct", r, mean_error_u=4e7 * bend)
                 for g, bend in (("report", BEND[r]), ("continuous", 3.0))]
    rows += [_judged("2.3.3-bezier", "de_casteljau", 20, e, interval=i) for i, e in zip(INTERVALS, (2.4e-13, 1e-13, 0.8e-13))]
    return rows + _suites()


def conversion():
    share = {"report": (95, 98, 100), "continuous": (59, 80, 99), "integer": (100, 100, 100)}
    def row(study, conversion, degree, generator, mean, largest, within, curve="bezier"):
        return {"study": study, "conversion": conversion, "degree": degree, "coordinate_range": 1000000, "generator": generator,
                "trials": 100, "mean_error": mean, "max_error": largest, "within_1e-5": within[0], "within_1e-3": within[1],
                "within_0.1": within[2], "curve": curve, "dimension": 2, "status": "ok", "non_finite": 0}
    rows = [row("2.2", "factorial+forward_substitution+factorial", n, g, 1e-6, 1e-2, within) for n in (1, 2)
            for g, within in share.items()]
    errors = {("bezier", "factorial"): (1e-9, 0.1), ("polynomial", "forward_substitution"): (1e-9, 0.1),
              ("polynomial", "positive_sum"): (1e-10, 1e-9)}
    return rows + [row(f"conversion-{curve}", m, n, "continuous", e / 4, e, (100, 100, 100), curve)
                   for (curve, m), ends in errors.items() for n, e in zip(DEGREES, ends)]


def inverse_arc_length():
    def row(method, tolerance, failed):
        return dict(study="inverse_arc_length-tolerance", curve="bezier", method=method, scalar="double", dimension=2, degree=3,
                    coordinate_range=1, t_min=0, t_max=1, generator="continuous", tolerance=tolerance, trials=100, status="ok",
                    mean_relative=tolerance / 9, max_relative=tolerance * (0.5 if not failed else 1e3), max_t_error=tolerance * 2,
                    mean_iterations=5.5, max_iterations=9, mean_evaluations=200, non_converged=failed, broken_promises=0,
                    outside=failed, non_finite=0)
    return [row(m, tolerance, 7 if m == "seed_000_newton" else 0) for m in ("bracketed_newton", "halley", "seed_000_newton")
            for tolerance in (1e-3, 1e-9)]


def spacing():
    """A half circle, near enough, run through ever faster."""
    def row(spacing, index, angle, gap=""):
        return dict(study="inverse_arc_length-tolerance", dimension=2, degree=3, coordinate_range=1, generator="continuous", trial=0,
                    spacing=spacing, index=index, t=index / 4, x=math.cos(angle), y=math.sin(angle), z="", share=angle / math.pi,
                    gap=gap)
    return ([row("outline", k, k / 4 * math.pi) for k in range(5)]
            + [row("parameter", k, (k / 4) ** 2 * math.pi, (2 * k - 1) / 4 if k else "") for k in range(5)]
            + [row("arc_length", k, k / 4 * math.pi, 1.0 if k else "") for k in range(5)])


def derivative():
    """Mean errors in u p~ by study and method, for orders 1 and 2."""
    ends = {("derivative-order", "differences_de_casteljau"): (0.5, 0.5), ("derivative-order", "seed_000"): (0.5, 1e15),
            ("derivative-distant", "differences_de_casteljau"): (0.5, 0.5), ("derivative-distant", "triangle_derivatives"): (2e6, 3e6)}
    rows = []
    for (study, method), errors in ends.items():
        for n in DEGREES:
            for k, mean_u in enumerate(errors, 1):
                row = _judged(study, method, n, mean_u * 1e-16, "distant" if "distant" in study else "continuous",
                              coordinate_range=1, order=k, mean_error_u=mean_u, max_error_u=5 * mean_u, bound_u=60 * mean_u)
                if method == "seed_000":
                    row.update(bound_u="", bound_violations="")
                rows.append({c: v for c, v in row.items() if c not in (*SOMETIMES, "baseline", "rms_error")})
    return rows


def subdivision():
    """Mean errors in u p~ by method, all junctions shared."""
    rows = []
    for method, mean_u in (("de_casteljau_split", 0.5), ("lerp_split", 0.75)):
        for n in DEGREES:
            row = _judged("subdivision-degree", method, n, mean_u * 1e-16, coordinate_range=1, mean_error_u=mean_u,
                          max_error_u=5 * mean_u, max_weight_error_u="", bound_u=60 * mean_u, junctions_apart=0, ends_moved=0,
                          points_off=0 if method == "de_casteljau_split" else "")
            rows.append({c: v for c, v in row.items() if c not in (*SOMETIMES, "baseline", "rms_error")})
    return rows


def grid():
    """Mean errors in u p~ by method and number of points; those of forward differencing grow with it."""
    rows = []
    for method, mean_u in (("pointwise_de_casteljau", lambda points: 0.5), ("forward_differencing", lambda points: points / 16)):
        for n in DEGREES:
            for points in (17, 257):
                mean = mean_u(points)
                row = _judged("grid-points", method, n, mean * 1e-16, coordinate_range=1, points=points, mean_error_u=mean,
                              max_error_u=5 * mean, mean_last_error_u=2 * mean, max_last_error_u=5 * mean, bound_u=60 * mean)
                rows.append({c: v for c, v in row.items() if c not in (*SOMETIMES, "baseline", "rms_error")})
    return rows


def _lengths(study, costs):
    """Evaluations by method and tolerance; methods of a constant cost never promise."""
    return [dict(study=study, curve="bezier", method=m, scalar="double", dimension=2, degree=3, coordinate_range=1,
                 t_min=0, t_max=1, generator=g, tolerance=e, trials=100, status="ok", mean_error=e / 8, p50_error=e / 9, p99_error=e / 3,
                 max_error=e / 2, mean_relative=e / 8, max_relative=e / 2, mean_evaluations=n, max_evaluations=3 * n,
                 non_converged=100 if ends[0] == ends[1] else 0, broken_promises=0, non_finite=0)
            for m, ends in costs.items() for g in ("continuous", "integer") for e, n in zip((1e-3, 1e-9), ends)]


def arc_length():
    ours = {"adaptive_simpson38": (40, 400), "gauss_legendre_adaptive": (30, 60), "gauss_legendre_24": (24, 24)}
    return _lengths("arc_length-tolerance", ours) + _lengths("companion_peers-length", {"gauss_legendre_adaptive": (30, 60)})


def arc_length_unstable():
    return _lengths("companion_peers-length", {"peer_2geom_length": (0, 0)})


def _bits(curve):
    return dict(coordinate_range=1, t_min=0, t_max=1, error=1e-16, t="0x1p-2", coefficients="0x1p+0 -0x1p-1 0.25 1",
                weights="0x1p+0 0x1p-1" if curve == "rational" else "")


def search():
    cases = [("worst-bezier", "direct", 4, "reached", 4, 8, 17), ("worst-bezier", "direct", 20, "reached", 10, 22, 62),
             ("worst-bezier", "de_casteljau_lerp", 4, "reached", 4, 20, ""), ("worst-bezier", "de_casteljau_lerp", 20, "short", 4, 5, ""),
             ("worst-bezier", "compensated_de_casteljau", 4, "near_bound", 0.7, 0.8, 1),
             ("worst-bezier", "factorial:horner", 20, "reached", 100, 1e40, 1e41),
             ("rational-worst", "direct", 4, "reached", 3, 6, 24)]
    return [dict(search_id=f"s{i}", study=study, curve="rational" if "rational" in study else "bezier", method=m, scalar="double",
                 dimension=2, degree=n, generator="continuous", trials=1000, budget=2000, status=status, sampled_error_u=a,
                 searched_error_u=b, bound_u=bound, **_bits(study[:8]))
            for i, (study, m, n, status, a, b, bound) in enumerate(cases, 1)]


def guarantees():
    verdicts = {("de_casteljau", "ends_exact"): ("proved", 0), ("de_casteljau", "monotone"): ("refuted", 5),
                ("correctly_rounded", "ends_exact"): ("proved", 0), ("correctly_rounded", "monotone"): ("not_refuted", 0)}
    shown = dict(t="0x1p-2", t_next="0x1.8p-2", coefficients="0x1p+0 0x1p+1 0x1p+0 0x1p+1")
    return [dict(study="guarantees-few", method=m, scalar="double", dimension=2, degree=n, property=p, verdict=v, trials=100,
                 broken=k, searched=50, largest=k / 5, offset="", **(shown if v != "proved" else dict(t="", t_next="", coefficients="")))
            for n in (1, 3) for (m, p), (v, k) in verdicts.items()]


def worst():
    return [dict(worst_id=f"w{i}", study=r["study"], curve=r["curve"], method=r["method"], scalar=r["scalar"], dimension=r["dimension"],
                 degree=r["degree"], generator=r["generator"], trial=i, error_u=r["max_error_u"],
                 **{**_bits(r["curve"]), **{c: r[c] for c in ("coordinate_range", "t_min", "t_max")}})
            for i, r in enumerate(_suites(), 1)]


def methods():
    ids = {"direct": "evaluation", "de_casteljau": "evaluation", "factorial:power_sum": "evaluation", "factorial": "conversion",
           **{m: problem for problem, _, methods, _ in COMPANIONS for m in methods}}
    return [dict(id=i, problem=problem, form="bernstein", min_degree=0, max_degree=170, bound="gamma_3n p~", bit_stable="yes",
                 flops="n", citation="none") for i, problem in ids.items()]


def generators():
    """Of some generators that the bundle's rows name; older bundles have no such file."""
    return [dict(id=i, coordinates=f"what {i} draws", t="as continuous", weights="in [1/2, 2]" if "weights" in i else "")
            for i in ("continuous", "report", "weights_mild", "unused")]


def audit():
    return [dict(study="truth-bezier", curve="bezier", tier="long_double", significand_bits=64, dimension=2, degree=20,
                 coordinate_range=1000000, t_min=0, t_max=1, generator="continuous", trials=1000, mean_axis_error_ulp=0.003,
                 max_axis_error_ulp=1.25)]


# problem, study, ns by method (per point where there are data points; the first is what ratios are relative to), what is asked
_TO = [dict(tolerance=e) for e in (1e-3, 1e-10)]
COMPANIONS = [
    ("derivative", "companion_speed-derivative", {"differences_horner": 40, "triangle_derivatives": 80, "seed_000": 60},
     [dict(order=1, degree=5), dict(order=2, degree=5)]),
    ("arc_length", "companion_speed-length", {"gauss_legendre_adaptive": 900, "adaptive_simpson38": 5000}, _TO),
    ("arc_length", "companion_peers-length_speed",
     {"peer_2geom_length": 9000, "peer_occt_length": 20000, "gauss_legendre_adaptive": 900}, _TO),
    ("inverse_arc_length", "companion_speed-at_length", {"halley": 1500, "bracketed_newton": 1700}, _TO),
    ("projection", "companion_speed-projection", {"quintic_isolate": 400, "scan_refine": 8000}, [{}]),
    ("projection", "companion_peers-projection_speed",
     {"peer_2geom_nearest": 5000, "peer_sisl_closest": 4000, "quintic_isolate": 400}, [{}]),
    ("interpolation", "companion_speed-interpolation", {"c2_natural": 60, "c2_natural_handles": 40},
     [dict(points=k) for k in (10, 100, 1000)]),
    ("subdivision", "subdivision-time", {"de_casteljau_split": 30, "lerp_split": 40}, [dict(degree=5), dict(degree=20)]),
    ("grid", "grid-time", {"pointwise_de_casteljau": 3000, "forward_differencing": 400}, [dict(points=k) for k in (17, 257)]),
    ("fitting", "companion_speed-fitting", {"schneider": 500, "gauss_newton": 2500},
     [dict(points=40, tolerance=e, data=data) for data in ("samples", "noisy") for e in (1e-2, 1e-6)]),
]


def timing():
    def row(method, degree, ns, quality="ok", study="2.4-bezier", mode="point", relative_to="", ratio="", **asked):
        return dict(study=study, curve="bezier", method=method, scalar="double", dimension=2 if degree else "",
                    degree=degree, mode=mode, median_ns=ns, low_ns=ns * 0.9, high_ns=ns * 1.1, rounds=9,
                    points_per_round=64, relative_to=relative_to, ratio=ratio, ratio_low=ratio and ratio * 0.9,
                    ratio_high=ratio and ratio * 1.1, cycles="", instructions="", quality=quality, checked="yes",
                    coordinate_range=1, t_min=0, t_max=1, generator="continuous",
                    **{"order": "", "tolerance": "", "points": "", "data": "", "call_ns": "", "limit_ns": "", "share_of_limit": "",
                       "chain_ns": "", "max_error_u": "", "allowed_error_u": "", **asked})
    companions = []
    for _, study, methods, all_asked in COMPANIONS:
        first = next(iter(methods))
        companions += [row(m, asked.get("degree", 3), ns * asked.get("points", 1), study=study, mode="one_shot", relative_to=first,
                           ratio=ns / methods[first] * (1.2 if m != first else 1),
                           **{c: v for c, v in asked.items() if c != "degree"}) for asked in all_asked for m, ns in methods.items()]
    return [row("direct", n, n * 1.5, call_ns=1, limit_ns=n, share_of_limit=n / (n * 1.5 - 1), chain_ns=2 * n) for n in DEGREES] + [row("sentinel", "", 1.5)] + [
        row(m, n, n * 8.0, study="peers-speed") for m in ("de_casteljau", *PEERS) for n in DEGREES] + companions


def complexity():
    study, methods, asked = next(rest for problem, *rest in COMPANIONS if problem == "interpolation")
    return [dict(study=study, curve="bezier", method=m, scalar="double", dimension=2, mode="one_shot", first_degree=3, last_degree=3,
                 exponent=1, exponent_low=0.9, exponent_high=1.1, claimed=1, verdict="within", coordinate_range=1, t_min=0, t_max=1,
                 generator="continuous", first_points=asked[0]["points"], last_points=asked[-1]["points"]) for m in methods]


def pareto():
    """Two methods that are worth choosing and two that are beaten."""
    cases = {"horner_bernstein": (1, 12, "yes"), "compensated_de_casteljau": (30, 1, "yes"), "de_casteljau": (5, 14, "no"),
             "direct": (3, 15, "no")}
    return [dict(study="speed-bezier", accuracy_study="speed-errors-bezier", curve="bezier", method=m, scalar="double", dimension=2,
                 degree=n, mode="point", ns=ns * n, ns_low=ns * n * 0.9, ns_high=ns * n * 1.1, observed_max_u=u, bound_u=4 * u,
                 observed_max=u * 1e-16, bound=u * 4e-16, quality="ok", pareto=front, coordinate_range=1, t_min=0, t_max=1,
                 generator="continuous") for n in DEGREES for m, (ns, u, front) in cases.items()]


def roofline():
    """A goal that is met and one that is not asked for, with the scalar kernels beside; and work in float that is slow but in
    the middle."""
    def row(method, degree, target, share, goal, study="roofline-bezier", scalar="double", t_min=0):
        ns = 2.0 * degree / (10 * (share or 0.1))
        return dict(study=study, curve="bezier", method=method, scalar=scalar, dimension=2, degree=degree,
                    target=target, median_ns=ns, low_ns=ns * 0.9, high_ns=ns * 1.1, flops=2 * degree, gflops=2 * degree / ns,
                    peak_gflops=10 if share else "", mixed_peak_gflops=12 if share else "", share_of_peak=share, share_low=share,
                    share_high=share, goal_share=goal, goal_ns="", goal_met="yes" if goal else "", quality="ok" if share else "",
                    rounds=41, checked="yes", t_min=t_min, t_max=1 - t_min, mode="batch" if share else "point", call_ns=1,
                    limit_ns=ns / 4, share_of_limit=0.3, chain_ns="" if share else ns)
    return [r for m, goal in (("horner_bernstein_fma", 0.6), ("de_casteljau", "")) for n in DEGREES
            for r in (row(m, n, "AVX2", 0.65, goal), row(m, n, "scalar", "", ""))] + [
                row("horner_bernstein_fma", 20, "AVX2", 0.05, "", scalar="float"),
                row("horner_bernstein_fma", 20, "AVX2", 0.7, "", study="roofline-middle", scalar="float", t_min=0.4)]


def _projected(method, missed, largest):
    return [dict(study="projection-cubics", curve="bezier", method=method, scalar="double", dimension=2, degree=3, coordinate_range=1,
                 t_min=0, t_max=1, generator="continuous", placement=placement, trials=1000, status="ok", missed=missed,
                 max_error_eps=largest, max_t_error=1e-9, non_converged=0) for placement in ("uniform", "cusp")]


def projection():
    return _projected("quintic_isolate", 0, 1.5) + _projected("scan_bisect", 5, 1e14)


def projection_unstable():
    return _projected("quintic_companion", 0, 1e9) + _projected("quintic_seed_002", 700, 4e15)


def interpolation():
    """The largest C2 residual by method and number of points."""
    ends = {"c2_natural": (3, 4), "c2_natural_handles": (6, 16)}
    return [dict(study="interpolation-points", curve="bezier", method=m, scalar="double", dimension=2, degree=3, coordinate_range=1,
                 t_min=0, t_max=1, generator="continuous", points=k, trials=100, status="ok", max_error_u=c2 / 4, max_data_u=0,
                 max_c0_u=0, max_c1_u=1, max_c2_u=c2, max_natural_u=2, bound_u=7.1 if m == "c2_natural" else "",
                 bound_violations=0 if m == "c2_natural" else "", non_finite=0)
            for m, values in ends.items() for k, c2 in zip((10, 100), values)]


def fitting():
    """Segments by method, kind of data and tolerance."""
    return [dict(study=study, curve="bezier", method=m, scalar="double", dimension=2, degree=3, coordinate_range=1, t_min=0,
                 t_max=1, generator="continuous", data=data, points=40, tolerance=e, trials=100, status="ok", mean_segments=n,
                 max_segments=3 * n, one_segment=100 if n == 1 else 0, mean_error=e / 3, p50_error=e / 3, max_error=e / 2,
                 max_error_over_tolerance=0.5, mean_claimed=e / 3, max_claimed=e / 2, mean_iterations=9, max_iterations=20,
                 non_converged=0, broken_promises=0, understated=0, non_finite=0)
            for study in ("fitting-cubics", "companion_speed-fitting_errors")
            for data in ("samples", "noisy") for e, counts in ((1e-2, (2, 1)), (1e-6, (20, 1)))
            for m, n in zip(("schneider", "gauss_newton"), counts)]


def fitting_example():
    """Three points and a straight segment near them."""
    data = [("", "", i, i, i % 2 / 100) for i in range(3)]
    curves = [(m, 0, i, 2 * i / 3, 0) for m in ("schneider", "gauss_newton") for i in range(4)]
    return [dict(study="fitting-cubics", data=kind, tolerance=1e-2, method=m, segment=s, index=i, x=x, y=y)
            for kind in ("samples", "noisy") for m, s, i, x, y in data + curves]


FILES = {"accuracy.csv": accuracy, "unstable.csv": unstable, "scorecard.csv": scorecard, "scorecard_timing.csv": scorecard_timing,
         "conversion.csv": conversion, "derivative.csv": derivative, "subdivision.csv": subdivision, "grid.csv": grid,
         "arc_length.csv": arc_length,
         "arc_length_unstable.csv": arc_length_unstable,
         "inverse_arc_length.csv": inverse_arc_length, "spacing.csv": spacing, "projection.csv": projection,
         "projection_unstable.csv": projection_unstable, "interpolation.csv": interpolation, "fitting.csv": fitting,
         "fitting_example.csv": fitting_example, "search.csv": search, "worst.csv": worst, "guarantees.csv": guarantees, "methods.csv": methods, "generators.csv": generators,
         "audit.csv": audit, "timing.csv": timing, "complexity.csv": complexity, "pareto.csv": pareto, "roofline.csv": roofline}
INFO = {"schema_version": 1, "suites": {"ids": ["report"], "digest": "00"}, "seed": 1, "state": "complete",
        "accuracy_digest": "ab", "program_version": "0.1.0", "git_commit": "none & <none>", "git_clean": True, "fp_flags": "-x"}


def _placeholder(file, column):
    """A field that no test looks at."""
    return "" if schema.may_be_empty(file, column) else 1 if schema.holds_numbers(file, column) else "x"


KNOWN = ("ladder regimes conditioning conversion worst guarantees rational peers derivative arc_length inverse_arc_length projection interpolation "
         "fitting subdivision grid companion_speed companion_peers speed roofline").split()
PRINTED = ("2.2", "2.3", "2.4")  # how the ids of studies with printed values begin
TITLES = {"companion_speed-fitting": 'Fits to "points"'}
KINDS = {"unstable": "accuracy", "pareto": "timing"}


def suite_toml(files=tuple(FILES), **titles):
    """Every study of the fixture in its suite, as a run of all of them resolves them."""
    suites = {}
    for file in files:
        name = file.removesuffix(".csv").removesuffix("_unstable")
        for row in FILES[file]():
            study = row.get("study")
            if study and name not in ("worst", "complexity", "audit", "spacing", "fitting_example", "scorecard", "scorecard_timing"):
                suite = next((one for one in KNOWN if study.startswith(f"{one}-")), "report")
                suites.setdefault(suite, {}).setdefault(study, KINDS.get(name, name))
    lines = ["schema_version = 1"]
    for suite, studies in suites.items():
        lines += ["[[suites]]", f"id = {json.dumps(suite)}", f"title = {json.dumps(f'All about {suite}')}"]
        for study, kind in studies.items():
            title = {**TITLES, **titles}.get(study, study)
            lines += ["[[suites.study]]", f"id = {json.dumps(study)}", f"title = {json.dumps(title)}", f"kind = {json.dumps(kind)}"]
            if study.startswith(PRINTED):
                lines.append('published = "printed.csv"')
    return "\n".join(lines) + "\n"


def write(directory, change=None, without=()):
    """Writes the bundle. `change(file, row)` may alter each row in place, or return False to leave it out."""
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "bundle.json").write_text(json.dumps(INFO))
    (directory / "machine.json").write_text(json.dumps({"cpu": {"model_name": "test"}, "load": [0.5, 1]}))
    (directory / "suite.toml").write_text(suite_toml())
    for file, make in FILES.items():
        if file in without:
            continue
        rows = [row for row in make() if change is None or change(file, row) is not False]
        with open(directory / file, "w", newline="", encoding="utf-8") as out:
            given = make()[0]
            writer = csv.DictWriter(out, [name for name in schema.columns(file) if name in given or name in schema.required(file)],
                                    lineterminator="\n")
            writer.writeheader()
            writer.writerows({name: row[name] if name in row else _placeholder(file, name) for name in writer.fieldnames} for row in rows)
    return seal(directory)


def seal(directory):
    """Writes SHA256SUMS over the files that are there, as a run does at its end."""
    directory = Path(directory)
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(directory.iterdir())
             if path.is_file() and not path.is_symlink() and path.stat().st_size < 1 << 30 and path.name != "SHA256SUMS"]
    (directory / "SHA256SUMS").write_text("".join(lines))
    return directory


# What `bezierbench compare` writes of two bundles.
FACTS = [dict(against="a", bundle="x/b", fact="build.compiler", a="GNU 12.2.0", b="Clang 14.0.6")]
ACCURACY = dict(kind="accuracy", study="s", method="direct", scalar="double", dimension=2, degree=4, a="1e-10", b="1e-10", ratio=1,
                verdict="identical", against="a", bundle="x/b", file="accuracy.csv", column="max_error")
TIME = dict(kind="timing", study="t", curve="bezier", method="direct", scalar="double", dimension=2, degree=4, mode="point", a=10, b=11,
            ratio=1.1, ratio_low=1.09, ratio_high=1.12, verdict="slower", against="a", bundle="x/b", file="timing.csv",
            column="median_ns", quality="ok", normalised=1.001, normalised_low=0.995, normalised_high=1.005,
            normalised_verdict="same", rank_a=1, rank_b=2)
SENTINEL = {**TIME, "method": "sentinel", "degree": "", "normalised": "", "normalised_low": "", "normalised_high": "",
            "normalised_verdict": "", "rank_a": "", "rank_b": ""}
STANDINGS = [dict(rank=1, bundle="a", cpu="CPU", compiler="GNU", machine="same", accuracy_rows_differing=0, timings=1, mean_ratio=1,
                  mean_normalised=1),
             dict(rank=2, bundle="x/b", cpu="CPU", compiler="Clang", machine="other", accuracy_rows_differing=1, timings=1, mean_ratio=1.1,
                  mean_normalised="nan")]


def write_comparison(directory, rows=(ACCURACY, TIME, SENTINEL), facts=tuple(FACTS)):
    """Writes a comparison; columns that a row lacks are empty."""
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    for name, table in (("comparison.csv", rows), ("facts.csv", facts), ("standings.csv", STANDINGS)):
        with open(directory / name, "w", newline="", encoding="utf-8") as out:
            columns = list(dict.fromkeys([*COMPARISON[name], *(key for row in table for key in row)]))
            writer = csv.DictWriter(out, columns, lineterminator="\n", restval="")
            writer.writeheader()
            writer.writerows(table)
    return directory
