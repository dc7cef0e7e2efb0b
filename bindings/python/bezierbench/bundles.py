# SPDX-License-Identifier: MIT
"""Bundles of `bezierbench run` as tables: DataFrames where pandas is installed, else arrays by the name of the column."""

from __future__ import annotations

import importlib
import math
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from . import files
from ._arrays import Array
from .files import BundleError

_TEXT = {"coefficients", "weights"}  # several numbers in one field: see numbers()
_WHOLE = re.compile(r"-?[0-9]{1,19}", re.ASCII)


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
    a run that is not complete, a file that is missing, changed, malformed or not a regular file. No link is
    followed. `bezierbench verify` says more.
    """
    path = Path(bundle)
    sums = files.checksums(path / files.SUMS, files.content(path / files.SUMS))
    found = {name: _checked(path, name, digest) for name, digest in sums.items()}
    info, machine = (_document(path, name, found) for name in ("bundle.json", "machine.json"))
    files.check_version(path / "bundle.json", info)
    if info.get("state") != "complete":
        raise BundleError(f"{path / 'bundle.json'}: the run is not complete; continue it with `bezierbench run`")
    make = _maker(frames)
    tables = {name.removesuffix(".csv"): make(_columns(path / name, data)) for name, data in sorted(found.items()) if name.endswith(".csv")}
    return Bundle(path, info, machine, tables)


def numbers(field: str) -> Array:
    """The numbers in a field such as `coefficients` of the table `worst`, decimal or hexadecimal. Raises ValueError for a word that is
    not a number."""
    values = [files.number(word) for word in field.split()]
    if None in values:
        raise ValueError(f"{files.shown(field)!r} holds a word that is not a number")
    return np.array(values, dtype=np.float64)


def _checked(path: Path, name: str, digest: str) -> bytes:
    data = files.content(path / name)
    if not files.fits(digest, data):
        raise BundleError(f"{path / name}: is not what {files.SUMS} lists; run `bezierbench verify` on the bundle")
    return data


def _document(path: Path, name: str, found: dict[str, bytes]) -> dict[str, Any]:
    if name not in found:
        raise BundleError(f"{path / name}: is not in {files.SUMS}; restore the bundle")
    return files.document(path / name, found[name])


def _columns(file: Path, data: bytes) -> dict[str, Array]:
    header, rows = files.table(file, data)
    whole = [row for _, row in rows]
    return {name: _column(name, [row[at] for row in whole]) for at, name in enumerate(header)}


def _column(name: str, fields: list[str]) -> Array:
    values = [files.number(field) if field else math.nan for field in fields]
    if name in _TEXT or not any(fields) or None in values:
        return np.array(fields, dtype=object)
    if all(_WHOLE.fullmatch(field) and abs(int(field)) < 2**63 for field in fields):
        return np.array([int(field) for field in fields], dtype=np.int64)
    return np.array(values, dtype=np.float64)


def _maker(frames: bool | None) -> Any:
    if frames is False:
        return dict
    try:
        return importlib.import_module("pandas").DataFrame
    except ImportError:
        if frames:
            raise
        return dict
