#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Compares the accuracy of two bundles bit for bit, by table, study and method.

agreement.py BASE OTHER    exits 1 where rows of BASE are missing or differ in OTHER; names what only OTHER has

The digests are computed from the tables, over the digested columns that both have, so that bundles of any two schema
versions can be compared.
"""
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts.digests import Agreement  # noqa: E402

if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    agreement = Agreement(*map(Path, sys.argv[1:]))
    print(agreement.counts(), *agreement.named(), sep="\n")
    sys.exit(0 if agreement.holds() else 1)
