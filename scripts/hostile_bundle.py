#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Copies a bundle and changes the copy as damage or malice would, for checks of programs that read bundles.

hostile_bundle.py BUNDLE OUT --seed N [--stale-sums]

The same seed makes the same change; standard output says which. The checksums fit the changed files, as a stranger
would make them; with --stale-sums they remain those of BUNDLE.
"""
import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.mutation import copy_mutated  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bundle", metavar="BUNDLE", type=Path)
    parser.add_argument("out", metavar="OUT", type=Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--stale-sums", action="store_true")
    chosen = parser.parse_args()
    print(copy_mutated(chosen.bundle, chosen.out, chosen.seed, sealed=not chosen.stale_sums).encode("unicode_escape").decode())


if __name__ == "__main__":
    main()
