# SPDX-License-Identifier: MIT
"""What the oracles of `bezierbench curve` share: calls of the program, and the loop over all cases."""
import argparse
import csv
import itertools
import subprocess
import tempfile
from pathlib import Path

from drawn_curves import write_curve

SHOWN = 12  # mismatches printed


class Program:
    """The program under test, and the file in which it gets points."""

    def __init__(self, program, file):
        self.program, self.file = program, file

    def ask(self, command, option, points, *options):
        """(rows, standard error) of `curve COMMAND OPTION FILE OPTIONS`, FILE with `points`. Raises ValueError where it
        fails."""
        write_curve(self.file, points)
        result = subprocess.run([self.program, "curve", command, option, str(self.file), *options], capture_output=True, text=True,
                                timeout=120, check=False)
        if result.returncode != 0:
            raise ValueError(f"exit {result.returncode}: {result.stderr.strip()[:300]}")
        return list(csv.DictReader(result.stdout.splitlines())), result.stderr


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
