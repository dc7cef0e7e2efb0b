#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pictures of the source documents, drawn again: docs/pictures/*.svg, which docs/source_documents.md shows.

pictures.py            draws them
pictures.py --check    exits 1 where one differs from its file
"""
import math
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "docs/pictures"
GREY, BLUE, RED, GREEN = "#888", "#36c", "#c33", "#292"


class Picture:
    """Shapes in a frame of `width` times `height` pixels; coordinates go right and down."""

    def __init__(self, width, height):
        self.size, self.shapes = (width, height), []

    def line(self, points, colour="#000", width=1, more=""):
        places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.shapes.append(f'<polyline points="{places}" fill="none" stroke="{colour}" stroke-width="{width}"{more}/>')

    def dot(self, point, colour, radius=4, filled=True):
        self.shapes.append(f'<circle cx="{point[0]:.1f}" cy="{point[1]:.1f}" r="{radius}" fill="{colour if filled else "none"}" stroke="{colour}"/>')

    def text(self, point, words, colour="#000", anchor="middle"):
        self.shapes.append(f'<text x="{point[0]:.1f}" y="{point[1]:.1f}" fill="{colour}" text-anchor="{anchor}">{words}</text>')

    def svg(self):
        width, height = self.size
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                f'font-family="sans-serif" font-size="13">\n<rect width="{width}" height="{height}" fill="#fff"/>\n'
                + "\n".join(self.shapes) + "\n</svg>\n")


def mix(a, b, t):
    return tuple((1 - t) * x + t * y for x, y in zip(a, b))


def levels(points, t):
    """De Casteljau's triangle, level by level."""
    rows = [list(points)]
    while len(rows[-1]) > 1:
        rows.append([mix(a, b, t) for a, b in zip(rows[-1], rows[-1][1:])])
    return rows


def at(points, t):
    return levels(points, t)[-1][0]


def curve(picture, points):
    picture.line([at(points, k / 100) for k in range(101)], width=2)


