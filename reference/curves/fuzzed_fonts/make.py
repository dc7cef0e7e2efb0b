# SPDX-License-Identifier: MIT
"""Makes the fonts beside this file with fontTools (python3-fonttools, python3-brotli): small ones that have every kind of
glyph. They are inputs of font_test.cpp, font_test.py and the fuzzer.

make.py [FOLDER]
"""
import sys
from pathlib import Path

from fontTools.cffLib import FDArrayIndex, FDSelect, FontDict, IndexedStrings, PrivateDict, SubrsIndex
from fontTools.fontBuilder import FontBuilder
from fontTools.misc.psCharStrings import T2CharString
from fontTools.ttLib import TTCollection, TTFont
from fontTools.ttLib.tables import _g_l_y_f as glyf


def builder(glyphs, is_ttf):
    made = FontBuilder(unitsPerEm=1000, isTTF=is_ttf)
    made.setupGlyphOrder(glyphs)
    made.setupCharacterMap({})
    return made


def finish(made, bearings):
    made.setupHorizontalMetrics({name: (600, bearings.get(name, 0)) for name in made.font.getGlyphOrder()})
    made.setupHorizontalHeader()
    made.setupPost()
    made.font["head"].created = made.font["head"].modified = 3_000_000_000
    made.font.recalcTimestamp = False
    return made.font


def simple(*contours):
    """A glyph of contours of (x, y, whether the point is on the curve)."""
    glyph = glyf.Glyph()
    points = [point for contour in contours for point in contour]
    glyph.numberOfContours = len(contours)
    glyph.coordinates = glyf.GlyphCoordinates([point[:2] for point in points])
    glyph.flags = bytearray(point[2] for point in points)
    ends = [len(contour) for contour in contours]
    glyph.endPtsOfContours = [sum(ends[: k + 1]) - 1 for k in range(len(ends))]
    glyph.program = glyf.ttProgram.Program()
    glyph.program.fromBytecode(b"\x4f")  # instructions, to be skipped
    return glyph


def composite(*components):
    """A glyph of components: name, flags, then an offset (x, y) or two numbers of points, then a matrix if there is one."""
    glyph = glyf.Glyph()
    glyph.numberOfContours = -1
    glyph.components = []
    for name, flags, arguments, *matrix in components:
        component = glyf.GlyphComponent()
        component.glyphName, component.flags = name, flags
        if flags & glyf.ARGS_ARE_XY_VALUES:
            component.x, component.y = arguments
        else:
            component.firstPt, component.secondPt = arguments
        if matrix:
            component.transform = matrix[0]
        glyph.components.append(component)
    return glyph


def truetype():
    offsets = glyf.ARGS_ARE_XY_VALUES
    matrix = [[0.5, 0.25], [-0.75, 1.0]]
    glyphs = {
        ".notdef": glyf.Glyph(),
        "implied": simple([(0, 0, 1), (101, 0, 0), (101, 50, 0), (0, 50, 1), (0, 50, 1), (-300, 20, 1)]),
        "starts_off": simple([(0, 10, 0), (10, 10, 1), (10, 0, 0), (0, 0, 0)], [(5, 5, 1)]),
        "all_off": simple([(0, 0, 0), (7, 0, 0), (7, 7, 0)], [(3, 4, 0)]),
        "bearing": simple([(20, 0, 1), (40, 0, 1), (40, 30, 1)]),
        "moved": composite(("bearing", offsets, (300, -7)), ("implied", offsets, (-3, 2))),
        "scaled": composite(("implied", offsets, (10, 20), [[0.5, 0], [0, 0.5]])),
        "scaled_twice": composite(("scaled", offsets, (1, 1), [[-1.5, 0], [0, 0.25]])),
        "turned": composite(("implied", offsets, (11, 21), matrix)),
        "turned_offset": composite(("implied", offsets | glyf.SCALED_COMPONENT_OFFSET, (11, 21), matrix)),
        "unscaled_offset": composite(("implied", offsets | glyf.UNSCALED_COMPONENT_OFFSET, (11, 21), matrix)),
        "attached": composite(("bearing", offsets, (0, 0)), ("all_off", 0, (2, 1)), ("implied", 0, (4, 3), matrix)),
    }
    made = builder(list(glyphs), True)
    made.setupGlyf(glyphs)
    return finish(made, {"implied": -300, "bearing": 33, "moved": 12, "turned": 5})


