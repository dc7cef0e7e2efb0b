#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""snippets_test.py PAGE.md --prefix P: builds and runs every snippet of a page against the package installed under P.

The blocks of a page are taken in order, in one scratch folder, which has the repository's folder `results`:
  cpp, c    a file of its own, compiled with the flags of the package's pkg-config files and warnings as errors; a snippet
            with a function main is linked and run as well. A first line `// NAME.cpp` gives the file its name.
  python    run with the module of the package on its path
  cmake     a CMakeLists.txt; the project of it and the files named so far is configured and built, with this source tree
            where it fetches bezierbench
  text      directly below one of these: what running it prints, to the letter; `...` stands for anything
A snippet that fails, prints something else or prints what no block shows is a failure. Other blocks are left alone.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```(\w+)[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"\s*//\s*(\w+\.(?:cpp|c|h|hpp))\s*$")
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Werror"]
COMPILERS = {"cpp": (["c++"], ["-std=c++20"], "CXX"), "c": (["cc"], ["-std=c99", "-Wpedantic"], "CC")}
MODULES = {"cpp": ("bezierbench-reference bezierbench-c", "bezierbench-methods"), "c": ("bezierbench-c",)}  # the first installed


class Wrong(Exception):
    """A snippet does not do what the page says."""


def blocks_of(text):
    """[(language, text, number of its first line, expected output or None)] of the snippets of a page, in order."""
    found = [(m[1], m[2], text.count("\n", 0, m.start()) + 2, m.start(), m.end()) for m in BLOCK.finditer(text)]
    snippets = []
    for place, (language, body, line, _, end) in enumerate(found):
        if language not in ("cpp", "c", "python", "cmake"):
            continue
        expected = None
        if place + 1 < len(found) and found[place + 1][0] == "text" and not text[end:found[place + 1][3]].strip():
            expected = found[place + 1][1]
        snippets.append((language, body, line, expected))
    return snippets


class Page:
    def __init__(self, prefix, folder):
        self.prefix = Path(prefix).resolve()
        self.folder = Path(folder)
        libraries = self.prefix / "lib"
        python = libraries / "python3/dist-packages"
        self.environment = dict(os.environ, PKG_CONFIG_PATH=str(libraries / "pkgconfig"), LD_LIBRARY_PATH=str(libraries),
                                PYTHONPATH=str(python), CMAKE_PREFIX_PATH=str(self.prefix))

    def run(self, *command):
        """Standard output of a command; Wrong where it fails."""
        done = subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Wrong(f"{command[0]} ends with {done.returncode}\n{done.stdout}{done.stderr}".rstrip())
        return done.stdout

    def flags(self, language):
        for modules in (each.split() for each in MODULES[language]):
            if all((self.prefix / f"lib/pkgconfig/{module}.pc").exists() for module in modules):
                return self.run("pkg-config", "--cflags", *modules).split(), self.run("pkg-config", "--libs", *modules).split()
        raise Wrong(f"{self.prefix}: no pkg-config file of {', '.join(MODULES[language])}")

    def compiled(self, language, body, line):
        lines = body.splitlines()
        named = NAMED.match(lines[0]) if lines else None
        source = named[1] if named else f"line{line}.{language}"
        (self.folder / source).write_text(body, encoding="utf-8")
        default, standard, variable = COMPILERS[language]
        compiler = os.environ.get(variable, "").split() or default
        compile_flags, link_flags = self.flags(language)
        program = Path(source).with_suffix(".out").name
        if re.search(r"\bmain\s*\(", body):
            self.run(*compiler, *standard, "-O1", *WARNINGS, *compile_flags, source, "-o", program, *link_flags)
            return self.run(f"./{program}")
        self.run(*compiler, *standard, *WARNINGS, *compile_flags, "-fsyntax-only", source)
        return ""

    def cmake(self, body):
        (self.folder / "CMakeLists.txt").write_text(body, encoding="utf-8")
        shutil.rmtree(self.folder / "build", ignore_errors=True)
        self.run("cmake", "-G", "Ninja", "-S", ".", "-B", "build", f"-DFETCHCONTENT_SOURCE_DIR_BEZIERBENCH={ROOT}")
        self.run("cmake", "--build", "build")
        return ""

    def printed(self, language, body, line):
        if language == "cmake":
            return self.cmake(body)
        if language == "python":
            script = self.folder / f"line{line}.py"
            script.write_text(body, encoding="utf-8")
            return self.run("/usr/bin/python3", "-B", script.name)
        return self.compiled(language, body, line)

    def check(self, language, body, line, expected):
        printed = self.printed(language, body, line)
        if expected is None and printed.strip():
            raise Wrong(f"prints what no block shows:\n{printed}")
        if expected is not None and not matches(expected, printed):
            raise Wrong(f"prints\n{printed}where the page shows\n{expected}")


def matches(expected, printed):
    """Whether the text is the expected one, with anything in place of `...`."""
    parts = [re.escape(part) for part in expected.split("...")]
    return re.fullmatch(".*".join(parts), printed, re.DOTALL) is not None


def check_page(page, prefix):
    """[complaint] about the snippets of a page, and their number."""
    snippets = blocks_of(Path(page).read_text(encoding="utf-8"))
    complaints = []
    with tempfile.TemporaryDirectory(prefix="bezierbench-snippets-") as folder:
        (Path(folder) / "results").symlink_to(ROOT / "results")
        place = Page(prefix, folder)
        for language, body, line, expected in snippets:
            try:
                place.check(language, body, line, expected)
            except Wrong as wrong:
                complaints.append(f"{page}:{line}: {wrong}")
    return complaints, len(snippets)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--prefix", required=True, help="where the package is installed")
    options = parser.parse_args()
    complaints, count = check_page(options.page, options.prefix)
    for complaint in complaints:
        print(complaint)
    print(f"{options.page}: {count} snippets, {len(complaints)} wrong")
    return 1 if complaints or not count else 0


if __name__ == "__main__":
    sys.exit(main())
