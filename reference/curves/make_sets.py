#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""reference/curves/make_sets.py PROGRAM [SET...] [--out FOLDER] [--packages FOLDER [--fetch]]: writes the shipped sets of curves.

PROGRAM is bezierbench. Without SET all are written, into sets/ beside this file or into --out: SET.csv and its licence
SET.csv.license. Then the tables in the README.md there are brought up to date. Sources are packages of Debian and npm, exactly the versions below: installed ones, and those unpacked
under --packages; --fetch downloads what is missing there.

A curve's rank is the SHA-256 of set, file and curve, and so is a file's: files are read in the order of their ranks, and each
gives its first curves in the order of theirs. Lines, points and curves that are translations of one chosen before are left out.
Coordinates are those that PROGRAM reads, in the shortest decimals that read back to the same double.

Exit codes: 0 fine, 2 usage, 3 a package or program is missing, 4 a file cannot be read or written.
"""
import argparse
import csv
import fnmatch
import hashlib
import io
import itertools
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
COMMON_LICENCES = pathlib.Path("/usr/share/common-licenses")  # of Debian's package base-files


@dataclass(frozen=True)
class Package:
    """Where files come from. Patterns are relative to / for Debian's packages, to the package's folder for npm's."""
    system: str
    name: str
    version: str
    patterns: tuple
    licence_file: str = ""  # of npm's packages
    common_licence: str = ""  # what Debian's copyright file refers to
    files_under: str = ""  # takes only files that Debian's copyright file puts under this licence


@dataclass(frozen=True)
class CurveSource:
    """A set: how many curves at most, in all and from one file, which reader, and from where."""
    licence: str  # SPDX
    curves: int
    per_file: int
    reader: str
    packages: tuple


def debian(name, version, *patterns, **more):
    return Package("debian", name, version, patterns, **more)


def npm(name, version, *patterns, licence_file="LICENSE"):
    return Package("npm", name, version, patterns, licence_file)


NOTO = "usr/share/fonts/truetype/noto/Noto"
OTF = "usr/share/fonts/opentype"
KICAD = ("Battery", "Button_Switch_SMD", "Capacitor_SMD", "Capacitor_THT", "Capacitor_Tantalum_SMD", "Connector_Dsub",
         "Connector_Phoenix_MC", "Connector_Phoenix_MSTB", "Connector_Stocko", "Crystal", "Fuse", "Inductor_THT", "Package_DIP",
         "Package_QFP", "Potentiometer_THT", "TerminalBlock_Altech", "TerminalBlock_Phoenix", "Transformer_THT", "Varistor")
