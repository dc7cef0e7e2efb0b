#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Bundles as an enemy or a bad disk would leave them, for checks of whatever reads bundles: the program, the package bezierbench,
and the report.

hostile_bundle.py BUNDLE OUT --seed N    copies BUNDLE to OUT and changes the copy. The same seed makes the same change; standard
                                         output says which files changed, and whether the checksums fit them

`damaged(folder, chance)` changes a bundle in place.
"""
import argparse
import csv
import hashlib
import io
import json
import os
import random
import re
import shutil
import socket
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report import schema  # noqa: E402
from scripts import digests  # noqa: E402

# What a field, a value or a piece of a file may be replaced by.
NASTY = [b"", b"nan", b"-inf", b"1e999", b"-1", b"0", b"9223372036854775808", b"18446744073709551616", b"1e308", b"0x1p-1074",
         b"true", b"null", b"[]", b"{}", b"\"", b"'", b"`", b"$(touch outside/x)", b"../../outside/kept", b"/etc/passwd",
         b"a/../../../outside/kept", b"\x1b]0;title\x07\x1b[31m", b"\r", b"\n", b"\0", b"\xff\xfe", b"<script>alert(1)</script>",
         b"\\input{/etc/passwd}", b"%s%n", b"=1+1", b",", b"," * 1000, b"[" * 5000, b"(" * 5000, b"A" * 200000, b"0x1p+0 " * 20000]
# And a field of a table, or a text that is shown: markup, and numbers that a reader may take for others.
WORDS = [word.decode(errors="replace") for word in NASTY] + [
    '"><script>alert(1)</script>', "'><img src=x onerror=alert(1)>", '</p><meta http-equiv="refresh" content="0;url=//x">', "`x`<b>``",
    "**a", "[a](javascript:x)", "![a](//x/y.png)", "a|b", "https://x.invalid", r"$\write18{x}$", "^^5cinput", "\u202eabc", "a\r\nb", "\u2028",
    "x/../../..", "-rf", "{{ 7 * 7 }}", "{% raw %}", " ", "1e-999", "1e300", "0x", "1_0", "٣", "1..20", "1..9999999999", "9" * 5000]
MANIFEST, SUMS = "bundle.json", "SHA256SUMS"


def deterministic(names):
    return [name for name in names if name in schema.deterministic()]


def digest(data):
    return hashlib.sha256(data).hexdigest()


def is_plain(path):
    return path.is_file() and not path.is_symlink() and path.stat().st_size < 10**8


def sign(folder):
    """Makes the checksums those of what is there, as whoever changes a bundle on purpose can."""
    names = sorted(path.name for path in folder.iterdir() if is_plain(path) and path.name != SUMS and not path.name.startswith("."))
    if digests.NAME in names and all(is_plain(folder / name) for name in deterministic(os.listdir(folder))):
        try:
            (folder / digests.NAME).write_text(digests.of_bundle(folder))
        except (ValueError, LookupError, StopIteration, csv.Error):
            pass  # a table that cannot be read
    lines = {name: f"{digest((folder / name).read_bytes())}  {name}\n" for name in names if "\n" not in name}
    manifest = folder / MANIFEST
    if is_plain(manifest):
        whole = digest((folder / digests.NAME).read_bytes()) if digests.NAME in names else digest(b"")
        text = re.sub(rb'("accuracy_digest": ")[0-9a-f]{64}', rb"\g<1>" + whole.encode(), manifest.read_bytes())
        if is_plain(folder / "suite.toml"):
            suite = digest((folder / "suite.toml").read_bytes())
            text = re.sub(rb'("digest": ")[0-9a-f]{64}', rb"\g<1>" + suite.encode(), text)
        manifest.write_bytes(text)
        lines[MANIFEST] = f"{digest(text)}  {MANIFEST}\n"
    if is_plain(folder / SUMS):
        (folder / SUMS).write_text("".join(lines[name] for name in sorted(lines)))


def changed_bytes(data, chance):
    at = chance.randrange(len(data) + 1)
    length = chance.choice([0, 1, 1, 3, 40, len(data)])
    return data[:at] + chance.choice([chance.choice(NASTY), data[at:at + 30] * 2, bytes(at % 7)]) + data[at + length:]


def changed_field(data, chance):
    """One field of a table, or one value of a text, becomes another."""
    pieces = re.split(rb"([,\n:= ])", data)
    at = chance.randrange(len(pieces))
    pieces[at] = chance.choice([*NASTY, chance.choice(pieces)])
    return b"".join(pieces)


def changed_lines(data, chance):
    lines = data.splitlines(keepends=True)
    if not lines:
        return data + b"x"
    at = chance.randrange(len(lines))
    line = lines[at]
    lines[at:at + 1] = chance.choice([[], [line] * 2, [line] * 1000, [b"\n"], [chance.choice(lines)]])
    return b"".join(lines)


def changed_json(data, chance):
    """One key gone, doubled under another name, or with another value."""
    try:
        value = json.loads(data)
    except ValueError:
        return changed_bytes(data, chance)
    holder = value
    while True:
        key = chance.choice(list(holder))
        if not isinstance(holder[key], dict) or not holder[key] or chance.random() < 0.2:
            break
        holder = holder[key]
    how = chance.randrange(3)
    if how == 0:
        del holder[key]
    else:
        holder[key if how == 1 else f"{key}_"] = chance.choice([None, True, -1, 1e300, 2**70, "", "\x1b[2J", [], {}, [[]] * 3, "../x"])
    return json.dumps(value).encode()


def changed_table(data, chance):
    """A field, a column, the header or the rows of a table become others, and the file remains CSV."""
    try:
        header, *rows = csv.reader(io.StringIO(data.decode(), newline=""), strict=True)
        at = chance.randrange(len(header))
        fields = [row[at] for row in rows]
    except (ValueError, IndexError, csv.Error):  # an earlier change left no table
        return changed_bytes(data, chance)
    how, word = chance.randrange(7), chance.choice(WORDS)
    if how < 2 and rows:
        fields[chance.randrange(len(rows))] = word
    elif how == 2:
        fields = [word] * len(rows)
    elif how == 3:
        chance.shuffle(fields)  # values that are right elsewhere
    elif how == 4:
        header[at] = chance.choice([word, *header])
    rows = [[*row[:at], field, *row[at + 1:]] for row, field in zip(rows, fields)]
    if how == 5:
        header, rows = ([line[:at] + line[at + 1:] for line in part] for part in ([header], rows))
        header = header[0]
    elif how == 6:
        rows = chance.sample(rows, min(len(rows), chance.choice([0, 1, len(rows) // 2])))
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator="\n").writerows([header, *rows])
    return out.getvalue().encode()


def changed_suite(_data, chance):
    """Ids, titles and tables of suite.toml that no suite takes."""
    word = json.dumps(chance.choice(WORDS))
    return chance.choice([f"[[study]]\nid = {word}\n", f'[[study]]\nid = "a"\ntitle = {word}\n', "[[study]]\nid = 1\n", "study = 1\n",
                          "suites = [1]\n", f"x = {'[' * 3000}", "a = 1979-05-27\n[[study]]\n"]).encode(errors="replace")


def change_content(path, chance):
    changes = [changed_bytes, changed_field, changed_lines] + [{".json": changed_json, ".csv": changed_table, ".toml": changed_suite}.get(
        path.suffix, changed_bytes)] * 3
    path.write_bytes(chance.choice(changes)(path.read_bytes(), chance))


def replace_by_something_else(path, chance):
    """A link, a pipe, a socket, a folder or a huge file in its place; what links lead to lies in `outside`."""
    outside = path.parent.parent / "outside"
    path.unlink(missing_ok=True)
    how = chance.randrange(8)
    if how == 0:
        path.symlink_to(outside / path.name)  # a copy of the very file, so that only following the link gives it away
    elif how == 1:
        path.symlink_to("/dev/zero")
    elif how == 2:
        path.symlink_to(outside / "not-there")
    elif how == 3:
        os.mkfifo(path)
    elif how == 4:
        path.mkdir()
    elif how == 5:
        with open(path, "wb") as file:
            file.truncate(chance.choice([2**30 + 1, 2**43]))
    elif how == 6:
        with socket.socket(socket.AF_UNIX) as one:
            here = os.getcwd()
            os.chdir(path.parent)  # names of sockets are short
            try:
                one.bind(path.name[:80])
            finally:
                os.chdir(here)


def add_something(folder, chance):
    outside = folder.parent / "outside"
    how = chance.randrange(5)
    if how == 0:
        name = chance.choice(["conversion.csv", "fitting.csv", "spacing.csv", "other.csv", "tomllib.py", "report.py", "sitecustomize.py"])
        (folder / name).unlink(missing_ok=True)
        (folder / name).write_bytes(chance.choice([b"study\nx\n", b"raise SystemExit(0)\n", b"\0"]))
    elif how == 1:
        (folder / "\x1b[31mred\n.csv").write_bytes(b"a\n")
    elif how == 2:
        (folder / "conversion.csv").unlink(missing_ok=True)
        (folder / "conversion.csv").symlink_to(outside / "kept")
    elif how == 3:
        if not (folder / "blocks").is_symlink():
            shutil.rmtree(folder / "blocks", ignore_errors=True)
            (folder / "blocks").symlink_to(outside / "folder")
    elif not (folder / "blocks").is_symlink():
        (folder / "blocks").mkdir(exist_ok=True)
        lock = folder / "blocks" / chance.choice(["run.lock", "bundle.lock", "whole.000001.blocks"])
        lock.unlink(missing_ok=True)
        chance.choice([lambda: os.mkfifo(lock), lambda: lock.symlink_to(outside / "made"), lambda: lock.symlink_to("/dev/zero")])()


def damaged(folder, chance):
    """Damages the bundle; the names of the files whose content is another one, and whether the checksums say so still."""
    before = {path.name: path.read_bytes() for path in folder.iterdir() if is_plain(path)}
    for _ in range(chance.choice([1, 1, 1, 2, 4])):
        how = chance.random()
        files = [path for path in sorted(folder.rglob("*")) if is_plain(path) and path.suffix != ".lock"]
        if how < 0.65:
            change_content(chance.choice(files), chance)
        elif how < 0.75:
            chance.choice(files).unlink()
        elif how < 0.9:
            replace_by_something_else(chance.choice(files), chance)
        else:
            add_something(folder, chance)
    signed = chance.random() < 0.5
    if signed:
        sign(folder)
    after = {path.name: path.read_bytes() for path in folder.iterdir() if is_plain(path)}
    return {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)}, signed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bundle", metavar="BUNDLE", type=Path)
    parser.add_argument("out", metavar="OUT", type=Path)
    parser.add_argument("--seed", type=int, required=True)
    chosen = parser.parse_args()
    shutil.copytree(chosen.bundle, chosen.out)
    changed, signed = damaged(chosen.out, random.Random(chosen.seed))
    print(ascii(sorted(changed)), "with fitting checksums" if signed else "with the checksums of before")


if __name__ == "__main__":
    main()
