#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Digests of a bundle's rows, method by method, computed from its tables as the program computes them for digests.csv.

digests.py BASE OTHER    compares the accuracy of two bundles bit for bit: exits 1 where rows of BASE are missing or differ in OTHER;
                         names what only OTHER has
"""

import hashlib
import sys
from collections import Counter
from pathlib import Path
from typing import NamedTuple

sys.path.append(str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report import files, schema  # noqa: E402

NAME = "digests.csv"


class Rows(NamedTuple):
    """Some rows of a table: those of one method in one study."""

    table: str
    study: str
    method: str

    def words(self):
        """The rows as text, for a message."""
        return f"{self.table}, study {self.study}" + (f", method {self.method}" if self.method else "")


def line(fields):
    """One line of CSV, quoted only where required."""
    quoted = ['"' + field.replace('"', '""') + '"' if set(field) & set(',"\r\n') or field == "" and len(fields) == 1 else field
              for field in fields]
    return ",".join(quoted) + "\n"


def of_table(path, columns):
    """{Rows: (number of rows, digest)} of a table, in the order of their first rows; the digests are over `columns`."""
    file = path.name
    header, rows = _table(path)
    study, method = (header.index(schema.table(file).get(key, key)) for key in ("study", "method"))
    places = [header.index(column) for column in columns]
    texts, counts = {}, Counter()
    for _, row in rows:
        at = Rows(file, row[study], row[method])
        texts.setdefault(at, [line(columns)]).append(line([row[place] for place in places]))
        counts[at] += 1
    return {at: (counts[at], hashlib.sha256("".join(lines).encode()).hexdigest()) for at, lines in texts.items()}


def of_bundle(bundle):
    """The text of digests.csv for the tables of a bundle."""
    lines = [line(schema.written(NAME))]
    for file in schema.deterministic():
        if (bundle / file).exists():
            found = of_table(bundle / file, schema.digested(file))
            lines += [line([*at, str(count), digest]) for at, (count, digest) in found.items()]
    return "".join(lines)


class Agreement:
    """Which rows of two bundles agree, by the digests.csv of both."""

    def __init__(self, base, other, studies=None):
        """Compares only the rows of `studies`, if given."""
        self.agreeing, self.differing, self.only_base, self.only_other = [], [], [], []
        ours, theirs = _listed(base), _listed(other)
        for at in dict.fromkeys([*ours, *theirs]):
            if studies is None or at.study in studies:
                self._sort_in(at, ours.get(at), theirs.get(at))

    def _sort_in(self, at, ours, theirs):
        kind = self.only_base if theirs is None else self.only_other if ours is None else self.agreeing if ours == theirs else self.differing
        kind.append(at)

    def holds(self):
        """Whether the other bundle has all rows of the base, bit for bit; it may have more methods and studies."""
        return bool(self.agreeing) and not self.differing and not self.only_base

    def counts(self):
        """How many Rows agree, differ, are missing and are new, in one line."""
        kinds = {"agree": self.agreeing, "differ": self.differing, "are missing": self.only_base, "are new": self.only_other}
        return "by table, study and method: " + ", ".join(f"{len(rows)} {what}" for what, rows in kinds.items() if rows or what == "agree")

    def named(self, most=5):
        """Lines that name Rows which do not agree, at most `most` of each kind."""
        for what, rows in (("differs", self.differing), ("is missing", self.only_base), ("is new", self.only_other)):
            yield from (f"{what}: {at.words()}" for at in rows[:most])
            if len(rows) > most:
                yield f"{what}: {len(rows) - most} more"


def _listed(bundle):
    """{Rows: (number of rows, digest)} of digests.csv."""
    header, rows = _table(bundle / NAME)
    columns = [header.index(name) for name in ("table", "study", "method", "rows", "digest")]
    found = ([row[at] for at in columns] for _, row in rows)
    return {Rows(*at): (int(count), digest) for *at, count, digest in found}


def _table(path):
    return files.table(path, files.content(path))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    agreement = Agreement(*map(Path, sys.argv[1:]))
    print(agreement.counts(), *agreement.named(), sep="\n")
    sys.exit(0 if agreement.holds() else 1)
