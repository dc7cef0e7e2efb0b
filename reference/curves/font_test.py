# SPDX-License-Identifier: MIT
"""The segments of fonts as the font reader has them are those of fontTools, bit for bit, with their names and order.

font_test.py PROGRAM [FONT...]    compares the given fonts; without one those of fuzzed_fonts and two that are installed

Exit 77 where fontTools is missing. fontTools composes the points of a glyph (`getCoordinates`) and cuts
contours into segments (`BasePen`). A composite glyph is not taken from its glyph set, which up to version 4.38 shifts each
component by that component's own left side bearing, and newer ones do not shift the glyph; rasterizers shift it once.
The message counts the composite glyphs that are different in the glyph set.
"""
import csv
import importlib.util
import itertools
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MADE = Path(__file__).resolve().parent / "fuzzed_fonts"
FONTS = Path("/usr/share/fonts")


def segments_of(font, prefix):
    """A line `id bits` for each segment of one face; counts of glyphs, lines of zero length and unlike composites."""
    from fontTools.pens.basePen import BasePen
    from fontTools.ttLib.tables._g_l_y_f import Glyph

    class Segments(BasePen):
        """Contours with all of their segments, those of zero length and the closing lines as well."""

        def __init__(self, glyph_set):
            super().__init__(glyph_set)
            self.contours = []

        def _moveTo(self, point):
            self.contours.append([])
            self.start = self.last = point

        def _add(self, *points):
            self.contours[-1].append((self.last, *points))
            self.last = points[-1]

        _lineTo = _qCurveToOne = _curveToOne = _add

        def _closePath(self):
            if self.last != self.start:
                self._add(self.start)

    glyph_set = font.getGlyphSet()
    glyf = font["glyf"] if "glyf" in font and "CFF " not in font and "CFF2" not in font else None
    # Glyphs without names have numbers; those of namesakes end with #1 in fontTools.
    is_named = not hasattr(font["CFF "].cff.topDictIndex[0], "ROS") if "CFF " in font else font["post"].formatType != 3
    lines, zero, unlike = [], 0, 0
    for number, name in enumerate(font.getGlyphOrder()):
        shown = name if is_named and not re.search(r"[^!-~]|[#,:\"]", name) else number
        pen = Segments(glyph_set)
        glyph = glyf[name] if glyf is not None else None
        if glyph is not None and glyph.isComposite():
            flat = Glyph()
            flat.coordinates, flat.endPtsOfContours, flat.flags = glyph.getCoordinates(glyf)
            flat.numberOfContours = len(flat.endPtsOfContours)
            if flat.numberOfContours:
                flat.draw(pen, glyf, font["hmtx"][name][1] - glyph.xMin)
            if not any(hasattr(component, "firstPt") for component in glyph.components):
                as_set = Segments(glyph_set)
                glyph_set[name].draw(as_set)
                unlike += as_set.contours != pen.contours
        else:
            glyph_set[name].draw(pen)
        for contour, segments in enumerate(pen.contours):
            count = 0
            for points in segments:
                if len(points) == 2 and points[0] == points[1]:
                    zero += 1
                    continue
                bits = struct.pack(f">{2 * len(points)}d", *(x + 0.0 for point in points for x in point)).hex()
                lines.append(f"{prefix}{shown}:{contour}:{count} {bits}")
                count += 1
    return lines, len(font.getGlyphOrder()), zero, unlike


def faces_of(path):
    from fontTools.ttLib import TTCollection, TTFont

    with open(path, "rb") as file:
        is_collection = file.read(4) == b"ttcf"
    return TTCollection(path, lazy=True).fonts if is_collection else [TTFont(path, lazy=True)]


def compare(program, path, table):
    """One line of counts, and whether everything is equal. `table` is the file to which `bezierbench curves` writes."""
    ran = subprocess.run([program, "curves", path, "--out", table], capture_output=True, text=True)
    if ran.returncode != 0:
        return ran.stderr.strip(), False
    left_out = {reason: count for line in (ran.stdout + ran.stderr).splitlines() if line.startswith("left out: ")
                for reason, count in re.findall(r"(?:: |, )([^(]+) \((\d+)\)", line)}
    with open(table, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))[1:]
    ours = [f"{name} {''.join(struct.pack('>2d', float.fromhex(x), float.fromhex(y)).hex() for _, _, x, y in points)}"
            for name, points in itertools.groupby(rows, lambda row: row[0])]
    faces = faces_of(path)
    read = {line.split(":", 1)[0] for line in ours}
    theirs, glyphs, zero, unlike = [], 0, 0, 0
    for number, face in enumerate(faces):
        if len(faces) > 1 and str(number) not in read:
            continue
        made = segments_of(face, f"{number}:" if len(faces) > 1 else "")
        theirs += made[0]
        glyphs, zero, unlike = glyphs + made[1], zero + made[2], unlike + made[3]
    different = sum(a != b for a, b in zip(ours, theirs)) + abs(len(ours) - len(theirs))
    first = next((f"; first: {a} here, {b} in fontTools" for a, b in zip(ours, theirs) if a != b), "")
    paths = re.search(r"in (\d+) paths?$", ran.stdout, re.M)[1]
    begun = sum(line.split(" ")[0].endswith(":0") for line in theirs)
    same_count = (int(left_out.get("lines of zero length", 0)), int(paths)) == (zero, begun)
    if not same_count:
        first += f"; {left_out}, {paths} paths here, {zero} lines of zero length, {begun} paths in fontTools"
    return (f"{path}: {glyphs} glyphs, {len(theirs)} segments, {different} different; left out: {left_out}; composites "
            f"unlike the glyph set: {unlike}{first}"), different == 0 and same_count


def main():
    if importlib.util.find_spec("fontTools") is None:
        print("skipped: python3-fonttools is not installed")
        return 77
    from fontTools.ttLib import TTFont

    program, paths = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        if not paths:
            paths = sorted(str(path) for path in MADE.glob("*.*") if path.suffix != ".py")
            installed = [next(iter(sorted(FONTS.rglob(name))), None) for name in ("DejaVuSans.ttf", "*.otf")]
            paths += [str(path) for path in installed if path is not None]
            if None in installed:
                print(f"left out: {FONTS} has no DejaVuSans.ttf or no .otf; install fonts-dejavu-core, fonts-linuxlibertine")
            elif importlib.util.find_spec("brotli") is not None:
                font = TTFont(installed[0])
                font.flavor = "woff2"
                paths.append(f"{folder}/DejaVuSans.woff2")
                font.save(paths[-1])
        equal = True
        for path in paths:
            line, same = compare(program, path, f"{folder}/curves.csv")
            print(line, flush=True)
            equal &= same
    return 0 if equal else 1


if __name__ == "__main__":
    sys.exit(main())
