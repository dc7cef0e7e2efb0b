#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the inputs of the experiments independently of the program.

Written from the contract's table of generators and from the definitions of Philox (Salmon, Moraes, Dror, Shaw, SC'11)
and FNV-1a alone, with exact rational arithmetic where the program uses fixed-width integers. Compares the first trials
of some suites, and of a study that draws weights, with experiments/sample/first_draws.csv, which the C++ tests use as
well. Where a generator intends a polynomial, checks that the coefficients are exactly those of that polynomial.

    python3 scripts/oracle/inputs.py [--write]    exit 1 where they differ; --write makes the file
"""

import csv
import io
import math
import sys
import tomllib
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

from exact import to_bernstein

ROOT = Path(__file__).resolve().parents[2]
SUITES = [ROOT / f"experiments/suites/{name}.toml" for name in ("report", "conditioning", "derivative", "inverse_arc_length")]
DRAWS = ROOT / "experiments/sample/first_draws.csv"
WORDS_IN_KEYS = {"bernstein": "bezier", "power": "polynomial", "rational": "rational"}
COLUMNS = ["study", "form", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "trial", "t",
           "coefficients", "weights"]
WEIGHTED = {"id": "weights", "kind": "accuracy", "curve": "rational", "degree": [3], "coordinate_range": [10],
            "generator": ["weights_mild", "weights_wild"]}
GRADED = {"id": "graded", "kind": "accuracy", "degree": [3], "coordinate_range": [10], "generator": ["graded"]}
BSPLINE = {"id": "bspline", "kind": "accuracy", "degree": [3], "coordinate_range": [10], "generator": ["bspline"],
           "first_trials": 18}  # enough for every kind of knots
LOCAL = {"id": "local", "kind": "accuracy", "degree": [3], "coordinate_range": [1000], "generator": ["local"]}
TRIALS = 2
MASK = (1 << 64) - 1


def philox4x64(counter, key):
    """Ten rounds of Philox4x64 on four counter words and two key words."""
    c0, c1, c2, c3 = counter
    k0, k1 = key
    for _ in range(10):
        p0, p1 = 0xD2E7470EE14C6C93 * c0, 0xCA5A826395121157 * c2
        c0, c1, c2, c3 = (p1 >> 64) ^ c1 ^ k0, p1 & MASK, (p0 >> 64) ^ c3 ^ k1, p0 & MASK
        k0, k1 = (k0 + 0x9E3779B97F4A7C15) & MASK, (k1 + 0xBB67AE8584CAA73B) & MASK
    return c0, c1, c2, c3


def fnv1a(text):
    """64-bit FNV-1a of the UTF-8 bytes of text."""
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 & MASK
    return value


def shortest(x):
    """The text that std::to_chars(double) writes: shortest digits, fixed notation unless scientific is shorter."""
    value = Decimal(repr(float(abs(x)))).normalize()
    mantissa, exponent = f"{value:e}".split("e")
    whole = value.as_tuple().exponent >= 0
    fixed = str(int(abs(x))) if whole else f"{value:f}"  # all digits of a whole number, as printf writes them
    return ("-" if math.copysign(1, x) < 0 else "") + min(fixed, f"{mantissa}e{int(exponent):+03d}", key=len)


def canonical(cell):
    """The text whose hash is the key of a cell."""
    return (f"curve={WORDS_IN_KEYS[cell['form']]};dimension={cell['dimension']};degree={cell['degree']};"
            f"coordinate_range={shortest(cell['coordinate_range'])};"
            f"t_interval={shortest(cell['t_min'])}:{shortest(cell['t_max'])};generator={cell['generator']}")


def words(seed, study, cell, trial):
    """Yields the 64-bit words of one trial, endlessly."""
    block = 0
    while True:
        yield from philox4x64((fnv1a(study), fnv1a(canonical(cell)), trial, block), (seed, 0))
        block += 1


def uniform128(stream):
    high = next(stream)
    return high << 64 | next(stream)


def affine(a, b, stream):
    a, b = Fraction(a), Fraction(b)
    return float(a + (b - a) * Fraction(2 * uniform128(stream) + 1, 1 << 129))


def continuous(r, stream):
    return affine(-r, r, stream)


def distant(r, stream):
    return affine(r * (1 - 2.0**-20), r, stream)


def local(r, stream):
    return affine(r - 1, r, stream)


def dyadic_t(a, b, stream):
    return float(Fraction(round(Fraction(affine(a, b, stream)) * 2**53), 2**53))


def below(count, stream):
    return count * uniform128(stream) >> 128


def integer(r, stream):
    m = int(r)
    return float(below(2 * m + 1, stream) - m)


def graded(r, stream):
    exponent = below(61, stream)
    return affine(-r, r, stream) * 2.0**-exponent


def report(r, stream):
    return r * (((next(stream) >> 49) % 20001 - 10000) / 10000.0)


def report_t(a, b, stream):
    return a + (b - a) * ((next(stream) >> 49) / 32767.0)


def mild(stream):
    return affine(0.5, 2.0, stream)


def wild(stream):
    exponent = below(41, stream) - 20
    return affine(1.0, 2.0, stream) * 2.0**exponent


def multiple_root(n, _stream):
    """(leading coefficient, roots)."""
    return Fraction(1), [Fraction(3, 4)] * n


def clustered_roots(n, stream):
    multiple = math.lcm(*(math.comb(n, i) for i in range(n + 1)))
    m = max(m for m in range(1, 54) if multiple * (2**(m - 1) + n)**n <= 2**53)
    sites = [k for k in range(-n, n + 1) if k != 0]
    offsets = [0] * min(n, 1)
    for first in range(n - 1):
        chosen = first + below(len(sites) - first, stream)
        sites[first], sites[chosen] = sites[chosen], sites[first]
        offsets.append(sites[first])
    return Fraction(multiple, 1 << (multiple - 1).bit_length()), [Fraction(1, 2) + Fraction(k, 2**m) for k in offsets]


def cusp(n, dimension, stream):
    """Points, in units of R, of a curve with a cusp at c = r / (1 + r); b_0 follows from the others."""
    r, near = Fraction(1 + below(8, stream), 4), below(2, stream)
    offset = Fraction(near, 2 ** (5 + below(46, stream)))
    step = 4 ** (n - 1)
    largest = 15 * 2**22 // (step * (2 * 3 ** (n - 1) - 1))
    points = [[Fraction(step * (below(2 * largest + 1, stream) - largest), 2**26) for _ in range(dimension)]
              for _ in range(n)]
    first = [points[0][axis] + sum(math.comb(n - 1, j) * r**j * (points[j][axis] - points[j - 1][axis])
                                   for j in range(1, n)) for axis in range(dimension)]
    slope = [sum(math.comb(n - 1, j) * r**j * (q[axis] - p[axis]) for j, (p, q) in
                 enumerate(zip([first, *points], points))) for axis in range(dimension)]
    if any(slope):
        raise SystemExit("inputs.py: cusp() draws a curve without a cusp; correct it")
    return [[x + offset for x in first], *points]


def thin(n, dimension, stream):
    """Points, in units of R: whole multiples of 1/32 on the first axis, of 2^-s/32 on the others."""
    s, zigzag = 4 + below(17, stream), below(2, stream)
    points = []
    for i in range(n + 1):
        first = below(33, stream) - (32 if i % 2 == 0 else 0) if zigzag else below(65, stream) - 32
        others = [Fraction(below(65, stream) - 32, 2**s) for _ in range(dimension - 1)]
        points.append([Fraction(x) / 32 for x in [first, *others]])
    return points


def whole(u):
    return float(math.floor(64 * u))


def spread(_place, u):
    return 2.0**-10 + u


def graded_distance(_place, u):
    binade = math.floor(40 * u)
    return math.ldexp(1 + (40 * u - binade), -1 - binade)


# id: (the first knot of the span, the distance of two neighbours), both from a number in [0, 1]; the place is -1 before
# the span, 0 for the span itself and 1 after it.
KNOTS = {"uniform": (whole, lambda place, u: 1.0),
         "clamped": (lambda u: 0.0, lambda place, u: 0.0 if place < 0 else spread(place, u)),
         "random": (lambda u: u, spread),
         "multiple": (lambda u: u, lambda place, u: spread(place, u) if place == 0 or u >= 0.5 else 0.0),
         "uneven": (lambda u: u, graded_distance)}


def bspline(n, dimension, r, stream):
    """The Bernstein form of a knot span, in the double arithmetic that the generator describes."""
    first, distance = list(KNOTS.values())[below(len(KNOTS), stream)]
    begin = first(affine(0, 1, stream))
    distances = [distance((k > n - 1) - (k < n - 1), affine(0, 1, stream)) for k in range(2 * n - 1)]
    knots = [begin]
    for step in reversed(distances[:n - 1]):
        knots.insert(0, knots[0] - step)
    for step in distances[n - 1:]:
        knots.append(knots[-1] + step)
    points = [[continuous(r, stream) for _ in range(dimension)] for _ in range(n + 1)]
    a, c = knots[n - 1:n + 1]

    def blossom(arguments, d):
        for level, x in enumerate(arguments):
            for i in range(n - level):
                left, right = knots[i + level], knots[i + n]
                d[i] = (right - x) / (right - left) * d[i] + (x - left) / (right - left) * d[i + 1]
        return max(-r, min(r, d[0]))

    return [[blossom([a] * (n - k) + [c] * k, [p[axis] for p in points]) for axis in range(dimension)]
            for k in range(n + 1)]


def power_coefficients(leading, roots):
    """The power coefficients of leading * prod (t - root), ascending."""
    coefficients = [leading]
    for root in roots:
        coefficients = [a - root * b for a, b in zip([0] + coefficients, coefficients + [0])]
    return coefficients


def polynomial(curve, leading, roots):
    """The coefficients in the form of the curve, which must be doubles."""
    power = power_coefficients(leading, roots)
    exact = power if curve == "power" else to_bernstein(power)
    doubles = [float(c) for c in exact]
    if [Fraction(c) for c in doubles] != exact:
        raise SystemExit(f"inputs.py: a {curve} curve of degree {len(roots)} is not exact in doubles; lower the limit "
                         "of its generator")
    return doubles


COORDINATES = {"continuous": continuous, "dyadic": continuous, "integer": integer, "report": report, "distant": distant, "local": local,
               "graded": graded, "weights_mild": continuous, "weights_wild": continuous}
CURVES = {"cusp": cusp, "thin": thin}
ROUNDED_CURVES = {"bspline": bspline}
POLYNOMIALS = {"multiple_root": multiple_root, "clustered_roots": clustered_roots}
PARAMETERS = {"dyadic": dyadic_t, "report": report_t}  # every other generator draws t as continuous
WEIGHTS = {"weights_mild": mild, "weights_wild": wild}
# The largest degrees that the program takes.
DEGREES = {("multiple_root", "bernstein"): 33, ("multiple_root", "power"): 27, ("clustered_roots", "bernstein"): 8,
           ("clustered_roots", "power"): 8}


def draw(seed, study, cell, trial):
    """(t, coefficients point by point, weights)."""
    generator = cell["generator"]
    stream = words(seed, study, cell, trial)
    t = PARAMETERS.get(generator, affine)(cell["t_min"], cell["t_max"], stream)
    points = range(cell["degree"] + 1)
    if generator in POLYNOMIALS:
        leading, roots = POLYNOMIALS[generator](cell["degree"], stream)
        axis = polynomial(cell["form"], leading * Fraction(cell["coordinate_range"]), roots)
        return t, [c for c in axis for _ in range(cell["dimension"])], []
    if generator in CURVES:
        points = CURVES[generator](cell["degree"], cell["dimension"], stream)
        exact = [Fraction(cell["coordinate_range"]) * x for p in points for x in p]
        if any(Fraction(float(x)) != x for x in exact):
            raise SystemExit(f"inputs.py: a curve of {generator} is not exact in doubles; lower the degree of its generator")
        return t, [float(x) for x in exact], []
    if generator in ROUNDED_CURVES:
        points = ROUNDED_CURVES[generator](cell["degree"], cell["dimension"], float(cell["coordinate_range"]), stream)
        return t, [x for p in points for x in p], []
    coefficients = [COORDINATES[generator](cell["coordinate_range"], stream)
                    for _ in points for _ in range(cell["dimension"])]
    return t, coefficients, [WEIGHTS[generator](stream) for _ in points] if generator in WEIGHTS else []


def hexadecimal(x):
    """The number as C's %a writes it, without trailing zeros."""
    mantissa, exponent = float(x).hex().split("p")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return f"{mantissa}p{exponent}"


