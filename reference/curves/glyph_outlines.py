#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""reference/curves/glyph_outlines.py: writes glyph_outlines.csv beside it, whole contours of glyphs of DejaVu (Debian:
fonts-dejavu-core, fonts-dejavu-extra, python3-fonttools). Coordinates are those of the glyphs, 2,048 to the em.
"""
import csv
import pathlib

FOLDER = pathlib.Path("/usr/share/fonts/truetype/dejavu")
OUTLINED = {"DejaVuSans": "aegQSR&8@?j%Gk3tydA", "DejaVuSerif": "aegQSR&8@?j%Gk3tydA", "DejaVuSerif-Italic": "aegQSR&8@?j%Gk3tydA"}
ABOUT_OUTLINES = """\
# Outlines of glyphs, contour by contour and closed, in font units (2048 an em): on = 1 for a point of the outline, 0 for
# the middle control point of a quadratic Bezier curve between the points beside it; points in line are joined. A point
# that the font leaves out, the middle of two control points, is rounded towards 0.
# From DejaVuSans, DejaVuSerif and DejaVuSerif-Italic of Debian's fonts-dejavu-core and fonts-dejavu-extra 2.37-6.
# Copyright (c) 2003 by Bitstream, Inc. All Rights Reserved. Bitstream Vera is a trademark of Bitstream, Inc. DejaVu
# changes are in public domain. Licence: that of Bitstream Vera, in the packages' copyright file.
"""


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


def write_outlines(file):
    from fontTools.ttLib import TTFont

    file.write(ABOUT_OUTLINES)
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["contour", "on", "x", "y"])
    for name, characters in OUTLINED.items():
        font = TTFont(FOLDER / f"{name}.ttf")
        for character in characters:
            for number, contour in enumerate(contours(font, character)):
                table.writerows((f"{name} {character} {number}", *point) for point in contour)


if __name__ == "__main__":
    with open(pathlib.Path(__file__).parent / "glyph_outlines.csv", "w", newline="", encoding="utf-8") as written:
        write_outlines(written)