def every_operator():
    """Programs of Type 2 charstrings by glyph."""
    return {
        ".notdef": [600, "endchar"],
        "lines": [-20, 5, 10, "hstem", 1, 2, "rmoveto", 3, 4, 0, 0, 5, -6, "rlineto", 7, 8, "hlineto", 9, 1, 2, "vlineto", "endchar"],
        "curves": [1, "hmoveto", *range(1, 13), "rrcurveto", *range(1, 9), "rcurveline", *range(1, 11), "rlinecurve", "endchar"],
        "tangents": [20, 3, "vmoveto", *range(1, 10), "hhcurveto", *range(1, 5), "hhcurveto", *range(2, 11), "vvcurveto",
                     *range(3, 7), "vvcurveto", 4, "vmoveto", *range(1, 14), "hvcurveto", *range(1, 9), "hvcurveto",
                     *range(1, 6), "vhcurveto", *range(2, 10), "vhcurveto", "endchar"],
        "flexes": [600, 1, 2, "rmoveto", *range(1, 8), "hflex", *range(1, 14), "flex", *range(1, 10), "hflex1",
                   *range(1, 12), "flex1", 9, 1, 9, 1, 9, 1, 9, 1, 9, 1, 7, "flex1", "endchar"],
        "masked": [1, 2, 3, 4, "hstemhm", 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, "hintmask", b"\xaa\x80", 3, "hmoveto",
                   4, "vlineto", "cntrmask", b"\x55\x00", 5, "hlineto", "hintmask", b"\x15\x80", -100, "hlineto", "endchar"],
        "fractions": [0.5, -0.25, "rmoveto", 1.125, 1000, -1000, 107.5, "rlineto", 1, 3, "div", 10, 4, "div", "rlineto", "endchar"],
        "subroutines": [-107, "callgsubr", -107, "callsubr", "endchar"],
        "no_move": [10, 20, "rlineto", 30, "hlineto", "endchar"],
        "A": [1, 1, "rmoveto", 10, "hlineto", 5, "vlineto", "endchar"],
        "acute": [600, 2, "hmoveto", 3, 4, "rlineto", -2, "vlineto", "endchar"],
        "Aacute": [7, 100, 65, 194, "endchar"],
    }


def subroutine(program):
    return T2CharString(program=program)


def opentype():
    programs = every_operator()
    made = builder(list(programs), False)
    made.setupCFF("Made", {}, {name: T2CharString(program=program) for name, program in programs.items()}, {})
    cff = made.font["CFF "].cff
    cff.GlobalSubrs.append(subroutine([1, 2, "rmoveto", 30, "hlineto", "return"]))
    private = cff.topDictIndex[0].Private
    private.Subrs = SubrsIndex()
    private.Subrs.append(subroutine([-106, "callsubr", 4, 5, "rlineto", "return"]))
    private.Subrs.append(subroutine([6, "vlineto", "return"]))
    return finish(made, {})


def cid_keyed():
    """Glyphs in two fonts of one font, each with subroutines of its own."""
    program = [1, 2, "rmoveto", -107, "callsubr", "endchar"]
    made = builder([".notdef", "cid00001", "cid00002", "cid00003"], False)
    made.setupCFF("Made", {}, {name: T2CharString(program=list(program)) for name in made.font.getGlyphOrder()}, {})
    top = made.font["CFF "].cff.topDictIndex[0]
    strings, shared = IndexedStrings(), made.font["CFF "].cff.GlobalSubrs
    fonts = FDArrayIndex()
    for number, lines in enumerate(([4, 5, 6, 7], [50, 60])):
        font = FontDict(strings=strings, GlobalSubrs=shared)
        font.FontName, font.Private = f"Part{number}", PrivateDict(strings=strings)
        font.Private.defaultWidthX = font.Private.nominalWidthX = 0
        font.Private.Subrs = SubrsIndex()
        font.Private.Subrs.append(subroutine([*lines, "rlineto", "return"]))
        fonts.append(font)
    select = FDSelect()
    select.gidArray, select.format = [0, 1, 1, 0], 3
    charstrings = top.CharStrings
    for number, charstring in enumerate(charstrings.charStrings.values()):
        charstring.private, charstring.fdSelectIndex = fonts[select[number]].Private, select[number]
    charstrings.fdArray, charstrings.fdSelect = fonts, select
    top.ROS, top.CIDCount, top.FDArray, top.FDSelect = ("Adobe", "Identity", 0), 4, fonts, select
    del top.Private
    return finish(made, {})


def variable():
    """Charstrings of CFF2; default values are followed by their changes in two regions."""
    programs = {
        ".notdef": [],
        "blended": [10, 20, 1, 2, 3, 4, 2, "blend", "rmoveto", 30, 5, 6, 1, "blend", "hlineto", 7, "vlineto"],
        "plain": [1, "hmoveto", 2, 3, "rlineto", *range(1, 7), "rrcurveto"],
    }
    made = builder(list(programs), False)
    made.setupNameTable({})
    made.setupFvar([("wght", 100, 400, 900, "Weight")], [])
    regions = [{"wght": (0, 1, 1)}, {"wght": (-1, -1, 0)}]
    made.setupCFF2({name: T2CharString(program=program) for name, program in programs.items()}, None, regions)
    return finish(made, {})


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent
    truetype().save(folder / "glyf.ttf")
    opentype().save(folder / "cff.otf")
    cid_keyed().save(folder / "cid_keyed.otf")
    variable().save(folder / "cff2.otf")
    for flavor in ("woff", "woff2"):
        font = TTFont(folder / "glyf.ttf")
        font.flavor = flavor
        font.save(folder / f"glyf.{flavor}")
    faces = TTCollection()
    faces.fonts = [TTFont(folder / name) for name in ("glyf.ttf", "glyf.ttf", "cff.otf")]
    faces.save(folder / "faces.ttc")


if __name__ == "__main__":
    main()
