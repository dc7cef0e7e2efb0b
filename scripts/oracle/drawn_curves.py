# SPDX-License-Identifier: MIT
"""Control points of random and difficult curves for the oracles: functions of a random.Random, the degree and the
dimension."""


def uniform(draw, n, d):
    return [[draw.uniform(-1, 1) for _ in range(d)] for _ in range(n + 1)]


def integers(draw, n, d):
    return [[float(draw.randint(-3, 3)) for _ in range(d)] for _ in range(n + 1)]


def graded(draw, n, d):
    return [[draw.uniform(-1, 1) * 2.0 ** draw.randint(-40, 40) for _ in range(d)] for _ in range(n + 1)]


def straight(draw, n, d):
    step = [float(draw.randint(-3, 3)) for _ in range(d)]
    return [[i * s for s in step] for i in range(n + 1)]


def constant(draw, n, d):
    return uniform(draw, 0, d) * (n + 1)


def mirrored(draw, n, d):
    half = uniform(draw, n // 2, d)
    whole = half + [[-p[0], *p[1:]] for p in reversed(half)]
    return whole[: n + 1] if n % 2 else whole[: n // 2] + [[0.0, *half[-1][1:]]] + whole[n // 2 + 2:]


def collinear(draw, n, d):
    """Control points in any order on a line."""
    step = [float(draw.randint(1, 3)) for _ in range(d)]
    return [[k * s for s in step] for k in (draw.randint(-8, 8) for _ in range(n + 1))]


def cusp(draw, _n, d):
    """A cubic with a cusp at t = 1/2: b_0 + b_1 = b_2 + b_3 makes its derivative 3 (D_0 + 2 D_1 + D_2) / 4 vanish."""
    b = [[float(draw.randint(-64, 64)) for _ in range(d)] for _ in range(3)]
    return [[q + r - p for p, q, r in zip(*b)], *b]


def write_curve(path, points):
    """Writes a curve file with every bit of the coordinates."""
    head = ",".join("xyz"[: len(points[0])])
    path.write_text("\n".join([head, *(",".join(x.hex() for x in p) for p in points), ""]), encoding="ascii")