SOURCES = {
    "truetype": CurveSource("OFL-1.1", 5000, 320, "program", (
        debian("fonts-noto-core", "20201225-1", f"{NOTO}Sans-*.ttf", f"{NOTO}Serif-*.ttf", f"{NOTO}NaskhArabic-Regular.ttf",
               f"{NOTO}SansDevanagari-Regular.ttf", f"{NOTO}SansEthiopic-Regular.ttf", f"{NOTO}SansThai-Regular.ttf",
               f"{NOTO}SerifArmenian-Regular.ttf", f"{NOTO}SerifGeorgian-Regular.ttf", f"{NOTO}SerifHebrew-Regular.ttf",
               f"{NOTO}SerifTamil-Regular.ttf"),)),
    "roboto": CurveSource("Apache-2.0", 1800, 150, "program", (
        debian("fonts-roboto-unhinted", "2:0~20170802-3", "usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/*.ttf",
               common_licence="Apache-2.0"),)),
    "cff": CurveSource("OFL-1.1", 5000, 220, "program", (
        debian("fonts-cantarell", "0.303.1-1", f"{OTF}/cantarell/*.otf"),
        debian("fonts-ebgaramond", "0.016+git20210310.42d4f9f2-1", f"{OTF}/ebgaramond/*.otf"),
        debian("fonts-linuxlibertine", "5.3.0-6", f"{OTF}/linux-libertine/*_R*.otf"),
        debian("fonts-stix", "1.1.1-4.1", f"{OTF}/stix/STIXGeneral-*.otf"))),
    "clip_art": CurveSource("CC-PDDC", 4000, 20, "program", (
        debian("openclipart-svg", "1:0.18+dfsg-19", "usr/share/openclipart/svg/**/*.svg"),)),
    "tango": CurveSource("CC-PDDC", 1800, 16, "program", (
        debian("tango-icon-theme", "0.8.90-11", "usr/share/icons/Tango/scalable/*/*.svg"),)),
    "bootstrap": CurveSource("MIT", 2500, 8, "program", (npm("bootstrap-icons", "1.13.2", "icons/*.svg"),)),
    "lucide": CurveSource("ISC AND MIT", 1200, 6, "program", (npm("lucide-static", "1.62.0", "icons/*.svg"),)),
    "easing": CurveSource("MIT", 1000, 100, "easing", (
        npm("@angular/material", "22.2.0", "fesm2022/*.mjs"), npm("@fluentui/tokens", "1.0.0-alpha.24", "lib/**/*.js"),
        npm("@ionic/core", "9.0.5", "dist/collection/**/*.js", "css/*.css"), npm("framework7", "9.2.0", "framework7-bundle.css"),
        npm("open-props", "1.7.23", "src/*.css"), npm("postcss-easings", "4.0.0", "*.js"),
        npm("sass-easing", "1.0.3", "**/*.scss"))),
    "coasts": CurveSource("ISC", 1800, 1800, "coasts", (npm("world-atlas", "2.0.2", "land-10m.json"),)),
    "borders": CurveSource("ISC", 1800, 1800, "borders", (npm("world-atlas", "2.0.2", "countries-10m.json"),)),
    "teapot": CurveSource("MIT", 1000, 1000, "teapot", (npm("three", "0.187.0", "examples/jsm/geometries/TeapotGeometry.js"),)),
    "cad": CurveSource("CC-BY-SA-4.0 WITH KiCad-libraries-exception", 1500, 24, "step", (
        debian("kicad-packages3d", "6.0.10-1", *(f"usr/share/kicad/3dmodels/{folder}.3dshapes/*.step" for folder in KICAD),
               files_under="CC-BY-SA-4.0-with-exception"),)),
}
TOLERANCE_DEGREES, TOLERANCE_METRES = "0.01", "1000"  # of the cubics that are fitted to coasts and borders
EARTH_RADIUS = 6378137  # metres: of the sphere of Web Mercator (EPSG:3857)


