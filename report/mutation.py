# SPDX-License-Identifier: MIT
"""A bundle changed at random, as damage and malice change one. The same seed makes the same change."""

import csv
import io
import json
import os
import random
import shutil
from pathlib import Path

from .fixture import seal

# What a field, a key or a name may hold that no run writes.
WORDS = ('"><script>alert(1)</script>', "'><img src=x onerror=alert(1)>", '</p><meta http-equiv="refresh" content="0;url=//x">',
         '<form action="//x">', '<base href="//x">', "`x`<b>``", "**a", "[a](javascript:x)", "![a](//x/y.png)", "a|b", "https://x.invalid",
         r"\input{/etc/passwd}", r"$\write18{x}$", "^^5cinput", "%", "\x1b]0;x\x07\x1b[2J", "\u202eabc", "a\nb", "a\r\nb", "\u2028",
         "../../../x", "x/../../..", "/tmp/x", "-rf", "con", "a" * 300, "a" * 200_000, "{{ 7 * 7 }}", "{% raw %}", "=1+1", " ", "",
         "NaN", "nan", "inf", "-inf", "-1", "0", "1e999", "1e-999", "1e300", "0x1p-1074", "0x", "٣", "1..20", "1..9999999999", "9" * 5000)
VALUES = (None, True, -1, 0, 1e308, [], {}, [[]], {"a": {"b": []}}, "", "\x1b[2J", '<script>"', [1, "x"])


def _files(bundle, pattern="*"):
    """What another change has not made a link or without end."""
    return sorted(path for path in bundle.glob(pattern) if path.name != "SHA256SUMS" and path.is_file() and not path.is_symlink()
                  and path.stat().st_size < 1 << 30)


def _put(path, text):
    """A new file, whatever another change left there: nothing is written through a link or into a pipe."""
    path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink(missing_ok=True)
    path.write_text(text, encoding="utf-8", newline="")


def _table(rng, bundle, change):
    """Takes a table apart, lets `change(header, rows)` alter it, and writes it."""
    path = rng.choice(_files(bundle, "*.csv"))
    header, *rows = csv.reader(io.StringIO(path.read_text(encoding="utf-8"), newline=""))
    said = change(header, rows)
    out = io.StringIO(newline="")
    csv.writer(out, lineterminator="\n").writerows([header, *rows])
    _put(path, out.getvalue())
    return f"{path.name}: {said}"


def field(rng, bundle):
    """One field."""
    def change(header, rows):
        if not rows:
            return "no field"
        row, column, word = rng.randrange(len(rows)), rng.randrange(len(header)), rng.choice(WORDS)
        rows[row][column] = word
        return f"{header[column]} of row {row} is {word[:40]!r}"
    return _table(rng, bundle, change)


def column(rng, bundle):
    """All fields of a column."""
    def change(header, rows):
        at, word = rng.randrange(len(header)), rng.choice(WORDS)
        for row in rows:
            row[at] = word
        return f"{header[at]} is {word[:40]!r} everywhere"
    return _table(rng, bundle, change)


def shuffled_column(rng, bundle):
    """Values that are right elsewhere."""
    def change(header, rows):
        at = rng.randrange(len(header))
        values = [row[at] for row in rows]
        rng.shuffle(values)
        for row, value in zip(rows, values):
            row[at] = value
        return f"{header[at]} is shuffled"
    return _table(rng, bundle, change)


def dropped_column(rng, bundle):
    """A column less."""
    def change(header, rows):
        at = rng.randrange(len(header))
        for row in rows:
            del row[at]
        return f"has no {header.pop(at)}"
    return _table(rng, bundle, change)


def renamed_column(rng, bundle):
    """A header that is another's, or nobody's."""
    def change(header, rows):
        at = rng.randrange(len(header))
        old, header[at] = header[at], rng.choice((*WORDS, *header))
        return f"{old} is called {header[at][:40]!r}"
    return _table(rng, bundle, change)


