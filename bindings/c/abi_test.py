#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""abi_test.py LIBRARY LAYOUT HEADER: the binary interface of libbezierbench.so is the recorded one.

abi.txt has the exported symbols with their versions, the sizes and members of structs and the values of constants that
programs of soname 1 were compiled with (64-bit, little-endian Linux). What stands there stays for ever; what is new is
added by --update, which refuses to drop or change a line. Every function of the header is exported.
"""
import re
import subprocess
import sys
from pathlib import Path

RECORD = Path(__file__).resolve().parent / "abi.txt"
SYMBOL = re.compile(r"^\S* *[0-9a-f]* ([A-Z]) (\S+)$")


def symbols(library):
    output = subprocess.run(["nm", "--dynamic", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    found = []
    for line in output.splitlines():
        kind, name = SYMBOL.match(line).groups()
        if kind != "A":  # the name of the version itself
            found.append(f"symbol {name}")
    return sorted(found)


def layout(program):
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()


def soname(library):
    output = subprocess.run(["readelf", "--dynamic", library], check=True, capture_output=True, text=True).stdout
    return [f"soname {name}" for name in re.findall(r"soname: \[(.+)\]", output)]


def declared(header):
    text = re.sub(r"/\*.*?\*/", "", Path(header).read_text(encoding="utf-8"), flags=re.DOTALL)
    return sorted(re.findall(r"BB_API[^;(]*?\b(bb_\w+)\(", text))


def main(arguments):
    update = "--update" in arguments
    library, program, header = [argument for argument in arguments if argument != "--update"]
    now = soname(library) + symbols(library) + layout(program)
    recorded = RECORD.read_text(encoding="utf-8").splitlines() if RECORD.exists() else []
    complaints = [f"gone or changed: {line}" for line in recorded if line not in now]
    if not update:
        complaints += [f"not recorded: {line}; abi_test.py --update adds it" for line in now if line not in recorded]
    exported = {line.split()[1].split("@")[0] for line in now if line.startswith("symbol ")}
    for name in sorted(exported ^ set(declared(header))):
        complaints.append(f"{name} is {'exported, but not declared' if name in exported else 'declared, but not exported'}")
    for complaint in complaints:
        print(f"abi: {complaint}")
    if update and not complaints:
        RECORD.write_text("\n".join(now) + "\n", encoding="utf-8")
    print(f"abi: {len(now)} lines, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
