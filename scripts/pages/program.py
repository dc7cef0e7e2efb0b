# SPDX-License-Identifier: MIT
"""The parts of the documents that the program says, its suites and generators, and the statements of its sources."""
import csv
import io
import os
import re
import subprocess
from pathlib import Path

from scripts.pages.markdown import table

STATEMENTS = Path(__file__).resolve().parents[2] / "experiments/guarantees/statements.hpp"
STATEMENT = re.compile(r"((?:^///.*\n)+)template <class Scalar>\nstruct \w+ \{\n  static constexpr Property", re.MULTILINE)
COLUMNS = 100  # of a line of output


def output(program, *arguments):
    """What it prints, whatever the width and the language of the terminal that this runs in."""
    environment = {"PATH": os.environ["PATH"], "COLUMNS": str(COLUMNS), "NO_COLOR": "1", "LC_ALL": "C.UTF-8"}
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True, env=environment).stdout


def rows_of(program, what):
    return list(csv.DictReader(io.StringIO(output(program, "list", what, "--format", "csv"))))


def method_list_of(program):
    """Our own methods as CSV, without peers, which depend on what a machine has installed."""
    text = output(program, "list", "methods", "--format", "csv")
    return "".join(line for line in text.splitlines(keepends=True) if not line.startswith("peer_"))


def generators(_page, program):
    body = [[f"`{row['id']}`", row["coordinates"], row["t"], row["weights"]] for row in rows_of(program, "generators")]
    return table(["id", "coordinates", "t", "weights"], body)


def statements(_page):
    """What each property states, from the comments of the statements."""
    parts = []
    for comment in STATEMENT.findall(STATEMENTS.read_text(encoding="utf-8")):
        name, _, text = " ".join(line.removeprefix("///").strip() for line in comment.splitlines()).partition(": ")
        parts.append(f"**{name}**: " + text.replace("see Finite", "see `finite`").replace("*", r"\*").replace("|", r"\|"))
    return "\n\n".join(parts)
