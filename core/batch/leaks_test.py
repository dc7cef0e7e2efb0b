#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is compiled for one target must not be called on a lesser processor. Of an inline function that several
translation units share the linker keeps one copy, perhaps the one with instructions that this processor does not have;
so the objects of a target may define only names that contain the target's, or that no other unit defines.

leaks_test.py NM OBJECT...    prints one line per name that leaks and exits 1 if there is any.
"""
import re
import subprocess
import sys

OWN_NAMESPACE = re.compile(r"\bN_[A-Z0-9_]+::")  # Highway's name of a target
TABLE = re.compile(r"^bezierbench::batch::(Unit|Groups|Table|Works)Of<.*>::table$")  # data, one per target
NUMBERS = re.compile(r"^bezierbench::detail::binomial_table<")  # computed by the compiler, the same for every target
COMPILERS_OWN = re.compile(r"^(DW\.ref\.|__asan|__odr_asan|__ubsan|\.L)")


def shared_names(symbols):
    """Those of the lines `address kind name` of nm that other translation units see."""
    for line in symbols.splitlines():
        kind, name = re.fullmatch(r"[0-9a-f]* *(\S) (.*)", line).groups()
        if kind.isupper() or kind in "uvw":
            yield name


def leaks(names):
    return [n for n in names if not any(pattern.search(n) for pattern in (OWN_NAMESPACE, TABLE, NUMBERS, COMPILERS_OWN))]


def main():
    nm, *objects = sys.argv[1:]
    found = 0 if objects else 1
    for path in objects:
        listing = subprocess.run([nm, "-C", "--defined-only", path], check=True, capture_output=True, text=True).stdout
        names = list(shared_names(listing))
        if not any(TABLE.search(name) for name in names):
            sys.exit(f"{path}: no table; this is not the object of a target")
        for name in leaks(names):
            print(f"{path}: {name} may replace that of another translation unit; put it into the target's namespace")
            found += 1
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