class Failure(Exception):
    """A message of one line and the exit code."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


def rank(*names):
    return hashlib.sha256("\n".join(names).encode()).digest()


def decimal(x):
    """The shortest decimal that reads back to the same double."""
    return repr(x).removesuffix(".0")


@dataclass
class Curve:
    """A curve of a file. Points are (x, y[, z]), of rational curves (x, y[, z], w) and not premultiplied."""
    id: str
    points: list
    rational: bool = False

    def extent(self):
        axes = zip(*(point[:-1] if self.rational else point for point in self.points))
        return max(max(axis) - min(axis) for axis in axes)

    def shape(self):
        """Equal for translations: the steps between control points over the size, and the size, to six digits."""
        size = self.extent()
        axes = list(zip(*self.points))
        weights = axes.pop() if self.rational else ()
        steps = [round((x - axis[0]) / size, 6) + 0.0 for axis in axes for x in axis]
        return (len(axes), f"{size:.6g}", *steps, *(round(w / max(weights, key=abs), 6) for w in weights))


def curves_of_set(text, fewest=0):
    """The curves of a set as CSV, with hexadecimal or decimal numbers, that have at least so many points."""
    def number(field):
        return float.fromhex(field) if "0x" in field else float(field)
    rows = csv.reader(io.StringIO(text))
    names = next(rows)
    axes = [names.index(axis) for axis in "xyz" if axis in names]
    weight = names.index("w") if "w" in names else None
    for id_, group in itertools.groupby(rows, lambda row: row[0]):
        group = list(group)
        if len(group) < fewest:
            continue
        rational = weight is not None and group[0][weight] != ""
        taken = [axis for axis in axes if group[0][axis] != ""] + [weight] * rational
        yield Curve(id_, [tuple(number(row[k]) for k in taken) for row in group], rational)


class Readers:
    """Readers of files by their names in SOURCES. The program reads fonts and SVG and fits cubics to points."""

    def __init__(self, program, folder):
        self.command = [str(program)]
        self.made = pathlib.Path(folder) / "set.csv"
        self.refused = 0

    def run(self, *arguments):
        try:
            return subprocess.run([*self.command, *arguments], capture_output=True, text=True, check=False)
        except OSError as error:
            raise Failure(3, f"{self.command[0]}: {error.strerror}; build it: scripts/build release bezierbench") from error

    def program(self, file):
        result = self.run("curves", str(file), "--out", str(self.made))
        if result.returncode == 4:  # a file that breaks the rules of its kind
            self.refused += 1
            return
        if result.returncode != 0:
            raise Failure(result.returncode, result.stderr.strip() or f"{self.command[0]} curves {file}: no answer")
        yield from curves_of_set(self.made.read_text(encoding="utf-8"), fewest=3)

    def fitted(self, name, points, tolerance):
        """The cubics fitted to points."""
        self.made.write_text("x,y\n" + "".join(f"{decimal(x)},{decimal(y)}\n" for x, y in points), encoding="utf-8")
        result = self.run("curve", "fit", "--points", str(self.made), "--tolerance", tolerance)
        if result.returncode != 0:
            raise Failure(result.returncode, f"{name}: {result.stderr.strip()}")
        for curve in curves_of_set(result.stdout):
            yield Curve(f"{name}:{curve.id}", curve.points)

    def topology(self, file, areas, sides, place, tolerance):
        """Cubics fitted to arcs of a TopoJSON file that as many of its `areas` have as a side. Fits take their time, so that
        they end, in the order of the arcs' ranks, with more curves than a set takes."""
        topology = json.loads(file.read_text(encoding="utf-8"))
        scale, shift = topology["transform"]["scale"], topology["transform"]["translate"]
        uses = Counter(k if k >= 0 else ~k for area in topology["objects"][areas]["geometries"] for k in numbers_in(area["arcs"]))
        found = 0
        for number in sorted(range(len(topology["arcs"])), key=lambda k: rank(areas, str(k))):
            steps = topology["arcs"][number]
            if uses[number] != sides or not 12 <= len(steps) <= 600:
                continue
            places = itertools.accumulate(steps, lambda a, b: [a[0] + b[0], a[1] + b[1]])
            points = [place(x * scale[0] + shift[0], y * scale[1] + shift[1]) for x, y in places]
            for curve in self.fitted(str(number), points, tolerance):
                found += 1
                yield curve
            if found >= 2500:
                return

    def coasts(self, file):
        yield from self.topology(file, "land", 1, lambda longitude, latitude: (longitude, latitude), TOLERANCE_DEGREES)

    def borders(self, file):
        """Arcs that two countries share, in metres of Web Mercator, rounded to centimetres."""
        def place(longitude, latitude):
            return (round(EARTH_RADIUS * math.radians(longitude), 2),
                    round(EARTH_RADIUS * math.log(math.tan(math.pi / 4 + math.radians(latitude) / 2)), 2))
        yield from self.topology(file, "countries", 2, place, TOLERANCE_METRES)

    def easing(self, file):
        text = file.read_text(encoding="utf-8", errors="replace")
        for match in re.finditer(r"cubic-bezier\(" + r"\s*,\s*".join([r"\s*(-?\d*\.?\d+)"] * 4) + r"\s*\)", text):
            x1, y1, x2, y2 = map(float, match.groups())
            yield Curve("_".join(match.groups()), [(0.0, 0.0), (x1, y1), (x2, y2), (1.0, 1.0)])

    def teapot(self, file):
        """The rows and columns of the 4 by 4 control points of each bicubic patch."""
        text = file.read_text(encoding="utf-8")
        patches, vertices = (re.search(rf"const {name} = \[(.*?)\]", text, re.S)[1] for name in
                             ("teapotPatches", "teapotVertices"))
        patches, vertices = ([float(x) for x in re.findall(r"-?\d*\.?\d+", re.sub(r"/\*.*?\*/", "", part, flags=re.S))]
                             for part in (patches, vertices))
        for patch in range(len(patches) // 16):
            numbers = [int(k) for k in patches[16 * patch:16 * patch + 16]]
            lines = [numbers[4 * k:4 * k + 4] for k in range(4)] + [numbers[k::4] for k in range(4)]
            for k, line in enumerate(lines):
                yield Curve(f"{patch}:{k}", [tuple(vertices[3 * v:3 * v + 3]) for v in line])

    def step(self, file):
        """The Bezier spans of the B-spline curves in space of a STEP file (ISO 10303-42, b_spline_curve_with_knots)."""
        text = file.read_text(encoding="latin-1")
        if not re.search(r"B_SPLINE_CURVE(_WITH_KNOTS)?\s*\(('[^']*',)?\s*([2-9]|1\d)", text):
            return
        entities = dict(re.findall(r"#(\d+)=([^;]*);", re.sub(r"\s+", "", text)))
        for number, entity in entities.items():
            plain = re.match(r"B_SPLINE_CURVE_WITH_KNOTS\('[^']*',(\d+),\(([^)]*)\),.*?,\(([^)]*)\),\(([^)]*)\)", entity)
            mixed = re.search(r"B_SPLINE_CURVE\((\d+),\(([^)]*)\).*B_SPLINE_CURVE_WITH_KNOTS\(\(([^)]*)\),\(([^)]*)\)", entity)
            weights = re.search(r"RATIONAL_B_SPLINE_CURVE\(\(([^)]*)\)", entity)
            match = plain or mixed
            if not match:
                continue
            degree = int(match[1])
            poles = [re.match(r"CARTESIAN_POINT\('[^']*',\(([^)]*)\)", entities[pole[1:]])[1].split(",")
                     for pole in match[2].split(",")]
            multiplicities = [int(m) for m in match[3].split(",")]
            knots = [Fraction(float(u)) for u, m in zip(match[4].split(","), multiplicities) for _ in range(m)]
            clamped = multiplicities[0] == multiplicities[-1] == degree + 1
            if degree < 2 or len(poles[0]) != 3 or not clamped:
                continue
            w = [Fraction(float(x)) for x in weights[1].split(",")] if weights else [Fraction(1)] * len(poles)
            homogeneous = [[Fraction(float(x)) * wi for x in pole] + [wi] for pole, wi in zip(poles, w)]
            # Equal weights are those of a polynomial curve.
            rational = len(set(w)) > 1
            for span, points in enumerate(bezier_spans(degree, knots, homogeneous)):
                points = [tuple(float(x / point[-1]) for x in point[:-1]) + ((float(point[-1]),) if rational else ())
                          for point in points]
                yield Curve(f"{number}:{span}", points, rational)


def numbers_in(nested):
    for part in nested:
        if isinstance(part, list):
            yield from numbers_in(part)
        else:
            yield part


def bezier_spans(degree, knots, poles):
    """The Bezier points of every span, exactly: values of the polar form (L. Ramshaw, Blossoms are polar forms, CAGD 6, 1989)."""
    for k in range(degree, len(poles)):
        if knots[k] == knots[k + 1]:
            continue
        points = []
        for j in range(degree + 1):
            arguments = [knots[k]] * (degree - j) + [knots[k + 1]] * j
            row = [poles[k - degree + i] for i in range(degree + 1)]
            for r, u in enumerate(arguments, 1):
                for i in range(degree, r - 1, -1):
                    low, high = knots[k - degree + i], knots[k + 1 + i - r]
                    s = (u - low) / (high - low)
                    row[i] = [(1 - s) * a + s * b for a, b in zip(row[i - 1], row[i])]
            points.append(row[degree])
        yield points


# Packages

def folder_of(package, packages):
    """The folder that the package's patterns are relative to: None where this version is neither installed nor unpacked."""
    if packages is not None:
        unpacked = packages / f"{package.name}-{package.version}".replace("/", "-")
        if unpacked.is_dir():
            return unpacked
    if package.system == "debian":
        try:
            result = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Version}", package.name],
                                    capture_output=True, text=True, check=False)
        except OSError:
            return None
        if result.stdout == f"installed {package.version}":
            return pathlib.Path("/")
    return None


