# SPDX-License-Identifier: MIT
"""The printed times of table 2.4 beside those of what the report describes, compiled with and without optimisation.

Only times of one build are compared with each other: the order of the methods, and their ratios where the clock of the report, of whole
milliseconds, leaves any: a reading of k ms is of a time between k - 1 and k + 1.
"""
import csv

from report.findings.conclusions import ORDERS
from report.wording import general, listing
from scripts.pages.markdown import ROOT, table

FILE = ROOT / "results/printed_times.csv"
PRINTED = ROOT / "reference/published/report_tables.csv"
FORMS = {"bernstein": "Bézier", "power": "power"}


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(rows):
    with open(FILE, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def printed():
    """{(curve, degree): {method: ms}} of table 2.4."""
    found = {}
    for row in rows_of(PRINTED):
        if row["table"] == "2.4":
            found.setdefault((row["form"], int(row["degree"])), {})[row["path"]] = float(row["value"])
    return found


def builds(rows):
    """{options: {(curve, degree): {method: ms}}}"""
    found = {}
    for row in rows:
        found.setdefault(row["options"], {}).setdefault((row["form"], int(row["degree"])), {})[row["method"]] = float(row["ms"])
    return found


def in_order(curve, times):
    """Whether the order of speed that the report concludes holds, of one form and degree."""
    order = ORDERS[curve]
    return all(times[a] < times[b] for a, b in zip(order, order[1:]))


def least_factor(curve, times, read):
    """The least factor between a ratio of two of our times and one that the clock may have read, over the pairs that are printed with
    different times: 1 where each ratio may have been read."""
    factor = 1.0
    for a in ORDERS[curve]:
        for b in ORDERS[curve]:
            if read[a] < read[b]:
                low, high = (read[b] - 1) / (read[a] + 1), (read[b] + 1) / (read[a] - 1) if read[a] > 1 else float("inf")
                ratio = times[b] / times[a]
                factor = max(factor, low / ratio, ratio / high)
    return factor


def kept(rows):
    """{options: (rows of methods whose order holds, rows of methods)}"""
    return {options: (sum(in_order(curve, times) for (curve, _), times in cells.items()), len(cells))
            for options, cells in builds(rows).items()}


def orders(rows):
    """A sentence: in how many rows of methods the order holds in which build."""
    return ("The report's order of speed holds in "
            + listing(f"{held} of {of} rows with {options}" for options, (held, of) in kept(rows).items())
            + " of what it describes")


def table_of(rows):
    """A table with a line for each form and degree: printed and our times in the report's order, and what holds."""
    read, ours = printed(), builds(rows)
    head = ["form", "n", "printed, ms", *(words for options in ours for words in (f"`{options}`, ms", "order, ratios within"))]
    body = []
    for (curve, degree), times in read.items():
        line = [FORMS[curve], degree, " : ".join(f"{times[method]:g}" for method in ORDERS[curve])]
        for cells in ours.values():
            here = cells[curve, degree]
            line += [" : ".join(general(here[method], 2) for method in ORDERS[curve]),
                     f"{'holds' if in_order(curve, here) else 'differs'}, {general(least_factor(curve, here, times), 2)}"]
        body.append(line)
    return table(head, body)