def number(value):
    """A number of a suite, which may be a string in hexadecimal."""
    return float.fromhex(value) if isinstance(value, str) and "x" in value else float(value)


def studies():
    for path in SUITES:
        suite = tomllib.loads(path.read_text(encoding="utf-8"))
        for study in suite["study"]:
            if study["kind"] in ("accuracy", "conversion", "derivative", "inverse_arc_length"):
                yield suite["suite"].get("seed", 1), study
    yield 1, WEIGHTED
    yield 1, GRADED
    yield 1, LOCAL
    yield 1, BSPLINE


def rows():
    for seed, study in studies():
        t_min, t_max = study.get("t_interval", [[0, 1]])[0]
        for generator in study.get("generator", ["continuous"]):
            cell = {"form": study.get("curve", "bernstein"), "dimension": study.get("dimension", [2])[0],
                    "degree": study["degree"][0], "coordinate_range": number(study.get("coordinate_range", [1])[0]),
                    "t_min": number(t_min), "t_max": number(t_max), "generator": generator}
            for trial in range(study.get("first_trials", TRIALS)):
                t, coefficients, weights = draw(seed, study["id"], cell, trial)
                row = {"study": study["id"], **cell, "trial": trial, "t": hexadecimal(t),
                       "coefficients": " ".join(map(hexadecimal, coefficients)),
                       "weights": " ".join(map(hexadecimal, weights))}
                for column in ("coordinate_range", "t_min", "t_max"):
                    row[column] = hexadecimal(row[column])
                yield row