def tableau():
    """Three triangles of degree 3: points, differences, and places in one array."""
    picture, n = Picture(900, 250), 3
    names = (("point, weights 1-t and t", lambda k, i: f"P<tspan dy='4' font-size='9'>{i}</tspan><tspan dy='-9' font-size='9'>{k}</tspan>"),
             ("differences, minus and plus", lambda k, i: f"{'Δ' * k}P<tspan dy='4' font-size='9'>{i}</tspan>"),
             ("places in one array; the halves are 0 4 7 9 and 9 8 6 3", lambda k, i: str(k * (n + 1) - k * (k - 1) // 2 + i)))
    for column, (title, name) in enumerate(names):
        def place(k, i):
            return 300 * column + 45 + 60 * i + 30 * k, 50 + 55 * k
        picture.text((300 * column + 135, 20), title, GREY)
        for k in range(n + 1):
            for i in range(n + 1 - k):
                if k:
                    for before, colour in ((i, RED), (i + 1, BLUE)):
                        a, b = place(k - 1, before), place(k, i)
                        picture.line([mix(a, b, 0.3), mix(a, b, 0.68)], colour)
                x, y = place(k, i)
                picture.text((x, y + 4), name(k, i))
    return picture


def construction():
    """Curves of degree 1, 2 and 3 with the points that lead to t = 2/5."""
    picture = Picture(900, 240)
    for column, points in enumerate(([(30, 200), (250, 60)], [(30, 200), (120, 30), (260, 170)], [(30, 200), (60, 40), (210, 30), (270, 190)])):
        points = [(300 * column + x, y) for x, y in points]
        for row, colour in zip(levels(points, 0.4), (GREY, BLUE, GREEN, RED)):
            if len(row) > 1:
                picture.line(row, colour)
            for p in row:
                picture.dot(p, colour)
        curve(picture, points)
        for i, (x, y) in enumerate(points):
            picture.text((x, y - 9), f"P<tspan dy='4' font-size='9'>{i}</tspan>")
    return picture


def circle():
    """(R cos t^2, R sin t^2): 20 equal steps of t, and of the length R t^2."""
    picture, r, centre, steps = Picture(520, 420), 160, (210, 210), 20
    end = math.sqrt(2 * math.pi)
    def point(t):
        return centre[0] + r * math.cos(t * t), centre[1] + r * math.sin(t * t)
    for k in range(steps + 1):
        picture.dot(point(math.sqrt(2 * math.pi * k / steps)), RED, 4)
        picture.dot(point(end * k / steps), BLUE, 8, filled=False)
    picture.text((385, 200), "rings: equal steps of t", BLUE, "start")
    picture.text((385, 220), "dots: equal lengths", RED, "start")
    return picture


def lengths_of(points, parts=4096):
    sums, before = [0.0], points[0]
    for k in range(1, parts + 1):
        here = at(points, k / parts)
        sums.append(sums[-1] + math.dist(before, here))
        before = here
    return sums


def inverse(sums, length):
    """The t at a length, linear between the points at which the sums are known."""
    k = max(j for j, value in enumerate(sums[:-1]) if value <= length)
    return (k + min((length - sums[k]) / (sums[k + 1] - sums[k]), 1)) / (len(sums) - 1)


def equal_chords(points, count):
    """The parameters whose points have chords of one length."""
    ts = [k / count for k in range(count + 1)]
    for _ in range(200):
        places = [at(points, t) for t in ts]
        sums = [0.0]
        for a, b in zip(places, places[1:]):
            sums.append(sums[-1] + math.dist(a, b))
        moved = []
        for k in range(count + 1):
            target = sums[-1] * k / count
            j = max(i for i in range(count) if sums[i] <= target)
            moved.append(ts[j] + (ts[j + 1] - ts[j]) * min((target - sums[j]) / (sums[j + 1] - sums[j]), 1))
        ts = moved
    return ts


def spacing():
    """Five points of a cubic: at equal steps of t, by equal chords, at equal lengths."""
    picture, count = Picture(640, 300), 4
    points = [(40, 260), (90, -60), (120, 330), (600, 40)]
    curve(picture, points)
    sums = lengths_of(points)
    ways = (("equal steps of t", [k / count for k in range(count + 1)], GREY, 9), ("equal chords", equal_chords(points, count), GREEN, 6),
            ("equal lengths", [inverse(sums, sums[-1] * k / count) for k in range(count + 1)], RED, 3))
    for row, (words, ts, colour, radius) in enumerate(ways):
        for t in ts:
            picture.dot(at(points, t), colour, radius, filled=radius < 9)
        picture.text((430, 220 + 20 * row), words, colour, "start")
    return picture


def distance():
    """A cubic with a point, the squared distance d over t, and the derivatives of d, each over its largest size."""
    picture = Picture(900, 300)
    points, point = [(40, 250), (120, -60), (230, 340), (330, 40)], (190, 110)
    curve(picture, points)
    picture.dot(point, GREEN)
    size, steps = 130, 200
    d = [math.dist(at(points, k / steps), point) ** 2 for k in range(steps + 1)]
    rows = [d, [b - a for a, b in zip(d, d[1:])]]
    rows.append([b - a for a, b in zip(rows[1], rows[1][1:])])
    nearest = d.index(min(d))
    picture.line([at(points, nearest / steps), point], GREEN)
    picture.line([(400, 150), (860, 150)], GREY)
    for row, (values, colour, words) in enumerate(zip(rows, (GREEN, BLUE, RED), ("d", "d'", "d''"))):
        largest = max(map(abs, values))
        picture.line([(400 + 460 * k / (len(values) - 1), 150 - size * v / largest) for k, v in enumerate(values)], colour)
        picture.text((420 + 40 * row, 295), words, colour)
    picture.line([(400 + 460 * nearest / steps, 20), (400 + 460 * nearest / steps, 280)], GREY, more=' stroke-dasharray="4"')
    return picture


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    holds = True
    for draw in (tableau, construction, circle, spacing, distance):
        path, text = FOLDER / f"{draw.__name__}.svg", draw().svg()
        if not arguments:
            FOLDER.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            print(f"docs/pictures/{path.name} is not what scripts/pictures.py draws; run it")
            holds = False
    return 0 if holds else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
