#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every citation can be looked up, that every method's header opens with its labelled lines, that long proofs are
pages of docs/proofs, and that everything that the source documents print has its place in the tree.

sources.py [ROOT] [--program PROGRAM]   prints one line per finding and exits 1 if there is any.

A citation is a key in brackets, such as [Higham 2002], that reference/published/SOURCES.md lists. The C++ files of core/ and
reference/ are read and, with --program, the list of methods that PROGRAM prints.
"""
import argparse
import csv
import io
import re
import subprocess
import sys
from pathlib import Path

SOURCES = "reference/published/SOURCES.md"
FOLDERS = ("core", "reference")
PROOFS = "docs/proofs"
LABELS = ("Formula", "Source", "Cost", "Bound", "Fails")
REQUIRED = ("Formula", "Bound", "Fails")  # the others say what `citation` and `flops` of a method do not
LONGEST_PROOF = 6  # lines of a comment
WIDTH = 120  # clang-format does not wrap comments
NO_SOURCE = "bound derived here"  # a part of a method's citation that names no source
TABLE = "| document | there | what | here | verdict |"
DOCUMENTS = ("000", "001", "002", "003", "004")
VERDICTS = ("right", "as printed", "corrected", "judged", "drawn")

KEY = r"\[((?:de )?[A-Z][A-Za-z.\- ]* \d{3,4})\]"
ENTRY = re.compile(rf"^(?:###|-) {KEY} \S", re.MULTILINE)
# A citation without a key: a year outside brackets, or a document by its number.
UNLISTED = re.compile(r"\b(?:1[89]|20)\d\d\b(?!\^|,\d)|\b(?:[Rr]eport|[Dd]ocument)s? 00\d\b")
LABEL_IN_A_LINE = re.compile(rf"^// .*\S +(?:{'|'.join(LABELS)}): ")
PROOF_PAGE = re.compile(rf"{PROOFS}/\w+\.md")
COMMENT = re.compile(r"(?<!:)//[/<! ]*(.*)$")
INCLUDE = re.compile(r'#include "(core/[^"]+)"')


def keys_of(sources):
    """The keys in the text of SOURCES.md, in order, with repetitions."""
    return ENTRY.findall(sources)


def cxx_files(root):
    return sorted(path for folder in FOLDERS for path in (root / folder).rglob("*.[ch]pp"))


def comments(text):
    """[(number of its first line, text)] for each block of comment lines. A comment at the end of a line of code is its
    own block."""
    blocks, last = [], 0
    for number, line in enumerate(text.splitlines(), 1):
        match = COMMENT.search(line)
        if not match:
            continue
        whole = line.lstrip().startswith("//")
        if whole and blocks and last == number - 1:
            blocks[-1][1].append(match[1])
        else:
            blocks.append((number, [match[1]]))
        last = number if whole else 0
    return [(number, " ".join(lines)) for number, lines in blocks]


def cited(text):
    """The keys in the comments and the strings of a file. A key may go on in the next line."""
    joined = re.sub(r'"\s*"', "", re.sub(r"\s*\n\s*//[/<! ]*", " ", text))
    return sorted(set(re.findall(KEY, joined)))


def opening(text):
    """The lines of the comment that opens a file, without the licence."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        if "SPDX-License-Identifier" not in line:
            lines.append(line)
    return lines


def citation_findings(name, text, keys):
    """Yields the citations in a file that are not listed."""
    for key in cited(text):
        if key not in keys:
            yield f"{name}: [{key}] is not listed in {SOURCES}"
    for number, comment in comments(text):
        bare = UNLISTED.search(re.sub(KEY, "", comment))
        if bare:
            yield f"{name}:{number}: '{bare[0]}' looks like a citation without its key; write a key of {SOURCES}, in brackets"


def line_findings(name, text):
    """Yields labelled lines that are joined with the line before, and comments that are too long."""
    for number, line in enumerate(text.splitlines(), 1):
        if LABEL_IN_A_LINE.search(line):
            yield f"{name}:{number}: a labelled line of a header stands within another line; begin a line with it"
        if line.lstrip().startswith("//") and len(line) > WIDTH:
            yield f"{name}:{number}: {len(line)} characters; comments end at {WIDTH}"


def proof_findings(name, text, pages):
    """Yields pages of proofs that do not exist, and proofs in the opening comment that should be one."""
    for page in PROOF_PAGE.findall(text):
        if page not in pages:
            yield f"{name}: {page} does not exist"
    label, length = None, 0
    for line in [*opening(text), "// End: "]:
        if match := re.match(r"// ([A-Z][a-z]+): ", line):
            if label in ("Bound", "Keeps", "Theory") and length > LONGEST_PROOF:
                yield f"{name}:2: the paragraph {label}: has {length} lines; move the proof to a page of {PROOFS}"
            label, length = match[1], 0
        length += 1


def method_headers(root):
    """The names of the headers that a roster includes and that define a method."""
    included = {name for roster in (root / "core").rglob("roster.hpp") for name in INCLUDE.findall(roster.read_text())}
    return sorted(name for name in included if re.search(r'\.id\s*=(?!.*Literal<)[^,;]*"', (root / name).read_text()))


