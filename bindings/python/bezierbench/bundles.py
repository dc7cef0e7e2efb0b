# SPDX-License-Identifier: MIT
"""Bundles of `bezierbench run` as tables: DataFrames where pandas is installed, else arrays by the name of the column."""

from __future__ import annotations

import csv
import hashlib
import importlib
import io
import json
import math
import os
import re
import stat
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ._arrays import Array

NEWEST_SCHEMA = 2
_TEXT = {"coefficients", "weights"}  # several numbers in one field: see numbers()
_LARGEST = 1 << 30  # bytes of a file
_LONGEST_FIELD = 1 << 26  # bytes; a field of coefficients of degree 1023 has some 80,000
_WHOLE = re.compile(r"-?[0-9]{1,19}", re.ASCII)
_SUMS_LINE = re.compile(r"([0-9a-f]{64})  ([A-Za-z0-9][A-Za-z0-9._-]*)")


class BundleError(ValueError):
    """A directory that is not a bundle, or not as it was written; the message names the file and says what to do."""


class Bundle(Mapping[str, Any]):
    """The tables of a bundle by name: `bundle["accuracy"]`. `info` is bundle.json, `machine` is machine.json."""

    def __init__(self, path: Path, info: dict[str, Any], machine: dict[str, Any], tables: dict[str, Any]) -> None:
        self.path, self.info, self.machine, self._tables = path, info, machine, tables

    def __getitem__(self, name: str) -> Any:
        return self._tables[name.removesuffix(".csv")]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)

    def __repr__(self) -> str:
        return f"<bundle {self.path}: {', '.join(self._tables)}>"


def read(bundle: str | Path, *, frames: bool | None = None) -> Bundle:
    """Reads a bundle and holds every file to its checksum.

    A table is a pandas DataFrame, where pandas can be imported or `frames` is True; otherwise a dictionary of NumPy arrays.
    Columns of numbers, decimal or hexadecimal, become float64, or int64 where all are integers; an empty field is NaN. Other
    columns are text. Raises BundleError, which names the file, for whatever is wrong with a bundle: a directory that is not one,
    a run that is not complete, a file that is missing, changed, malformed, larger than 1 GiB or not a regular file. No link is
    followed. `bezierbench verify` says more.
    """
    path = Path(bundle)
    sums = _sums(path)
    files = {name: _checked(path, name, digest) for name, digest in sums.items()}
    info = _json(path, "bundle.json", files)
    schema = info.get("schema_version")
    if type(schema) is not int or not 1 <= schema <= NEWEST_SCHEMA:
        raise BundleError(f"{path / 'bundle.json'}: schema_version is {schema!r:.20} instead of 1 to {NEWEST_SCHEMA}; use a newer "
                          "bezierbench")
    if info.get("state") != "complete":
        raise BundleError(f"{path / 'bundle.json'}: the run is not complete; continue it with `bezierbench run`")
    machine = _json(path, "machine.json", files)
    make = _maker(frames)
    tables = {name.removesuffix(".csv"): make(_columns(path / name, _text(path / name, data)))
              for name, data in sorted(files.items()) if name.endswith(".csv")}
    return Bundle(path, info, machine, tables)


def numbers(field: str) -> Array:
    """The numbers in a field such as `coefficients` of the table `worst`, decimal or hexadecimal."""
    return np.array([_number(word) for word in field.split()], dtype=np.float64)


def _bytes(path: Path) -> bytes:
    """The bytes of a regular file. A pipe would be waited for, a device has no end, and a link may lead anywhere."""
    try:
        # O_NONBLOCK: opening a pipe to which nobody writes returns at once.
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        with open(handle, "rb") as file:
            if not stat.S_ISREG(os.fstat(handle).st_mode):
                raise BundleError(f"{path}: is not a regular file; put the file that was written there")
            data = file.read(_LARGEST + 1)
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name, or a BundleError
        if isinstance(error, BundleError):
            raise
        raise BundleError(f"{path}: cannot be read: {getattr(error, 'strerror', error)}; give the directory that `bezierbench run` "
                          "wrote") from None
    if len(data) > _LARGEST:
        raise BundleError(f"{path}: is larger than {_LARGEST >> 30} GiB; run fewer studies into one bundle")
    return data


def _text(file: Path, data: bytes) -> str:
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise BundleError(f"{file}: byte {error.start} is not UTF-8; restore the file") from None
    if "\0" in text:
        raise BundleError(f"{file}: holds a NUL byte; restore the file")
    return text


def _sums(path: Path) -> dict[str, str]:
    file = path / "SHA256SUMS"
    sums: dict[str, str] = {}
    for number, line in enumerate(_text(file, _bytes(file)).removesuffix("\n").split("\n"), 1):
        found = _SUMS_LINE.fullmatch(line)
        if not found or found[2] in sums:
            raise BundleError(f"{file}:{number}: is not a line of sha256sum, or lists a file twice; restore the file")
        sums[found[2]] = found[1]
    return sums


def _checked(path: Path, name: str, digest: str) -> bytes:
    data = _bytes(path / name)
    if hashlib.sha256(data).hexdigest() != digest:
        raise BundleError(f"{path / name}: is not what SHA256SUMS lists; run `bezierbench verify` on the bundle")
    return data


def _json(path: Path, name: str, files: dict[str, bytes]) -> dict[str, Any]:
    if name not in files:
        raise BundleError(f"{path / name}: is not in SHA256SUMS; restore the bundle")
    try:
        value = json.loads(_text(path / name, files[name]))
    except BundleError:
        raise
    except (ValueError, RecursionError) as error:  # a number of thousands of digits, brackets thousands deep
        raise BundleError(f"{path / name}: is not JSON ({str(error)[:80]}); restore the file") from None
    if not isinstance(value, dict):
        raise BundleError(f"{path / name}: is not a JSON object; restore the file")
    return value


def _columns(file: Path, text: str) -> dict[str, Array]:
    limit = csv.field_size_limit(_LONGEST_FIELD)
    try:
        # Lines end at \n only, as they were written; splitlines() would cut at U+2028, too.
        rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    except csv.Error as error:
        raise BundleError(f"{file}: is not CSV ({error}); restore the file") from None
    finally:
        csv.field_size_limit(limit)
    if not rows or any(len(row) != len(rows[0]) for row in rows) or len(set(rows[0])) != len(rows[0]):
        raise BundleError(f"{file}: has rows of different lengths, or a column twice; restore the file")
    return {name: _column(name, [row[k] for row in rows[1:]]) for k, name in enumerate(rows[0])}


def _column(name: str, fields: list[str]) -> Array:
    if name in _TEXT or not any(fields):
        return np.array(fields, dtype=object)
    try:
        values = [_number(field) if field else math.nan for field in fields]
        if all(_WHOLE.fullmatch(field) and abs(int(field)) < 2**63 for field in fields):
            return np.array([int(field) for field in fields], dtype=np.int64)
        return np.array(values, dtype=np.float64)
    except (ValueError, OverflowError):  # OverflowError: 0x1p99999
        return np.array(fields, dtype=object)


def _number(field: str) -> float:
    return float.fromhex(field) if "x" in field else float(field)


def _maker(frames: bool | None) -> Any:
    if frames is False:
        return dict
    try:
        return importlib.import_module("pandas").DataFrame
    except ImportError:
        if frames:
            raise
        return dict
