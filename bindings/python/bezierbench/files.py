# SPDX-License-Identifier: MIT
"""The files of a bundle: bytes, checksums, JSON, CSV and numbers, or one line about what is wrong with them.

Everything in Python that reads a bundle reads it through here. The module needs the standard library alone, so that `report` can
read bundles where neither NumPy nor libbezierbench is installed.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

# An installed package has no tables.schema.json, which states both; a test compares them.
SCHEMA = 3
LAST_READER = "8a3acbc696b0"  # the last commit that reads bundles of earlier versions
SUMS = "SHA256SUMS"
_LONGEST_FIELD = 1 << 26  # bytes; a field of coefficients of degree 1023 has some 80,000
_SHOWN = 60  # characters of a file that a message repeats
_SUMS_LINE = re.compile(r"([0-9a-f]{64})  ([A-Za-z0-9][A-Za-z0-9._-]*)")
_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?inf|nan", re.ASCII)
_HEX = re.compile(r"[+-]?0[xX][0-9a-fA-F]*\.?[0-9a-fA-F]*([pP][+-]?\d+)?", re.ASCII)


class BundleError(ValueError):
    """A directory that is not a bundle, or not as it was written; the message names the file and says what to do."""


class NoFile(BundleError):
    """The file is not there."""


def content(file: Path) -> bytes:
    """The bytes of a regular file. A pipe would be waited for, a device has no end, and a link may lead to what the reader of the bundle
    can see and its writer cannot."""
    try:
        if file.is_symlink():
            raise BundleError(f"{file}: is a link, which is not followed; put the file itself there")
        if file.exists() and not file.is_file():
            raise BundleError(f"{file}: is not a regular file; put the file that was written there")
        return file.read_bytes()
    except FileNotFoundError:
        raise NoFile(f"{file}: missing; give the directory that `bezierbench run` wrote") from None
    except (OSError, ValueError) as error:  # ValueError for a name with a null character
        what = error.strerror if isinstance(error, OSError) else error
        raise BundleError(f"{file}: cannot be read: {what}; check that it is a readable file") from None


def text(file: Path, data: bytes) -> str:
    """The bytes of a file as UTF-8."""
    try:
        found = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise _bad(file, f"byte {error.start} is not UTF-8") from None
    if "\0" in found:
        raise _bad(file, "holds a NUL byte")
    return found


def checksums(file: Path, data: bytes) -> dict[str, str]:
    """{file name: digest} of SHA256SUMS."""
    sums: dict[str, str] = {}
    for number, line in enumerate(text(file, data).removesuffix("\n").split("\n"), 1):
        found = _SUMS_LINE.fullmatch(line)
        if not found:
            raise _bad(file, "is not a line of sha256sum about a file of a bundle", number)
        if found[2] in sums:
            raise _bad(file, "lists a file twice", number)
        sums[found[2]] = found[1]
    return sums


def fits(digest: str, data: bytes) -> bool:
    """Whether these bytes have the digest that SHA256SUMS lists."""
    return hashlib.sha256(data).hexdigest() == digest


def document(file: Path, data: bytes) -> dict[str, Any]:
    """The object of a JSON file."""
    try:
        value = json.loads(text(file, data))
    except json.JSONDecodeError as error:
        raise _bad(file, f"is not JSON: {error.msg}", f"{error.lineno}:{error.colno}") from None
    except BundleError:
        raise
    except (ValueError, RecursionError):  # a number of thousands of digits, brackets thousands deep
        raise _bad(file, "has a number that is too long, or is nested too deeply") from None
    if not isinstance(value, dict):
        raise _bad(file, "is not a JSON object")
    return value


def check_version(file: Path, info: dict[str, Any]) -> None:
    """Refuses bundle.json of a schema version that this program does not read."""
    version = info.get("schema_version")
    if type(version) is not int or not 1 <= version <= SCHEMA:
        raise BundleError(f"{file}: schema_version is {shown(repr(version))} instead of {SCHEMA}; use a newer bezierbench")
    if version < SCHEMA:
        raise BundleError(f"{file}: schema_version is {version}, and this program reads {SCHEMA}; run the suite again, or "
                          f"read the bundle with commit {LAST_READER}, the last that does")


def table(file: Path, data: bytes) -> tuple[list[str], Iterator[tuple[int, list[str]]]]:
    """The columns of a CSV file, and its rows with the number of the line on which each ends."""
    rows = _rows(file, text(file, data))
    _, header = next(rows, (1, []))
    if not header:
        raise _bad(file, "empty, a header line was expected", 1)
    if len(set(header)) != len(header):
        raise _bad(file, "a column stands twice in the header", 1)
    return header, rows


def _rows(file: Path, whole: str) -> Iterator[tuple[int, list[str]]]:
    # Lines end at \n only, as they were written; splitlines() would cut at U+2028, too.
    reader = csv.reader(io.StringIO(whole, newline=""), strict=True)
    limit = csv.field_size_limit(_LONGEST_FIELD)
    columns = None
    try:
        for fields in reader:
            if columns is not None and len(fields) != columns:
                raise _bad(file, f"{len(fields)} fields where the header has {columns}", reader.line_num)
            columns = len(fields)
            yield reader.line_num, fields
    except csv.Error as error:
        raise _bad(file, f"is not CSV: {error}", reader.line_num) from None
    finally:
        csv.field_size_limit(limit)


def number(field: str) -> float | None:
    """A number in decimal or in the hexadecimal notation of C; None where the field is neither."""
    if _DECIMAL.fullmatch(field):
        return float(field)
    if not _HEX.fullmatch(field):
        return None
    try:
        return float.fromhex(field)
    except (ValueError, OverflowError):  # 0x1p99999
        return None


def shown(field: str) -> str:
    """The beginning of a field, as a message repeats it."""
    return field if len(field) <= _SHOWN else f"{field[:_SHOWN]}…"


def _bad(file: Path, what: str, line: int | str | None = None) -> BundleError:
    return BundleError(f"{file}{'' if line is None else f':{line}'}: {what}; run `bezierbench verify` on the bundle, and restore the file")
