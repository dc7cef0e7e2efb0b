# SPDX-License-Identifier: MIT
"""What the oracles of `bezierbench curve` share: random and difficult curves, calls of the program, how a number is judged, and the loop
over all cases. Drawn curves are functions of a random.Random, the degree and the dimension."""
import argparse
import csv
import itertools
import math
import subprocess
import tempfile
from pathlib import Path

import exact

AXES = "xyz"
SHOWN = 12  # mismatches printed
TINY = 5e-324


def uniform(draw, n, d):
    return [[draw.uniform(-1, 1) for _ in range(d)] for _ in range(n + 1)]


def integers(draw, n, d):
    return [[float(draw.randint(-3, 3)) for _ in range(d)] for _ in range(n + 1)]


def graded(draw, n, d):
    return [[draw.uniform(-1, 1) * 2.0 ** draw.randint(-40, 40) for _ in range(d)] for _ in range(n + 1)]


def straight(draw, n, d):
    step = [float(draw.randint(-3, 3)) for _ in range(d)]
    return [[i * s for s in step] for i in range(n + 1)]


def constant(draw, n, d):
    return uniform(draw, 0, d) * (n + 1)


def mirrored(draw, n, d):
    half = uniform(draw, n // 2, d)
    whole = half + [[-p[0], *p[1:]] for p in reversed(half)]
    return whole[: n + 1] if n % 2 else whole[: n // 2] + [[0.0, *half[-1][1:]]] + whole[n // 2 + 2:]


def collinear(draw, n, d):
    """Control points in any order on a line."""
    step = [float(draw.randint(1, 3)) for _ in range(d)]
    return [[k * s for s in step] for k in (draw.randint(-8, 8) for _ in range(n + 1))]


def cusp(draw, _n, d):
    """A cubic with a cusp at t = 1/2: b_0 + b_1 = b_2 + b_3 makes its derivative 3 (D_0 + 2 D_1 + D_2) / 4 vanish."""
    b = [[float(draw.randint(-64, 64)) for _ in range(d)] for _ in range(3)]
    return [[q + r - p for p, q, r in zip(*b)], *b]


class Program:
    """The program under test, and the file in which it gets points."""

    def __init__(self, program, file):
        self.program, self.file = program, file

    def ask(self, command, option, points, *options, columns=AXES, may_fail=()):
        """(rows, standard error) of `curve COMMAND OPTION FILE OPTIONS`, FILE with every bit of `points` in these columns; no rows where it
        ends with a code of `may_fail`. Raises ValueError where it fails otherwise."""
        lines = [",".join(columns[:len(points[0])]), *(",".join(x.hex() for x in p) for p in points)]
        self.file.write_text("\n".join([*lines, ""]), encoding="ascii")
        result = subprocess.run([self.program, "curve", command, option, str(self.file), *options], capture_output=True, text=True,
                                timeout=120, check=False)
        if result.returncode in may_fail:
            return [], result.stderr
        if result.returncode != 0:
            raise ValueError(f"curve {command}: exit {result.returncode}: {result.stderr.strip()[:300]}")
        return list(csv.DictReader(result.stdout.splitlines())), result.stderr


def rows_with_keys(rows, columns, wanted):
    """The rows if they have these columns, of which the first are the wanted ones in order. Raises ValueError otherwise."""
    keys = [tuple(row.values())[:len(wanted[0])] for row in rows]
    if any(list(row) != columns for row in rows) or keys != wanted:
        raise ValueError(f"{len(rows)} rows of other columns or keys than the {len(wanted)} wanted")
    return rows


def float_of(text):
    return float.fromhex(text) if "0x" in text else float(text)


def rounds_to(a, rounded, truth_is_zero):
    """Whether `a` has the bits of `rounded`. The sign of a zero counts only where it is the result of an underflow."""
    return a == rounded and (truth_is_zero or math.copysign(1, a) == math.copysign(1, rounded))


def close(a, b):
    return a == b or abs(a - b) <= 1e-9 * abs(b) or abs(a - b) <= 4 * TINY


def judge_row(row, truth, p_tilde):
    """Yields what is wrong with the numbers of a row: the rounded truth, the errors of the value, its bound."""
    numbers = {field: float_of(row[field]) for field in ("value", "exact", "error", "error_ulp", "error_u", "bound_u") if row.get(field)}
    value, rounded = numbers["value"], exact.to_double(truth)
    right = {"exact": rounds_to(numbers["exact"], rounded, truth[0] == 0)}
    if math.isfinite(value):
        distance = exact.error(value, truth)
        error_u = exact.error_u(distance, p_tilde)
        expected = {"error": exact.to_double(distance), "error_ulp": exact.to_double(exact.error_ulp(distance, truth)),
                    "error_u": math.inf if error_u is None else exact.to_double(error_u)}
        right["error"] = numbers["error"] == expected["error"]
        right |= {field: close(numbers[field], expected[field]) for field in ("error_ulp", "error_u") if field in row}
        if "bound_u" in numbers:
            right["bound_u"] = expected["error_u"] <= numbers["bound_u"]
    else:
        expected = "infinite errors"
        right |= {field: numbers[field] == math.inf for field in ("error", "error_ulp", "error_u") if field in row}
    for field, holds in right.items():
        if not holds:
            yield f"{field} is {row[field]}; expected exact {rounded} and {expected}: {row}"


def main(description, what, least, questions):
    """Judges every (name, iterator of mismatches) that questions(program, seed) yields, and prints a summary. Returns
    the exit code: 1 for any mismatch, and if fewer than `least` were judged. `what` is the plural of what is judged."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="judge every N-th only")
    arguments = parser.parse_args()
    mismatches, judged = [], 0
    with tempfile.TemporaryDirectory() as place:
        program = Program(arguments.program, Path(place) / "points.csv")
        for name, judgement in itertools.islice(questions(program, arguments.seed), 0, None, arguments.every):
            try:
                lines = list(judgement)
                judged += 1
            except (ArithmeticError, ValueError) as error:
                lines = [str(error)]
            mismatches += [f"{name}: {line}" for line in lines]
    for line in mismatches[:SHOWN]:
        print(line)
    print(f"{judged} {what}, {len(mismatches)} mismatches")
    return 1 if mismatches or judged < least // arguments.every else 0