def self_test():
    """The known answer that Random123 publishes for a counter and key from the digits of pi."""
    counter = (0x243F6A8885A308D3, 0x13198A2E03707344, 0xA4093822299F31D0, 0x082EFA98EC4E6C89)
    answer = (0xA528F45403E61D95, 0x38C72DBD566E9788, 0xA5A1610E72FD18B5, 0x57BD43B5E52B7FE6)
    if philox4x64(counter, (0x452821E638D01377, 0xBE5466CF34E90C6C)) != answer:
        raise SystemExit("inputs.py: Philox does not give its known answer; correct philox4x64")


def check_polynomials():
    """Checks that the coefficients are doubles at every degree that the program takes; polynomial() raises where one is
    not."""
    for (generator, curve), largest in DEGREES.items():
        for n in range(largest + 1):
            cell = {"form": curve, "dimension": 1, "degree": n, "coordinate_range": 1.0, "t_min": 0.0, "t_max": 1.0,
                    "generator": generator}
            for trial in range(20):
                draw(1, "exactness", cell, trial)
            # Words of zeros put all roots below 1/2, which gives the largest integers in Bernstein form.
            polynomial(curve, *POLYNOMIALS[generator](n, iter([0] * (2 * n))))


def main():
    if sys.argv[1:] not in ([], ["--write"]):
        print(__doc__, file=sys.stderr)
        return 2
    self_test()
    check_polynomials()
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows())
    if sys.argv[1:] == ["--write"]:
        DRAWS.write_text(text.getvalue(), encoding="utf-8")
        return 0
    stored = DRAWS.read_text(encoding="utf-8").splitlines()
    drawn = text.getvalue().splitlines()
    for number, (old, new) in enumerate(zip(stored, drawn), start=1):
        if old != new:
            print(f"{DRAWS.relative_to(ROOT)}:{number}: differs from what is drawn; find out why before --write")
            return 1
    if len(stored) != len(drawn):
        print(f"{DRAWS.relative_to(ROOT)}: {len(stored)} lines, {len(drawn)} drawn; the suite changed? then --write")
        return 1
    print(f"{len(drawn) - 1} trials agree")
    return 0


if __name__ == "__main__":
    sys.exit(main())
