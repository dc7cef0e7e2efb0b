# SPDX-License-Identifier: MIT
"""The parts of the documents that the program says: its methods, suites, generators, kinds of studies and commands."""
import csv
import io
import os
import re
import subprocess
import sys

from report.chapters.provenance import METHOD_COLUMNS
from scripts.pages.markdown import table

COMMAND = re.compile(r"^  ([a-z][a-z_-]*)(?:\s{2,}|$)")
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


def methods(_page, program):
    """The program's methods in the columns of the report's chapter."""
    rows = [row for row in csv.DictReader(io.StringIO(method_list_of(program))) if ":" not in row["id"]]
    return table([heading for heading, _ in METHOD_COLUMNS], [[write(row) for _, write in METHOD_COLUMNS] for row in rows])


def suites(_page, program):
    """The shipped suites; those of other libraries have no seconds, since these are not everywhere."""
    body = [[f"[`{row['id']}`](../experiments/suites/{row['file']})", row["title"], row["studies"], row["seconds"]]
            for row in rows_of(program, "suites")]
    return table(["id", "what it asks", "studies", "processor seconds"], body)


def generators(_page, program):
    body = [[f"`{row['id']}`", row["coordinates"], row["t"], row["weights"]] for row in rows_of(program, "generators")]
    return table(["id", "coordinates", "t", "weights"], body)


def kinds(_page, program):
    return f"```text\n{output(program, 'list', 'kinds').strip()}\n```"


def subcommands(text):
    """The names under the heading of commands in the text of a help."""
    _, heading, listed = text.partition("\nSubcommands:\n")
    return [found[1] for line in listed.split("\n\n")[0].splitlines() if (found := COMMAND.match(line))] if heading else []


def commands(_page, program):
    """What `--help` says of every command, in the order in which the program lists them."""
    parts = []

    def visit(path):
        text = output(program, *path, "--help")
        name = " ".join(["bezierbench", *path])
        shown = text.partition("\nThe keys of a [[study]]")[0].strip()  # docs/suites.md has the keys of studies
        parts.append(f"## {name}\n\n```text\n{shown}\n```")
        found = subcommands(text)
        if not path and not found:
            sys.exit(f"{program} --help names no commands that scripts/pages/program.py could read")
        for one in found:
            visit([*path, one])

    visit([])
    return "\n\n".join(parts)