def dropped_rows(rng, bundle):
    """Some rows, or all."""
    def change(header, rows):
        kept = rng.choice((0, 1, len(rows) // 2))
        rows[:] = rng.sample(rows, min(kept, len(rows)))
        return f"has {len(rows)} rows"
    return _table(rng, bundle, change)


def raw_bytes(rng, bundle):
    """Bytes put somewhere into a file."""
    path = rng.choice(_files(bundle))
    data, put = path.read_bytes(), rng.choice((b"\0", b"\xff", b'"', b"\n", b",", b"\r", b"\xef\xbb\xbf", b"[" * 100_000))
    at = rng.randint(0, len(data))
    path.write_bytes(data[:at] + put + data[at:])
    return f"{path.name}: {put[:8]!r} at {at}"


def truncated(rng, bundle):
    """The beginning of a file, which may be nothing."""
    path = rng.choice(_files(bundle))
    keep = rng.choice((0, rng.randint(0, path.stat().st_size)))
    os.truncate(path, keep)
    return f"{path.name}: {keep} bytes"


def json_value(rng, bundle):
    """A value of another type in bundle.json or machine.json."""
    path = bundle / rng.choice(("bundle.json", "machine.json"))
    try:
        whole = inner = json.loads(path.read_text(encoding="utf-8") if path in _files(bundle) else "")
        key = rng.choice(sorted(whole))
        if isinstance(whole[key], dict) and whole[key] and rng.random() < 0.7:
            inner, key = whole[key], rng.choice(sorted(whole[key]))
        inner[key] = rng.choice((*VALUES, *WORDS))
    except (OSError, ValueError, LookupError, AttributeError, TypeError):
        return f"{path.name}: as another change left it"
    _put(path, json.dumps(whole))
    return f"{path.name}: {key!r} is {str(inner[key])[:40]!r}"


def suite_text(rng, bundle):
    """Ids, titles and tables of suite.toml that no suite takes."""
    word = json.dumps(rng.choice(WORDS))
    text = rng.choice((f"[[study]]\nid = {word}\n", f'[[study]]\nid = "a"\ntitle = {word}\n', '[[study]]\nid = 1\n', "study = 1\n",
                       "suites = [1]\n", f"x = {'[' * 3000}", "a = 1979-05-27\n[[study]]\n", f'[[study]]\nid = "2.4-bezier"\ntitle = {word}\n'))
    _put(bundle / "suite.toml", text)
    return f"suite.toml: {text[:50]!r}"


def no_regular_file(rng, bundle):
    """A pipe, a device, a folder or a link where a file was; or nothing, or too much."""
    path = rng.choice(_files(bundle))
    path.unlink()
    kind = rng.choice(("pipe", "folder", "/dev/zero", "/proc/self/environ", "loop", "large", "nothing"))
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "loop":
        path.symlink_to(path.name)
    elif kind == "large":
        with open(path, "wb") as file:
            file.truncate(1 << 33)
    elif kind != "nothing":
        path.symlink_to(kind)
    return f"{path.name}: {kind}"


def foreign_file(rng, bundle):
    """A file that no run writes, code among them."""
    name = rng.choice(("extra.csv", "tomllib.py", "report.py", "matplotlibrc", "sitecustomize.py", "a b.csv", "-x.csv", ".hidden.csv"))
    _put(bundle / name, "study\nx\n")
    return f"{name} is there"


CHANGES = (field, field, field, column, column, shuffled_column, dropped_column, renamed_column, dropped_rows, raw_bytes, truncated,
           json_value, suite_text, no_regular_file, foreign_file)


def mutate(bundle, seed, sealed=True):
    """Changes the bundle where it lies, in one to three ways; with `sealed` its checksums fit what it then holds, as a stranger
    would see to. Returns what was done."""
    rng, bundle = random.Random(seed), Path(bundle)
    done = []
    for _ in range(rng.randint(1, 3)):
        change = rng.choice(CHANGES)
        try:
            done.append(change(rng, bundle))
        except (IndexError, ValueError, OSError, csv.Error):  # an earlier change left nothing to change
            done.append(f"{change.__name__}: nothing left to change")
    if sealed:
        seal(bundle)
    return "; ".join(done)


def copy_mutated(bundle, out, seed, sealed=True):
    """A changed copy of the bundle."""
    shutil.copytree(bundle, out)
    return mutate(out, seed, sealed)
