# SPDX-License-Identifier: MIT
"""Cycles that llvm-mca predicts for processors that are not here, beside the times of this machine."""

from statistics import correlation, median

from . import schema
from .document import Bullets, Text
from .wording import count, factor, general, shortest

FEWEST = 5  # kernels, from which on a rank correlation says something


def pairs(rows, counted):
    """[(row of timing.csv, row of cost.csv)] about the same kernel and inputs."""
    same = [name for name, declared in schema.columns("cost.csv").items() if declared.get("key") and name != "target"] + ["method"]
    costs = {tuple(row[c] for c in same): row for row in counted}
    return [(row, costs[key]) for row in rows if (key := tuple(row[c] for c in same)) in costs]


def rank_correlation(first, second):
    """Spearman's coefficient. None where either does not vary."""
    if min(len(set(first)), len(set(second))) < 2:
        return None
    return correlation(*([sum(other < value for other in values) + sum(other == value for other in values) / 2 for value in values]
                         for values in (first, second)))


def worst_miss(found, cycles):
    """(row of timing.csv, how many times the median of all nanoseconds of a cycle its own is), where that is furthest from 1."""
    of_cycle = [row["median_ns"] / cost[cycles] for row, cost in found]
    misses = [ns / median(of_cycle) for ns in of_cycle]
    furthest = max(range(len(found)), key=lambda k: max(misses[k], 1 / misses[k]))
    return found[furthest][0], misses[furthest]


def processors():
    """Their ids in the columns of cost.csv."""
    return [name.removeprefix("cycles_") for name in schema.columns("cost.csv") if name.startswith("cycles_")]


def column(processor, mode):
    """Where each t depends on the last point, the latency counts, else the reciprocal throughput."""
    return f"{'latency' if mode == 'latency' else 'cycles'}_{processor}"


def predictions(bundle, rows):
    """How well the cycles rank the times of these rows, by mode; nothing where the bundle does not have both."""
    found = pairs(rows, bundle["cost.csv"].rows) if "cost.csv" in bundle else []
    lines = [line for mode in dict.fromkeys(row["mode"] for row, _ in found) for name in processors()
             if (line := _line(mode, column(name, mode), [pair for pair in found if pair[0]["mode"] == mode]))]
    if lines:
        yield Text("**Cycles of other processors.** `cost.csv` has the cycles of a point that llvm-mca predicts from the machine code of the same "
                   "kernels. It leaves out caches, mispredicted branches, the fetching of instructions and what lies between two blocks of code, "
                   "and lanes are those of AVX2, whatever was timed. The coefficients are Spearman's, of the cycles and the times of this machine. "
                   "A miss is the time of a kernel over its cycles, as a multiple of the median of all kernels of the mode.")
        yield Bullets(tuple(lines))


def _line(mode, cycles, found):
    """`point`: `cycles_zen4` ranks 48 kernels as their times do with coefficient 0.98; the worst miss is `direct` at degree 5, 2.3 times."""
    known = [(row, cost) for row, cost in found if cost[cycles]]
    coefficient = rank_correlation([cost[cycles] for _, cost in known], [row["median_ns"] for row, _ in known]) if len(known) >= FEWEST else None
    if coefficient is None:
        return None
    row, miss = worst_miss(known, cycles)
    without = f", without {count(len(found) - len(known), 'unpredicted one')}" if len(found) > len(known) else ""
    return (f"`{mode}`: coefficient of `{cycles}` {general(coefficient, 3)} over {count(len(known), 'kernel')}{without}; the worst miss is "
            f"`{row['method']}` at degree {shortest(row['degree'])}, {factor(miss)} times.")