def fetch(package, packages):
    """Downloads a package and unpacks what is read of it."""
    place = packages / f"{package.name}-{package.version}".replace("/", "-")
    with tempfile.TemporaryDirectory() as folder:
        get = (["apt-get", "-q", "download", f"{package.name}={package.version}"] if package.system == "debian" else
               ["npm", "pack", "--silent", f"{package.name}@{package.version}"])
        if subprocess.run(get, cwd=folder, stdout=subprocess.DEVNULL, check=False).returncode != 0:
            raise Failure(3, f"{' '.join(get)} failed; {package.name} {package.version} is required")
        archive = next(pathlib.Path(folder).iterdir())
        unpacked = pathlib.Path(folder) / "unpacked"
        unpacked.mkdir()
        if package.system == "debian":
            patterns = [f"./{pattern.replace('**', '*')}" for pattern in (*package.patterns, "usr/share/doc/*/copyright")]
            data = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", archive], stdout=subprocess.PIPE)
            subprocess.run(["tar", "-x", "-C", unpacked, "--wildcards", *patterns], stdin=data.stdout, check=True)
        else:
            subprocess.run(["tar", "-x", "-z", "-f", archive, "-C", unpacked, "--strip-components=1"], check=True)
        place.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cp", "-r", unpacked, place], check=True)


