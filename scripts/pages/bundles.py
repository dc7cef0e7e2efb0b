# SPDX-License-Identifier: MIT
"""The parts of the documents that are numbers of committed bundles."""
import csv
import sys
import textwrap
from collections import Counter
from pathlib import Path

from report import files
from report.bundle import Bundle
from report.chapters.printed import MARK, counts
from report.findings.printed_tables import events, verdicts
from report.findings.printed_times import times_as_ratios
from report.wording import listing
from scripts.digests import Agreement
from scripts.pages import printed_times
from scripts.pages.markdown import WIDTH, link, table

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "results"
BASELINE = RESULTS / "baseline"
ANSWERS = RESULTS / "answers"
REAL = RESULTS / "real"
TIMES = "2.4"  # the table of the report that prints times
SAID = {"inside": "inside the band of our repetitions", "edge": "on its edge, within the error of that edge",
        "explained": "outside it for a stated cause"}


def real():
    """The bundle of real curves; None where there is none yet."""
    return Bundle(REAL) if REAL.exists() else None


def scorecard(_page):
    body = [[number, *(found[verdict] for verdict in MARK), found.total()] for number, found in counts(Bundle(BASELINE)).items()]
    return table(["table of the report", *MARK, "cells or ratios"], body)


def gates(_page):
    """How often each gate fired, of results/gates.csv, which scripts/check gates writes."""
    with open(RESULTS / "gates.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    names = list(dict.fromkeys(row["gate"] for row in rows))
    cells = {(row["change"], row["gate"]): row for row in rows}

    def cell(row):
        text = f"{row['fired']} of {row['runs']}" + (" ✓" if row["wrong"] == "0" else f", {row['wrong']} wrong")
        return text + (f", {row['rows_undecided']} of {row['rows']} rows undecided" if row["rows_undecided"] != "0" else "")
    return table(["change", *(f"`{name}` fired in" for name in names)],
                 [[change, *(cell(cells[change, name]) for name in names)] for change in dict.fromkeys(row["change"] for row in rows)])


def printed(_page):
    """The printed errors and counts by verdict, each counted once, the ratios of the printed times beside ours, and in which build their order
    holds, as sentences."""
    baseline = Bundle(BASELINE)
    tables, found = counts(baseline), events(baseline)
    del tables[TIMES]
    by, _, chance = verdicts(found)
    said = [f"{by[verdict]} {'is' if by[verdict] == 1 else 'are'} {words}" for verdict, words in SAID.items() if by[verdict]]
    said.append(f"{by['outside']} {'is' if by['outside'] == 1 else 'are'} outside it, {chance}")
    rows = printed_times.rows_of(printed_times.FILE)
    text = (f"It prints {sum(tables.values(), Counter()).total()} errors and counts (tables {listing(tables)}), {len(found)} of them "
            f"distinct: the others repeat a run in another table or by a method that errs alike. Of the distinct ones "
            f"{listing(said)}. Its times (table {TIMES}) are of another machine and build. {times_as_ratios(baseline).headline} "
            f"{printed_times.orders(rows)} ({rows[0]['compiler']}, {rows[0]['processor']}).")
    return textwrap.fill(text, 130)


def printed_orders(_page):
    """The printed times beside those of two builds of what the report describes."""
    rows = printed_times.rows_of(printed_times.FILE)
    return f"{printed_times.table_of(rows)}\n\n" + textwrap.fill(f"{rows[0]['compiler']}, {rows[0]['processor']}.", WIDTH)


def committed_bundles():
    return sorted(path.parent for path in RESULTS.glob("*/bundle.json"))


def document(bundle, name):
    return files.document(bundle / name, files.content(bundle / name))


def information(bundle):
    return document(bundle, "bundle.json")


def of_the_report(bundle):
    """Whether a bundle is of the suites of the baseline."""
    return information(bundle)["suites"]["ids"] == information(BASELINE)["suites"]["ids"]


def timings(bundle):
    path = bundle / "timing.csv"
    if not path.exists():
        return "none"
    header, rows = files.table(path, files.content(path))
    found = [row[header.index("quality")] for _, row in rows]
    doubtful = sum(quality != "ok" for quality in found)
    return f"{len(found)}, {doubtful} of them not to be compared" if doubtful else str(len(found))


def agreement(bundle):
    """How many methods of a committed bundle agree with the baseline, as text. Ends the program where one differs."""
    found = Agreement(BASELINE, bundle)
    if found.differing:
        sys.exit("\n".join([f"{bundle.relative_to(ROOT)}: differs from {BASELINE.relative_to(ROOT)}, {found.counts()}", *found.named(),
                            "remake the bundle on a machine of its kind, or remove it"]))
    alone = {"more in the baseline": found.only_base, "only here": found.only_other}
    return ", ".join([f"{len(found.agreeing)} agree", *(f"{len(rows)} {where}" for where, rows in alone.items() if rows)])


def digest(page):
    """The baseline's digest, then a table of the bundles of its suites: where each was made and how many methods agree."""
    body = []
    for bundle in filter(of_the_report, committed_bundles()):
        machine = document(bundle, "machine.json")
        body.append([link(page, bundle), machine["build"]["compiler"], machine["system"]["libc"], machine["cpu"]["model_name"],
                     timings(bundle), agreement(bundle)])
    heads = ["bundle", "compiler", "C library", "processor", "timings", "methods in studies"]
    return f"    {information(BASELINE)['accuracy_digest']}\n\n" + table(heads, body)
