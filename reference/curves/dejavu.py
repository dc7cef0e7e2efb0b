#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""reference/curves/dejavu.py [FOLDER]: writes dejavu.csv and glyph_outlines.csv, beside this file or into a folder, from DejaVu
(Debian: fonts-dejavu-core, fonts-dejavu-extra, python3-fonttools).

dejavu.csv has 1,000 curves of glyphs, glyph_outlines.csv whole contours. Coordinates are those of the glyphs, 2,048 to the em. TrueType outlines are quadratic; every second curve is written as the
cubic that a converter to PostScript outlines gives, times 3, so that its control points are integers.
"""
import csv
import pathlib
import random
import sys

from fontTools.pens.basePen import decomposeQuadraticSegment
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont

FOLDER = pathlib.Path("/usr/share/fonts/truetype/dejavu")
FAMILIES = ["Sans", "SansMono", "Serif"]
CURVES = 1000
OUTLINED = {"DejaVuSans": "aegQSR&8@?j%Gk3tydA", "DejaVuSerif": "aegQSR&8@?j%Gk3tydA", "DejaVuSerif-Italic": "aegQSR&8@?j%Gk3tydA"}
ABOUT_OUTLINES = """\
# Outlines of glyphs, contour by contour and closed, in font units (2048 an em): on = 1 for a point of the outline, 0 for
# the middle control point of a quadratic Bezier curve between the points beside it; points in line are joined. A point
# that the font leaves out, the middle of two control points, is rounded towards 0.
# From DejaVuSans, DejaVuSerif and DejaVuSerif-Italic of Debian's fonts-dejavu-core and fonts-dejavu-extra 2.37-6.
# Copyright (c) 2003 by Bitstream, Inc. All Rights Reserved. Bitstream Vera is a trademark of Bitstream, Inc. DejaVu
# changes are in public domain. Licence: that of Bitstream Vera, in the packages' copyright file.
"""


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


def contours(font, character):
    """The contours of a glyph: lists of (on, x, y), each from its first point on the outline."""
    table = font["glyf"]
    points, ends, flags = table[font.getBestCmap()[ord(character)]].getCoordinates(table)
    given = [(flag & 1, *point) for flag, point in zip(flags, points)]
    for first, last in zip([0, *(end + 1 for end in ends)], ends):
        contour = given[first:last + 1]
        begin = next(k for k, point in enumerate(contour) if point[0])
        contour = contour[begin:] + contour[:begin]
        whole = []
        for (on, x, y), (next_on, next_x, next_y) in zip(contour, contour[1:] + contour[:1]):
            whole.append((on, x, y))
            if not on and not next_on:
                whole.append((1, int((x + next_x) / 2), int((y + next_y) / 2)))
        yield whole


def write_outlines(folder):
    with open(folder / "glyph_outlines.csv", "w", newline="", encoding="utf-8") as file:
        file.write(ABOUT_OUTLINES)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["contour", "on", "x", "y"])
        for name, characters in OUTLINED.items():
            font = TTFont(FOLDER / f"{name}.ttf")
            for character in characters:
                for number, contour in enumerate(contours(font, character)):
                    table.writerows((f"{name} {character} {number}", *point) for point in contour)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    write_outlines(folder)
    found = []
    for family in FAMILIES:
        font = TTFont(FOLDER / f"DejaVu{family}.ttf")
        found += [(f"{family}:{name}:{number}", points) for name, number, points in quadratics(font)]
    chosen = sorted(random.Random(1).sample(range(len(found)), CURVES))
    with open(folder / "dejavu.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["curve", "index", "x", "y"])
        for k, number in enumerate(chosen):
            name, points = found[number]
            for index, point in enumerate(elevated(points) if k % 2 else points):
                table.writerow([name, index, *(int(x) if x == int(x) else repr(x) for x in point)])


if __name__ == "__main__":
    main()
