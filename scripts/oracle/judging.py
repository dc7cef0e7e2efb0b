# SPDX-License-Identifier: MIT
"""What oracles of `bezierbench curve` have in common: how the program is asked, and the loop over the questions."""
import argparse
import csv
import subprocess
import tempfile
from pathlib import Path

from drawn_curves import write_curve

SHOWN = 12  # mismatches printed


class Program:
    """PROGRAM, which is asked about one file of points after the other."""

    def __init__(self, program, file):
        self.program, self.file = program, file

    def ask(self, command, option, points, *options):
        """(rows, standard error) of `curve COMMAND OPTION file-of-the-points OPTIONS`. ValueError where it fails."""
        write_curve(self.file, points)
        result = subprocess.run([self.program, "curve", command, option, str(self.file), *options], capture_output=True, text=True,
                                timeout=120, check=False)
        if result.returncode != 0:
            raise ValueError(f"exit {result.returncode}: {result.stderr.strip()[:300]}")
        return list(csv.DictReader(result.stdout.splitlines())), result.stderr


def main(description, what, least, questions):
    """Goes through (name, iterator of mismatches) of questions(program, seed): 1, to exit with, where there is a mismatch
    or fewer than `least` questions were answered; `what` is their word."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    mismatches, judged = [], 0
    with tempfile.TemporaryDirectory() as place:
        for name, judgement in questions(Program(arguments.program, Path(place) / "points.csv"), arguments.seed):
            try:
                lines = list(judgement)
                judged += 1
            except (ArithmeticError, ValueError) as error:
                lines = [str(error)]
            mismatches += [f"{name}: {line}" for line in lines]
    for line in mismatches[:SHOWN]:
        print(line)
    print(f"{judged} {what}, {len(mismatches)} mismatches")
    return 1 if mismatches or judged < least else 0
