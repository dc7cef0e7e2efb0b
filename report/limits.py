# SPDX-License-Identifier: MIT
"""How near times come to the least that the processor could take, and which orders of speed would hold there."""

from . import schema
from .document import Bullets, Text
from .wording import count, general, listing, percent, shortest, span

HALF = 0.5  # of the limit, which a coding must reach
SHOWN = 8  # pairs of methods that a sentence names


def limited(rows):
    """Those that have a limit; methods whose operations are not counted have none."""
    return [r for r in rows if r["limit_ns"] is not None and r["share_of_limit"] is not None]


def nearness(rows):
    """Blocks below a table of times: how near they are to their limits, which are not half as near, and which orders would hold at
    the limits. None where no time has a limit."""
    found = limited(rows)
    if not found:
        return
    modes = {}
    for row in found:
        modes.setdefault(row["mode"], []).append(row)
    without = len(rows) - len(found)
    yield Text("**Distance to the limit.**"
               + (f" {count(without, 'time has', 'times have')} no limit: not all of the work is counted." if without else ""))
    yield Bullets(tuple(_of_mode(mode, members) for mode, members in modes.items()))
    slow = _slow(found)
    yield Text("Below one half of the limit:" if slow else "None is below one half of the limit.")
    if slow:
        yield Bullets(slow)
    yield Text(_orders(found))


def _of_mode(mode, rows):
    """`point`: shares from 12 % to 95 %, one half or more at 30 of 40 times; an empty kernel takes 2 ns."""
    calls = [r.number("call_ns") for r in rows]
    shares = [r["share_of_limit"] for r in rows]
    half = sum(share >= HALF for share in shares)
    return (f"`{mode}`: shares from {share_of_limit(min(shares))} to {share_of_limit(max(shares))}, one half or more at {half} of "
            f"{count(len(rows), 'time')}; an empty kernel takes {span(min(calls), max(calls), general)} ns.")


def share_of_limit(value):
    """A share of the limit; more than all of it says little, for work that is done beside the call."""
    return percent(value) if value <= 1 else "more than 100 %"


def _slow(rows):
    """A line for each method that has such a time."""
    slow = {}
    for row in rows:
        if row["share_of_limit"] < HALF:
            slow.setdefault((row["method"], row["mode"]), []).append(row)
    names = {}
    for (method, mode), members in slow.items():
        names.setdefault(method, []).append(f"`{mode}` at {_degrees(members)}{_chain(members)}")
    return tuple(f"`{method}`: {'; '.join(places)}" for method, places in names.items())


def _degrees(rows):
    return "degree " + ", ".join(shortest(n) for n in sorted({r.number("degree") for r in rows}))


def _chain(rows):
    """The cause that the bundle knows: operations of a point that wait for each other."""
    factors = [r["chain_ns"] / r["limit_ns"] for r in rows if r["chain_ns"] and r["limit_ns"]]
    if not factors or max(factors) <= 1:
        return ""
    return f" (its chain of dependent operations takes {span(min(factors), max(factors), lambda v: general(v, 2))} times the limit)"


def _race(row):
    """What tells the races of a table apart: its keys but the method."""
    method = schema.table(row.file)["method"]
    return tuple(row[column] for column, declared in schema.columns(row.file).items() if declared.get("key") and column != method)


def orders(rows):
    """({pairs of methods: rows of both} whose order at the limits is that of the times, likewise those of which it is not), of the
    pairs of one race whose intervals are apart."""
    races, kept, turned = {}, {}, {}
    for row in limited(rows):
        races.setdefault(_race(row), []).append(row)
    for race in races.values():
        for first in race:
            for second in race:
                if first.number("high_ns") < second.number("low_ns"):
                    stands = first.number("limit_ns") < second.number("limit_ns")
                    (kept if stands else turned).setdefault((first["method"], second["method"]), []).append((first, second))
    return kept, turned


def _orders(rows):
    kept, turned = orders(rows)
    held, lost = (sum(map(len, pairs.values())) for pairs in (kept, turned))
    if not held + lost:
        return "No two methods of a race differ in time."
    if not lost:
        return f"All {count(held, 'order')} of two methods of a race would hold at the limits."
    named = [f"`{a}` before `{b}` in {count(len(found), 'race')}" for (a, b), found in
             sorted(turned.items(), key=lambda item: -len(item[1]))]
    more = f" and {count(len(named) - SHOWN, 'other pair')}" if len(named) > SHOWN else ""
    return (f"Of {count(held + lost, 'order')} of two methods of a race {held} would hold at the limits and {lost} would not: "
            f"{listing(named[:SHOWN]) if not more else ', '.join(named[:SHOWN])}{more}.")


def reading_limits(rows):
    """What the words mean; None where no time has a limit."""
    if not limited(rows):
        return None
    return Text("The limit of a time (`limit_ns` of the file) is the least that this processor could take for the operations of the "
                "method, counted by kind on its own code, at the speeds of these kinds measured in the same run: with the axes of one "
                "point in one vector, in `batch` with a point in every lane, in `latency` along the longest chain of operations. Loads, "
                "stores and branches count as nothing. A share of the limit is the limit over what is left of the time without that of "
                "an empty kernel (`call_ns`), which ran in the same race.")


def reading_load(bundle):
    """The load of the machine before the run; None where the bundle does not say it."""
    machine = bundle.machine if isinstance(bundle.machine, dict) else {}
    load, cpu = machine.get("load_average"), machine.get("cpu")
    cores = cpu.get("logical_cores_available") if isinstance(cpu, dict) else None
    if not isinstance(load, list) or len(load) != 3 or not all(isinstance(v, (int, float)) for v in load):
        return None
    return Text(f"Load of the machine when the run began, over 1, 5 and 15 minutes: {listing(general(v) for v in load)}"
                + (f", on {count(cores, 'processor')}." if isinstance(cores, int) else "."))
