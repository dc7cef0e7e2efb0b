# SPDX-License-Identifier: MIT
"""The libraries of the audit: exact versions, the questions to each and what may be expected, and how to install and ask them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
ADAPTERS = Path(__file__).resolve().parent / "adapters"
FOLDER = ROOT / "build/audit"
BATCH = 500

USER = "nothing is documented; a user's expectation"


class Question(NamedTuple):
    problem: str  # of questions.PROBLEMS
    degrees: tuple[int, ...]
    expectation: float  # an answer with a larger error is off
    unit: str  # of errors, of questions.UNITS
    why: str  # what the library says


class Library(NamedTuple):
    name: str
    version: str
    source: str  # "npm", "debian" or "rust" (Debian's source packages)
    command: tuple[str, ...]
    questions: tuple[Question, ...]
    note: str = ""


BOTH = (2, 3)
POINT = Question("point", BOTH, 1e-12, "of the largest coordinate", USER)
SPLIT = Question("split", BOTH, 1e-12, "of the largest coordinate", USER)
ENDS = Question("ends", BOTH, 0, "of the largest coordinate", "nothing is documented; users expect the ends of a curve to stay, and the halves to meet")
LENGTH = Question("length", BOTH, 1e-3, "of the length", USER)
NEAREST = Question("nearest", BOTH, 1e-3, "of the size", USER)
DISTANCE = Question("distance", BOTH, 1e-3, "of the size", USER)
EASING = (Question("easing", (3,), 1e-6, "of the range", USER + ", that of browsers"),
          Question("monotone", (3,), 1e-12, "of the range", "nothing is documented; users expect of an increasing curve that it never goes back"))
ACCURACY = "the argument accuracy, here its default 1e-6: the result is accurate to it"

LIBRARIES = (
    Library("bezier-js", "6.1.4", "npm", ("node", "bezier_js.mjs"), (
        LENGTH._replace(why="Gauss-Legendre quadrature with 24 nodes; " + USER), POINT, SPLIT, ENDS,
        NEAREST._replace(why="the best of 101 points, then of steps of 1/1000; " + USER), DISTANCE),
        "where the nearest point is an end, `project` states the distance of a point beyond it, of the curve continued; t and the point "
        "are accurate. Lengths are off near cusps"),
    Library("paper", "0.12.20", "npm", ("node", "paper.mjs"), tuple(
        question._replace(degrees=(3,)) for question in (
            LENGTH, POINT, SPLIT, ENDS, NEAREST, DISTANCE, Question("at_length", BOTH, 1e-3, "of the length", USER))),
        "16 Gauss-Legendre nodes; lengths are off near cusps"),
    Library("svg-path-properties", "2.1.0", "npm", ("node", "svg_path_properties.mjs"), (
        LENGTH, Question("at_length", BOTH, 1e-3, "of the length", "nothing is documented; its search stops at 0.001 of the length")),
        "asks for Node.js 22, and runs under 20"),
    Library("bezier-easing", "3.2.0", "npm", ("node", "bezier_easing.mjs", "bezier-easing", "import"), EASING,
        "as `import` loads it, with its new solver"),
    Library("bezier-easing-require", "3.2.0", "npm", ("node", "bezier_easing.mjs", "bezier-easing", "require"), EASING,
        "as `require` loads it: the package's file for it still has the old solver"),
    Library("bezier-easing", "2.1.0", "npm", ("node", "bezier_easing.mjs", "bezier-easing-2.1.0", "require"), EASING,
        "the version before 3"),
    Library("fonttools", "4.38.0", "debian", ("/usr/bin/python3", "fonttools.py"), (
        Question("length", (3,), 5e-3, "of the length", "the argument tolerance, by default 0.005, controls the precision"),
        LENGTH._replace(degrees=(2,), why="analytical; " + USER),
        Question("approximate_length", BOTH, 1e-3, "of the length", "approximates, without a bound; a user's expectation"),
        POINT, SPLIT, ENDS,
        Question("quadratics", (3,), 1 + 1e-9, "of the tolerance", "cu2qu: max_err is the permitted deviation; here 0.001 of the size"),
        Question("moved", (3,), 0, "pieces", "nothing is documented; users expect of a curve that is moved without rounding the same number "
                 "of quadratics (fonttools#2518)")),
        "of 2022; later versions of splitCubicAtT keep the ends (fonttools#3743). A cubic that returns to its start ends calcCubicArcLength "
        "with a RecursionError"),
    Library("kurbo", "0.7.1", "rust", ("release/kurbo",), (
        Question("length", BOTH, 1e-6, "units", ACCURACY),
        Question("length", (2,), 1e-13, "of the length", "of quadratics: accuracy should be better than 1e-13 over the entire range"),
        POINT, SPLIT, ENDS, Question("nearest", BOTH, 1e-6, "units", "the argument accuracy, here its default 1e-6"),
        Question("distance", BOTH, 1e-6, "units", "the argument accuracy, here its default 1e-6"),
        Question("at_length", BOTH, 1e-6, "units", ACCURACY),
        Question("quadratics", (3,), 1 + 1e-9, "of the tolerance", "to_quads takes an accuracy; here 0.001 of the size")),
        "of 2020, as Debian 12 has it; `nearest` answers with another point for some cubics that are straight lines"),
    Library("lyon_geom", "0.15.0", "rust", ("release/lyon",), (
        Question("flattened_length", BOTH, 1e-3, "of the length",
                 "the length of a polygon at most a tolerance away, here 0.0001 of the size; a user's expectation"),
        POINT, SPLIT, ENDS), "packaged 2019 to 2021, as Debian 12 has it; a cubic that goes out and back on a line may have the length 0"),
)

NPM = {"bezier-js": "6.1.4", "paper": "0.12.20", "svg-path-properties": "2.1.0", "bezier-easing": "3.2.0",
       "bezier-easing-2.1.0": "npm:bezier-easing@2.1.0"}
CRATES = ("arrayvec", "autocfg", "euclid", "kurbo", "lyon-geom", "num-traits")


def _run(command: list[str | Path], folder: Path) -> str:
    """What the command prints. Raises OSError with a line about a command that fails."""
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if result.returncode:
        lines = (result.stderr.strip() or result.stdout.strip() or "no message").splitlines()
        raise OSError(f"{' '.join(map(str, command[:3]))} failed: {lines[-1]}")
    return result.stdout


def _install_npm(folder: Path) -> None:
    manifest = json.dumps({"private": True, "dependencies": NPM})
    written = folder / "package.json"
    if not (folder / "node_modules/.package-lock.json").exists() or written.read_text() != manifest:
        written.write_text(manifest)
        _run(["npm", "install", "--no-audit", "--no-fund", "--ignore-scripts", "--silent"], folder)
    for adapter in ADAPTERS.glob("*.mjs"):  # beside node_modules, where import looks
        shutil.copy(adapter, folder)


def _install_rust(folder: Path) -> None:
    registry = folder / "debian/usr/share/cargo/registry"
    if not registry.exists():
        _run(["apt-get", "download", *(f"librust-{crate}-dev" for crate in CRATES)], folder)
        for package in folder.glob("librust-*.deb"):
            _run(["dpkg", "-x", package, "debian"], folder)
    for file in [*ADAPTERS.glob("*.rs"), ADAPTERS / "Cargo.toml"]:
        shutil.copy(file, folder)
    (folder / ".cargo").mkdir(exist_ok=True)
    (folder / ".cargo/config.toml").write_text(f'[source.crates-io]\nreplace-with = "debian"\n[source.debian]\ndirectory = "{registry}"\n')
    _run(["cargo", "build", "--release", "--offline", "--target-dir", "."], folder)


def _installed_version(library: Library, folder: Path) -> str:
    if library.source == "debian":
        return _run([library.command[0], "-c", "import fontTools; print(fontTools.version)"], folder).strip()
    if library.source == "npm":
        name = library.command[2] if library.command[2:] else library.name
        return json.loads((folder / "node_modules" / name / "package.json").read_text())["version"]
    packages = json.loads(_run(["cargo", "metadata", "--offline", "--format-version", "1"], folder))["packages"]
    return next(package["version"] for package in packages if package["name"] == library.name)


def command(library: Library) -> list[str]:
    """Installs the library and returns its adapter's command. Raises OSError with a line about a library that is absent."""
    folder = FOLDER / library.source
    folder.mkdir(parents=True, exist_ok=True)
    if library.source == "rust":
        _install_rust(folder)
    elif library.source == "npm":
        _install_npm(folder)
    found = _installed_version(library, folder)
    if found != library.version:
        raise OSError(f"{library.name} is {found}, not {library.version}")
    places = {"rust": folder, "npm": folder, "debian": ADAPTERS}
    return [str(places[library.source] / part) if (places[library.source] / part).is_file() else part for part in library.command]


class Child:
    """A library's adapter, a process that answers batches one after the other."""

    def __init__(self, arguments: list[str]) -> None:
        self._process = subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                         env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})

    def ask(self, problem: str, degree: int, items: list[list[float]]) -> list[list[float] | None]:
        """An answer for each item: a list of numbers, or None. Raises OSError where the process has ended."""
        answers: list[list[float] | None] = []
        for begin in range(0, len(items), BATCH):
            batch = {"problem": problem, "degree": degree, "items": items[begin:begin + BATCH]}
            self._process.stdin.write(json.dumps(batch) + "\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
            if not line:
                raise OSError(f"the adapter ended at a question for {problem}")
            answers += json.loads(line)
        return answers

    def close(self) -> None:
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
