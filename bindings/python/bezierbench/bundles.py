# SPDX-License-Identifier: MIT
"""Bundles of `bezierbench run` as tables: DataFrames where pandas is installed, else arrays by the name of the column."""

from __future__ import annotations

import csv
import hashlib
import importlib
import json
import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ._arrays import Array

NEWEST_SCHEMA = 2
_TEXT = {"coefficients", "weights"}  # several numbers in one field: see numbers()


class BundleError(ValueError):
    """A directory that is no bundle, or not as it was written; the message names the file."""


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
    columns are text. Raises BundleError that names the file, and FileNotFoundError for a directory that is not there.
    """
    path = Path(bundle)
    sums = _sums(path)
    info = json.loads(_checked(path, "bundle.json", sums))
    schema = info.get("schema_version")
    if not isinstance(schema, int) or not 1 <= schema <= NEWEST_SCHEMA:
        raise BundleError(f"{path / 'bundle.json'}: schema_version {schema!r} is not 1 to {NEWEST_SCHEMA}; use a newer bezierbench")
    machine = json.loads(_checked(path, "machine.json", sums))
    make = _maker(frames)
    tables = {}
    for name in sorted(sums):
        if name.endswith(".csv") and "/" not in name:
            tables[name.removesuffix(".csv")] = make(_columns(path / name, _checked(path, name, sums)))
    return Bundle(path, info, machine, tables)


def numbers(field: str) -> Array:
    """The numbers in a field such as `coefficients` of the table `worst`, decimal or hexadecimal."""
    return np.array([_number(word) for word in field.split()], dtype=np.float64)


def _sums(path: Path) -> dict[str, str]:
    if not (path / "bundle.json").exists():
        raise FileNotFoundError(f"{path}: no bundle; its run never started, or this is another directory")
    file = path / "SHA256SUMS"
    if not file.exists():
        raise BundleError(f"{file}: missing; a bundle has it when its run is complete")
    sums = {}
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        digest, _, name = line.partition("  ")
        if len(digest) != 64 or not name:
            raise BundleError(f"{file}:{number}: not a line of sha256sum")
        sums[name] = digest
    return sums


def _checked(path: Path, name: str, sums: dict[str, str]) -> str:
    data = (path / name).read_bytes()
    if hashlib.sha256(data).hexdigest() != sums.get(name):
        raise BundleError(f"{path / name}: not what SHA256SUMS lists; run `bezierbench verify` on the bundle")
    return data.decode("utf-8")


def _columns(file: Path, text: str) -> dict[str, Array]:
    rows = list(csv.reader(text.splitlines()))
    if not rows or any(len(row) != len(rows[0]) for row in rows):
        raise BundleError(f"{file}: rows of different lengths")
    return {name: _column(name, [row[k] for row in rows[1:]]) for k, name in enumerate(rows[0])}


def _column(name: str, fields: list[str]) -> Array:
    if name in _TEXT or not any(fields):
        return np.array(fields, dtype=object)
    try:
        values = [_number(field) if field else math.nan for field in fields]
        if all(field.lstrip("-").isdigit() and abs(int(field)) < 2**63 for field in fields):
            return np.array([int(field) for field in fields], dtype=np.int64)
        return np.array(values, dtype=np.float64)
    except ValueError:
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
