# SPDX-License-Identifier: MIT
"""Independent reference values: the definitions in rational arithmetic, in plain Python, without code of the C++
program.

Every double is a dyadic rational, so curve values are exact rationals. A rational is a pair (numerator, denominator) of
integers with denominator > 0, not reduced: greatest common divisors of numbers with 10^5 bits would take most of the
time.
"""
import math
from fractions import Fraction

INFINITY = math.inf
UNIT_ROUNDOFF = Fraction(1, 2**53)


def ratio(x):
    """A float, integer or Fraction as (numerator, denominator)."""
    return x.as_integer_ratio()


def with_common_denominator(values):
    """Integers k_i and one denominator d with values[i] = k_i / d, for values whose denominators are powers of two."""
    pairs = [ratio(value) for value in values]
    d = max(denominator for _, denominator in pairs)
    return [numerator * (d // denominator) for numerator, denominator in pairs], d


# The two forms at t, by their definitions.


def bernstein_terms(degree, t):
    """Numerators and denominator of B_i(t): the integers C(n,i) a^i (d-a)^(n-i) and d^n, where t = a/d."""
    a, d = ratio(t)
    rising, falling = [1], [1]
    for _ in range(degree):
        rising.append(rising[-1] * a)
        falling.append(falling[-1] * (d - a))
    return [math.comb(degree, i) * rising[i] * falling[degree - i] for i in range(degree + 1)], d**degree


def power_terms(degree, t):
    """Numerators and denominator of t^j: the integers a^j d^(n-j) and d^n, where t = a/d."""
    a, d = ratio(t)
    rising, falling = [1], [1]
    for _ in range(degree):
        rising.append(rising[-1] * a)
        falling.append(falling[-1] * d)
    return [rising[j] * falling[degree - j] for j in range(degree + 1)], falling[degree]


def basis_terms(form, degree, t):
    return {"bernstein": bernstein_terms, "power": power_terms, "rational": bernstein_terms}[form](degree, t)


def _sum(terms, coefficients, weights, magnitude):
    """sum magnitude(c_i basis_i), or with weights that of w_i c_i basis_i over magnitude(sum w_i basis_i); None where the latter is zero."""
    numerators, denominator = terms
    c, d = with_common_denominator(coefficients if weights is None else [Fraction(w) * Fraction(c) for w, c in zip(weights, coefficients)])
    numerator = sum(magnitude(k * b) for k, b in zip(c, numerators))
    if weights is None:
        return numerator, d * denominator
    w, e = with_common_denominator(weights)
    below = magnitude(sum(a * k for a, k in zip(w, numerators))) * d
    return None if below == 0 else (numerator * e, below) if below > 0 else (-numerator * e, -below)


def value(terms, coefficients, weights=None):
    """p(t) = sum c_i basis_i(t), from basis_terms(); with weights sum w_i c_i basis_i(t) / sum w_i basis_i(t), or None where the
    denominator is zero."""
    return _sum(terms, coefficients, weights, lambda x: x)


def p_tilde(terms, coefficients, weights=None):
    """p~(t) = sum |c_i| |basis_i(t)|, from basis_terms(); with weights sum |w_i c_i basis_i(t)| / |sum w_i basis_i(t)|, or None."""
    return _sum(terms, coefficients, weights, abs)


def point_at(points, t):
    """The point at t of a Bezier curve by de Casteljau's algorithm, in the arithmetic of the numbers given."""
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


def solved(matrix):
    """The solution of a system of linear equations in Fractions, right-hand sides in the last columns."""
    rows = [list(row) for row in matrix]
    n = len(rows)
    for k in range(n):
        pivot = next(i for i in range(k, n) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k and rows[i][k]:
                rows[i] = [x - rows[i][k] * y if y else x for x, y in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


# Conversions, by their definitions.


def to_power(control_points):
    """q_j = C(n,j) sum_i (-1)^(j-i) C(j,i) b_i, as Fractions."""
    n = len(control_points) - 1
    b = [Fraction(point) for point in control_points]
    return [
        math.comb(n, j) * sum((-1) ** (j - i) * math.comb(j, i) * b[i] for i in range(j + 1)) for j in range(n + 1)
    ]


def to_bernstein(power_coefficients):
    """b_i = sum_j C(i,j) / C(n,j) q_j, as Fractions."""
    n = len(power_coefficients) - 1
    q = [Fraction(coefficient) for coefficient in power_coefficients]
    return [sum(Fraction(math.comb(i, j), math.comb(n, j)) * q[j] for j in range(i + 1)) for i in range(n + 1)]


# Rounding, ulp and error.


def floor_log2(x):
    """e with 2^e <= |x| < 2^(e+1), for a rational x that is not zero."""
    numerator, denominator = abs(x[0]), x[1]
    e = numerator.bit_length() - denominator.bit_length()
    # 2^(e-1) < x < 2^(e+1)
    below = numerator << -e < denominator if e < 0 else numerator < denominator << e
    return e - 1 if below else e


def ulp_exponent(x):
    """k with ulp(x) = 2^k: 2^(max(e,-1022)-52), and 2^-1074 at zero."""
    return -1074 if x[0] == 0 else max(floor_log2(x), -1022) - 52


def to_double(x):
    """The double nearest to the rational x, ties to even; infinite from 2^1024 - 2^970 on. A zero keeps its sign."""
    try:
        return x[0] / x[1]  # Python rounds the quotient of two integers once, subnormal ones as well
    except OverflowError:
        return INFINITY if x[0] > 0 else -INFINITY


def error(computed, truth):
    """|computed - truth| for a finite double and a rational."""
    a, b = ratio(computed)
    return abs(a * truth[1] - truth[0] * b), b * truth[1]


def error_ulp(distance, truth):
    """An error in units of ulp(truth)."""
    k = ulp_exponent(truth)
    return distance[0] << max(-k, 0), distance[1] << max(k, 0)


def error_u(distance, amplification):
    """error / (u p~); where p~ = 0 it is 0 for error 0, else infinite (None)."""
    if amplification[0] == 0:
        return (0, 1) if distance[0] == 0 else None
    return distance[0] * amplification[1] << 53, distance[1] * amplification[0]
