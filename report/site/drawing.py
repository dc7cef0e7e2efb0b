# SPDX-License-Identifier: MIT
"""Small drawings within a page, in its colours: lines over the degree, and a curve with its control polygon. Matplotlib takes 0.2 s for
each, and a page for every method has two of them."""
import html
import math
from fractions import Fraction

from report.wording import general

WIDTH, HEIGHT, LEFT, BOTTOM, TOP, RIGHT = 460, 250, 46, 34, 12, 12


def _decades(low, high):
    """Ticks of a logarithmic axis: powers of ten, or 1, 2 and 5 where there are few of these."""
    exponents = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    steps = (1, 2, 5) if len(exponents) <= 3 else (1,)
    found = [step * 10.0 ** exponent for exponent in exponents for step in steps if low * 0.999 <= step * 10.0 ** exponent <= high * 1.001]
    return found[::max(1, len(found) // 7 + (len(found) > 7))]


def chart(title, across, up, series):
    """Lines on logarithmic axes as SVG. `series` is of (name, class, dashed, [(x, y)]); every point says what it is."""
    points = [point for *_, line in series for point in line]
    if not points:
        return ""
    xs = sorted({x for x, _ in points})
    low, high = min(y for _, y in points) / 1.25, max(y for _, y in points) * 1.25

    def at(x, y):
        right = math.log(x / xs[0]) / (math.log(xs[-1] / xs[0]) or 1)
        return (LEFT + right * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - math.log(y / low) / math.log(high / low) * (HEIGHT - BOTTOM - TOP))

    parts = [f'<svg class="chart" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(title)}">']
    for y in _decades(low, high):
        _, top = at(xs[0], y)
        parts.append(f'<path class="grid" d="M{LEFT} {top:.1f}H{WIDTH - RIGHT}" /><text x="{LEFT - 6}" y="{top + 4:.1f}" text-anchor="end">{general(y)}</text>')
    for x in xs:
        left, _ = at(x, low)
        parts.append(f'<text x="{left:.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{x:g}</text>')
    parts.append(f'<text x="{(WIDTH + LEFT) / 2}" y="{HEIGHT - 3}" text-anchor="middle">{html.escape(across)}</text>')
    for name, style, dashed, line in series:
        places = [at(x, y) for x, y in sorted(line)]
        path, dashes = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places), ' stroke-dasharray="5 4"'
        parts.append(f'<path class="line {style}"{dashes * dashed} d="{path}" />')
        if not dashed:
            parts += [f'<circle class="dot {style}" cx="{left:.1f}" cy="{top:.1f}" r="3.4"><title>{html.escape(name)}, {across} {x:g}: {general(y)} '
                      f"{html.escape(up)}</title></circle>" for (left, top), (x, y) in zip(places, sorted(line))]
    return "".join(parts) + "</svg>"


def _point(control, weights, t):
    points = [[w * x for x in point] + [w] for point, w in zip(control, weights)]
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return [x / points[0][-1] for x in points[0][:-1]]


def control_points(coefficients, form):
    """Control points to draw a curve by, from the first one on: differences that rounding would lose are exact here. Of power form
    b_i = sum C(i,j)/C(n,j) q_j."""
    n, exact = len(coefficients) - 1, [[Fraction(x) for x in point] for point in coefficients]
    if form == "power":
        exact = [[sum(Fraction(math.comb(i, j), math.comb(n, j)) * exact[j][axis] for j in range(i + 1)) for axis in (0, 1)] for i in range(n + 1)]
    return [[float(x - first) for x, first in zip(point, exact[0])] for point in exact]


def curve(title, control, t, weights=None):
    """A plane curve with its control polygon and the point at t. An axis in which hardly anything moves is stretched."""
    weights = weights or [1.0] * len(control)
    line = [_point(control, weights, k / 200) for k in range(201)]
    everything = control + line
    lows, highs = ([side(point[axis] for point in everything) for axis in (0, 1)] for side in (min, max))
    sizes = [high - low or 1.0 for low, high in zip(lows, highs)]
    stretched = max(sizes) > 6 * min(sizes)
    room = (WIDTH - 2 * LEFT, HEIGHT - 2 * BOTTOM)
    scales = [room[0] / sizes[0], room[1] / sizes[1]] if stretched else [min(room[0] / sizes[0], room[1] / sizes[1])] * 2

    def at(point):
        x, y = (((value - low - size / 2) * scale) for value, low, size, scale in zip(point, lows, sizes, scales))
        return WIDTH / 2 + x, HEIGHT / 2 - y

    def path(points):
        return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in map(at, points))

    marked = at(_point(control, weights, t))
    dots = "".join(f'<circle class="control" cx="{x:.1f}" cy="{y:.1f}" r="4"><title>{name}</title></circle>'
                   for name, (x, y) in ((f"control point {i}", at(point)) for i, point in enumerate(control)))
    return (f'<svg class="chart" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(title)}">'
            f'<path class="polygon" d="{path(control)}" />{dots}'
            f'<path class="line own" d="{path(line)}" /><circle class="marked" cx="{marked[0]:.1f}" cy="{marked[1]:.1f}" r="5"><title>t = {t:.6g}</title></circle></svg>',
            stretched)