def paragraphs_of(copyright_text):
    """The paragraphs of a copyright file of Debian's format 1.0: (fields, text)."""
    for text in re.split(r"\n\s*\n", copyright_text):
        yield {field.lower(): value for field, value in re.findall(r"^(\S+):((?:.*)(?:\n[ \t].*)*)", text, re.M)}, text


def files_of(package, folder):
    """The files that are read of a package, in the order of their paths, each with a name that is short and its own."""
    paths = sorted({path for pattern in package.patterns for path in folder.glob(pattern)
                    if path.is_file() and not path.is_symlink()})
    if package.files_under:
        stanzas = [(re.compile("|".join(map(fnmatch.translate, fields["files"].split()))), fields["license"].split("\n")[0].strip())
                   for fields, _ in paragraphs_of(copyright_of(package, folder)) if "files" in fields]
        # The last paragraph that matches a file counts; its paths are those of the package's sources.
        def licence(path):
            return [licence for files, licence in stanzas if files.match("/".join(path.parts[-2:]))][-1]
        paths = [path for path in paths if licence(path) == package.files_under]
    return paths


def copyright_of(package, folder):
    file = folder / (f"usr/share/doc/{package.name}/copyright" if package.system == "debian" else package.licence_file)
    return file.read_text(encoding="utf-8")


def licence_text(name, source, folders, used):
    """What SET.csv.license says: the licence's SPDX id, and the packages' own words."""
    parts = [f"SPDX-License-Identifier: {source.licence}\n\n{name}.csv has curves of the packages below. make_sets.py chose them "
             "and wrote them as a\ntable; the curves stay under the licence of their package, as follows.\n"]
    for package, folder in zip(source.packages, folders):
        text = copyright_of(package, folder)
        if package.files_under:
            kept = []
            for fields, paragraph in paragraphs_of(text):
                of_used = any(fnmatch.fnmatch(file, pattern) for pattern in fields.get("files", "").split() for file in used)
                is_text = "files" not in fields and fields.get("license", "").split("\n")[0].strip() == package.files_under
                if "format" in fields or of_used or is_text:
                    kept.append(paragraph)
            text = "\n\n".join(kept)
        if package.common_licence:
            text += "\n" + (COMMON_LICENCES / package.common_licence).read_text(encoding="utf-8")
        parts.append(f"{'=' * 79}\n{package.name} {package.version}\n{'=' * 79}\n\n{text.strip()}\n")
    return "\n".join(line.rstrip() for line in "\n".join(parts).split("\n"))


def chosen_curves(name, source, folders, readers):
    """The curves of a set by file: {name of the file: curves}; and the paths of these files under their package."""
    files = {}
    for package, folder in zip(source.packages, folders):
        for path in files_of(package, folder):
            stem = path.stem
            if package.system == "npm" and len(source.packages) > 1:
                stem = f"{package.name}-{stem}"
            if stem in files:
                stem = f"{path.parent.name}-{stem}"
            files[re.sub(r"[^A-Za-z0-9_.-]", "_", stem)] = path
    taken, shapes, count, used = {}, set(), 0, []
    for stem in sorted(files, key=lambda stem: rank(name, stem)):
        if count == source.curves:
            break
        curves = [curve for curve in getattr(readers, source.reader)(files[stem]) if len(curve.points) > 2]
        kept = []
        for order in sorted(range(len(curves)), key=lambda k: rank(name, stem, curves[k].id)):
            if len(kept) == min(source.per_file, source.curves - count):
                break
            if curves[order].extent() == 0 or (shape := curves[order].shape()) in shapes:
                continue
            shapes.add(shape)
            kept.append(order)
        if kept:
            taken[stem] = [curves[k] for k in sorted(kept)]
            used.append("/".join(files[stem].parts[-2:]))
            count += len(kept)
    return dict(sorted(taken.items())), used


def as_csv(taken):
    """The set's text; ids begin with the name of the file."""
    curves = [Curve(f"{stem}:{curve.id}", curve.points, curve.rational) for stem, of_file in taken.items() for curve in of_file]
    dimension = max(len(curve.points[0]) - curve.rational for curve in curves)
    weighted = any(curve.rational for curve in curves)
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["curve", "index", *"xyz"[:dimension], *["w"] * weighted])
    for curve in curves:
        for index, point in enumerate(curve.points):
            row = [decimal(x) for x in point]
            missing = dimension - (len(point) - curve.rational)
            if missing:
                row[len(point) - curve.rational:len(point) - curve.rational] = [""] * missing
            table.writerow([curve.id, index, *row, *[""] * (weighted and not curve.rational)])
    return text.getvalue()


