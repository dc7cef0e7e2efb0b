#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""reference/curves/dejavu.py: writes dejavu.csv, 1,000 curves of glyphs of DejaVu (Debian: fonts-dejavu-core, python3-fonttools).

Coordinates are those of the glyphs, 2,048 to the em. TrueType outlines are quadratic; every second curve is written as the
cubic that a converter to PostScript outlines makes of it, times 3, so that its control points are integers.
"""
import csv
import pathlib
import random

from fontTools.pens.basePen import decomposeQuadraticSegment
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

FOLDER = pathlib.Path("/usr/share/fonts/truetype/dejavu")
FAMILIES = ["Sans", "SansMono", "Serif"]
CURVES = 1000


def quadratics(font):
    """The quadratic curves of all glyphs: (name of the glyph, number in the glyph, three control points)."""
    glyphs = font.getGlyphSet()
    for name in font.getGlyphOrder():
        pen = DecomposingRecordingPen(glyphs)
        glyphs[name].draw(pen)
        count = 0
        last = None
        for operator, points in pen.value:
            if operator == "qCurveTo" and points[-1] is not None:
                for control, end in decomposeQuadraticSegment(points):
                    yield name, count, (last, control, end)
                    last = end
                    count += 1
            elif points:
                last = points[-1]


def elevated(points):
    """The cubic with the same points, times 3."""
    p0, p1, p2 = points
    return [[3 * x for x in p0], [a + 2 * b for a, b in zip(p0, p1)], [2 * b + c for b, c in zip(p1, p2)], [3 * x for x in p2]]


def main():
    found = []
    for family in FAMILIES:
        font = TTFont(FOLDER / f"DejaVu{family}.ttf")
        found += [(f"{family}:{name}:{number}", points) for name, number, points in quadratics(font)]
    chosen = sorted(random.Random(1).sample(range(len(found)), CURVES))
    with open(pathlib.Path(__file__).with_name("dejavu.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["curve", "index", "x", "y"])
        for k, number in enumerate(chosen):
            name, points = found[number]
            for index, point in enumerate(elevated(points) if k % 2 else points):
                table.writerow([name, index, *(int(x) if x == int(x) else repr(x) for x in point)])


if __name__ == "__main__":
    main()
