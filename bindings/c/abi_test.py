#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""abi_test.py LIBRARY COMPILER: the binary interface of libbezierbench.so is the recorded one.

abi.txt has the exported symbols with their versions, the sizes and members of structs and the values of constants that
programs of soname 1 were compiled with (64-bit, little-endian Linux). What stands there stays for ever; what is new is
added by --update, which refuses to drop or change a line. Every function of the header is exported.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
RECORD = HERE / "abi.txt"
SYMBOL = re.compile(r"^\S* *[0-9a-f]* ([A-Z]) (\S+)$")
BLOCK = re.compile(r"typedef (struct|enum) (\w+) \{(.*?)\}", re.DOTALL)
PROGRAM = "#include <bezierbench/bezierbench.h>\n#include <stdio.h>\nint main(void) {\n%s\n}\n"


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(library):
    found = []
    for line in output("nm", "--dynamic", "--defined-only", library).splitlines():
        kind, name = SYMBOL.match(line).groups()
        if kind != "A":  # the name of the version itself
            found.append(f"symbol {name}")
    return sorted(found)


def layout(header, compiler):
    """What programs compiled with the header have built in: sizes and members of structs, values of constants."""
    structs, values = [], []
    for kind, name, body in BLOCK.findall(header):
        if kind == "enum":
            values += [f'printf("value {each} = %d\\n", (int){each});' for each in re.findall(r"\bBB_\w+", body)]
            continue
        structs.append(f'printf("struct {name} size %zu\\n", sizeof({name}));')
        for member in re.findall(r"(\w+);", body):
            numbers = f"offsetof({name}, {member}), sizeof((({name}*)0)->{member})"
            structs.append(f'printf("member {name}.{member} at %zu size %zu\\n", {numbers});')
    with tempfile.TemporaryDirectory(prefix="bezierbench-abi-") as folder:
        source, program = Path(folder) / "layout.c", Path(folder) / "layout"
        source.write_text(PROGRAM % "\n".join(structs + values), encoding="utf-8")
        output(compiler, "-x", "c", "-std=c99", f"-I{HERE / 'include'}", source, "-o", program)
        return output(program).splitlines()


def soname(library):
    return [f"soname {name}" for name in re.findall(r"soname: \[(.+)\]", output("readelf", "--dynamic", library))]


def main(arguments):
    update = "--update" in arguments
    library, compiler = [argument for argument in arguments if argument != "--update"]
    header = (HERE / "include/bezierbench/bezierbench.h").read_text(encoding="utf-8")
    header = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    now = soname(library) + symbols(library) + layout(header, compiler)
    recorded = RECORD.read_text(encoding="utf-8").splitlines() if RECORD.exists() else []
    complaints = [f"gone or changed: {line}" for line in recorded if line not in now]
    if not update:
        complaints += [f"not recorded: {line}; abi_test.py --update adds it" for line in now if line not in recorded]
    exported = {line.split()[1].split("@")[0] for line in now if line.startswith("symbol ")}
    for name in sorted(exported ^ set(re.findall(r"BB_API[^;(]*?\b(bb_\w+)\(", header))):
        complaints.append(f"{name} is {'exported, but not declared' if name in exported else 'declared, but not exported'}")
    for complaint in complaints:
        print(f"abi: {complaint}")
    if update and not complaints:
        RECORD.write_text("\n".join(now) + "\n", encoding="utf-8")
    print(f"abi: {len(now)} lines, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