def make(name, program, folders):
    """The two files of a set, {name of the file: text}, and how many files of its sources were refused."""
    with tempfile.TemporaryDirectory(prefix="bezierbench-sets-") as folder:
        readers = Readers(program, folder)
        taken, used = chosen_curves(name, SOURCES[name], folders, readers)
    return {f"{name}.csv": as_csv(taken), f"{name}.csv.license": licence_text(name, SOURCES[name], folders, used)}, readers.refused


def tables(program, folder):
    """The tables of README.md, by their first line: where the sets in a folder come from, and what they are like, by form,
    dimension and degree, as `bezierbench curves` says."""
    sources = ["| set | curves | files | most from one | bytes | source | licence |", "|---|---|---|---|---|---|---|"]
    figures = ["| set | form | axes | degree | curves | distance over size: median | 99 % | largest | monotone | coincident neighbours |",
               "|---|---|---|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory(prefix="bezierbench-sets-") as place:
        readers = Readers(program, place)
        for name, source in sorted(SOURCES.items()):
            file = folder / f"{name}.csv"
            result = readers.run("curves", str(file), "--format", "csv")
            if result.returncode != 0:
                raise Failure(result.returncode, result.stderr.strip())
            for row in csv.DictReader(io.StringIO(result.stdout)):
                distances = [f"{float(f'{float(row[key]):.3g}'):,.12g}" for key in ("distance_median", "distance_p99", "distance_largest")]
                monotone = f"{100 * int(row['monotone']) / int(row['curves']):.0f} %"
                figures.append(f"| {name} | {row['form']} | {row['dimension']} | {row['degree']} | {row['curves']} | "
                               f"{' | '.join(distances)} | {monotone} | {row['coincident_neighbours']} |")
            files = Counter(curve.id.split(":")[0] for curve in curves_of_set(file.read_text(encoding="utf-8")))
            packages = ", ".join(f"{package.name} {package.version}" for package in source.packages)
            sources.append(f"| [`{name}`](#{name}) | {files.total():,} | {len(files)} | {max(files.values())} | "
                           f"{file.stat().st_size:,} | {packages} | {source.licence} |")
    return {table[0]: "\n".join(table) for table in (sources, figures)}


def with_tables(readme, tables_by_head):
    """README.md with its tables brought up to date."""
    for head, table in tables_by_head.items():
        readme = re.sub(re.escape(head) + r"(\n\|.*)*", lambda _, table=table: table, readme)
    return readme


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("sets", nargs="*", metavar="SET", help=", ".join(SOURCES))
    parser.add_argument("--out", type=pathlib.Path, default=HERE / "sets")
    parser.add_argument("--packages", type=pathlib.Path, help="folder of unpacked packages")
    parser.add_argument("--fetch", action="store_true", help="download what is missing into --packages")
    options = parser.parse_intermixed_args()
    for name in options.sets:
        if name not in SOURCES:
            parser.error(f"{name}: not a set; there are {', '.join(SOURCES)}")
    if options.fetch and options.packages is None:
        parser.error("--fetch requires --packages FOLDER")
    try:
        for name in options.sets or SOURCES:
            folders = []
            for package in SOURCES[name].packages:
                if options.fetch and folder_of(package, options.packages) is None:
                    fetch(package, options.packages)
                folders.append(folder_of(package, options.packages))
                if folders[-1] is None:
                    raise Failure(3, f"{name}: {package.name} {package.version} is neither installed nor in --packages; "
                                     "use --packages FOLDER --fetch")
            texts, refused = make(name, options.program, folders)
            for file, text in texts.items():
                (options.out / file).write_text(text, encoding="utf-8")
            print(f"{name}: {len({row.split(',')[0] for row in texts[f'{name}.csv'].splitlines()[1:]})} curves, "
                  f"{len(texts[f'{name}.csv'])} bytes" + (f", {refused} files refused" if refused else ""))
        readme = options.out / "README.md"
        if readme.exists():
            text = readme.read_text(encoding="utf-8")
            readme.write_text(with_tables(text, tables(options.program, options.out)), encoding="utf-8")
    except Failure as failure:
        print(f"make_sets.py: {failure}", file=sys.stderr)
        return failure.code
    except subprocess.CalledProcessError as error:
        print(f"make_sets.py: {error.cmd[0]} failed with {error.returncode} on a package", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"make_sets.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