def header_findings(name, text):
    """Yields what is wrong with a method's header: a label that is missing or in the wrong place, or a method that cites nothing."""
    found = [match[1] for line in opening(text) if (match := re.match(r"// ([A-Z][a-z]+): ", line))]
    known = [label for label in found if label in LABELS]
    if known != [label for label in LABELS if label in {*known, *REQUIRED}] or found[0] != LABELS[0]:
        yield (f"{name}:2: the header must open with the lines {', '.join(label + ':' for label in LABELS)} in this order; only "
               f"{' and '.join(label + ':' for label in LABELS if label not in REQUIRED)} may be missing")
    if not cited("".join(re.findall(r"\bcitation\s*=[^;}]*", text))):
        yield f"{name}: `citation` cites nothing; write a key of {SOURCES}, in brackets"


def place_finding(root, place):
    """What is wrong with a place, `file` or `file#words in it`; None where it exists."""
    name, _, words = place.partition("#")
    path = root / name
    if not path.is_file():
        return f"{name} is not a file"
    if words and words not in path.read_text(encoding="utf-8"):
        return f"{name} does not have the words '{words}'"
    return None


def table_findings(root, sources):
    """Yields the rows of the table of the documents without a place, with one that does not exist, or without a known verdict."""
    lines = sources.splitlines()
    if TABLE not in lines:
        yield f"{SOURCES}: no table with the head {TABLE}"
        return
    first, seen = lines.index(TABLE) + 2, set()
    for number, line in enumerate(lines[first:], first + 1):
        if not line.startswith("|"):
            break
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) != 5 or not all(cells[:3]):
            yield f"{SOURCES}:{number}: {len(cells)} cells; write document, place there, what it is, place here and verdict"
            continue
        document, _, what, here, verdict = cells
        seen.add(document)
        places = re.findall(r"`([^`]+)`", here)
        if not places:
            yield f"{SOURCES}:{number}: '{what}' has no place; name a file, or a file and words in it as `file#words`"
        for place in places:
            if wrong := place_finding(root, place):
                yield f"{SOURCES}:{number}: {wrong}"
        if document not in DOCUMENTS:
            yield f"{SOURCES}:{number}: '{document}' is not one of the documents {', '.join(DOCUMENTS)}"
        if verdict not in VERDICTS:
            yield f"{SOURCES}:{number}: '{verdict}' is not a verdict; write one of {', '.join(VERDICTS)}"
    yield from (f"{SOURCES}: the table has no row of document {document}" for document in DOCUMENTS if document not in seen)


def listed_findings(listing, keys):
    """Yields the parts of citations in the program's list of methods that do not begin with a listed key."""
    rows = list(csv.DictReader(io.StringIO(listing)))
    if not rows:
        yield "the program lists no methods"
    for row in rows:
        if row["id"].startswith("peer_"):
            continue  # another library needs no citation
        for part in row["citation"].split("; "):
            match = re.match(KEY, part)
            if not match and part != NO_SOURCE:
                yield f"{row['id']}: '{part}' in its citation does not begin with a key of {SOURCES}"
            elif match and match[1] not in keys:
                yield f"{row['id']}: [{match[1]}] is not listed in {SOURCES}"


def findings(root, listing=None):
    sources = (root / SOURCES).read_text(encoding="utf-8")
    keys = keys_of(sources)
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in cxx_files(root)}
    found = [f"{SOURCES}: [{key}] is listed twice" for key in sorted({key for key in keys if keys.count(key) > 1})]
    pages = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in sorted((root / PROOFS).glob("*.md"))}
    for name, text in texts.items():
        found += [*citation_findings(name, text, keys), *line_findings(name, text), *proof_findings(name, text, pages)]
    found += [f"{name}: [{key}] is not listed in {SOURCES}" for name, text in pages.items() for key in cited(text) if key not in keys]
    named = {page for text in texts.values() for page in PROOF_PAGE.findall(text)}
    found += [f"{name}: no header names this page" for name in pages if name not in named and not name.endswith("/README.md")]
    headers = method_headers(root)
    if not headers:
        found.append("core: no roster includes a method")
    for name in headers:
        found += header_findings(name, texts[name])
    used = {key for text in [*texts.values(), *pages.values()] for key in cited(text)}
    found += [f"{SOURCES}: nothing cites [{key}]" for key in keys if key not in used]
    found += table_findings(root, sources)
    if listing is not None:
        found += listed_findings(listing, keys)
    return found, len(keys), len(headers)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parent.parent)
    parser.add_argument("--program", metavar="PROGRAM")
    options = parser.parse_args()
    listing = None
    if options.program:
        listing = subprocess.run([options.program, "list", "methods", "--format", "csv"], check=True, capture_output=True,
                                 text=True).stdout
    found, keys, headers = findings(options.root, listing)
    print("\n".join(found) if found else f"{keys} sources, {headers} headers of methods")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
