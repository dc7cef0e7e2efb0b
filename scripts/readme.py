#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The parts of README.md that are numbers: filled in from the committed baseline bundle, never typed.

readme.py            compares, and exits 1 where README.md says something else than the bundle
readme.py --update   writes them
readme.py --methods PROGRAM   also compares the bundle's list of methods with what PROGRAM lists of our own; README.md, the
                              report and `list methods` then show the same methods
"""
import argparse
import csv
import io
import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle  # noqa: E402
from report.chapters import method_list  # noqa: E402
BASELINE = ROOT / "results" / "baseline"
README = ROOT / "README.md"
VERDICTS = ("inside", "explained", "outside")


def rows(name):
    return list(csv.DictReader(io.StringIO((BASELINE / name).read_text(encoding="utf-8"))))


def table(header, body):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(field) for field in line) + " |" for line in body]
    return "\n".join(lines)


def scorecard():
    cells = rows("scorecard.csv") + rows("scorecard_timing.csv")
    counts = Counter((cell["table"], cell["verdict"]) for cell in cells)
    numbers = sorted({cell["table"] for cell in cells})
    body = [[number, *(counts[number, verdict] for verdict in VERDICTS),
             sum(counts[number, verdict] for verdict in VERDICTS)] for number in numbers]
    return table(["table of the report", *VERDICTS, "printed cells"], body)


def digest():
    manifest = json.loads((BASELINE / "bundle.json").read_text(encoding="utf-8"))
    return f"    {manifest['accuracy_digest']}"


def methods():
    """The table of the report's chapter, so that the two cannot differ."""
    listed = method_list.listed(Bundle(BASELINE))
    body = [[write(row).replace("|", "\\|") for _, write in method_list.COLUMNS] for row in listed]
    return table([heading for heading, _ in method_list.COLUMNS], body)


PARTS = {"scorecard": scorecard, "digest": digest, "methods": methods}


def filled(text):
    for name, make in PARTS.items():
        pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        if not pattern.search(text):
            sys.exit(f"README.md: no part between <!-- begin {name} --> and <!-- end {name} -->")
        part = make()
        text = pattern.sub(lambda match: f"{match[1]}\n{part}\n\n{match[2]}", text)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--methods", metavar="PROGRAM")
    options = parser.parse_args()
    text = README.read_text(encoding="utf-8")
    wanted = filled(text)
    if options.update:
        README.write_text(wanted, encoding="utf-8")
    elif wanted != text:
        sys.exit("README.md: its numbers are not those of results/baseline; run scripts/readme.py --update")
    if options.methods:
        listed = subprocess.run([options.methods, "list", "methods", "--format", "csv"], check=True,
                                capture_output=True, text=True).stdout
        listed = "".join(line for line in listed.splitlines(keepends=True) if not line.startswith("peer_"))
        if listed != (BASELINE / "methods.csv").read_text(encoding="utf-8"):
            sys.exit("results/baseline/methods.csv: not what the program lists; run scripts/check golden --update")
    print("README.md agrees with results/baseline")


if __name__ == "__main__":
    main()
