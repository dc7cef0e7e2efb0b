# SPDX-License-Identifier: MIT
"""What tables.schema.json declares of the tables of a bundle and their columns: there is no other list of them."""

import functools
import json
from pathlib import Path

FILE = Path(__file__).resolve().parent.parent / "experiments/bundle/schema/tables.schema.json"
_NOT_FINITE = {"inf", "-inf", "nan"}


@functools.cache
def _whole():
    return json.loads(FILE.read_text(encoding="utf-8"))


def _resolved(declared):
    """Resolves $ref; sibling keys take precedence."""
    while "$ref" in declared:
        named = functools.reduce(dict.__getitem__, declared["$ref"].removeprefix("#/").split("/"), _whole())
        declared = {**named, **{key: value for key, value in declared.items() if key != "$ref"}}
    return declared


@functools.cache
def columns(file):
    """{column: its declaration} in the order of the file; nothing for a file that is not declared."""
    declared = _whole()["properties"].get(file)
    if declared is None:
        return {}
    return {name: _resolved(one) for name, one in _resolved(declared)["items"]["properties"].items()}


@functools.cache
def table(file):
    """What is declared of a table beside its columns."""
    return _resolved(_whole()["properties"][file])


def deterministic():
    """The files that suite and seed determine to the last bit, sorted."""
    return sorted(file for file in _whole()["properties"] if table(file).get("deterministic"))


@functools.cache
def kinds():
    """The kinds of studies that have a table of their name."""
    return tuple(file.removesuffix(".csv") for file, declared in _whole()["properties"].items() if "measures" in declared)


def across(kind):
    """The axes that may run across in a figure of a study of this kind: the first that the study varies."""
    return tuple(table(f"{kind}.csv")["across"])


def measures(kind):
    """(column, what it is): what a figure of a study of this kind shows, a panel each."""
    return tuple(table(f"{kind}.csv")["measures"].items())


@functools.cache
def faults(kind):
    """The columns in which a count above 0 speaks against a method of this kind that is to be chosen."""
    return tuple(table(f"{kind}.csv")["timed"]["faults"])


def timed():
    """{problem: what is declared of its times}: what one is of (`unit`), the axis that runs `across` their
    tables, and when an answer is `right`."""
    blocks = {file.removesuffix(".csv"): declared["timed"] for file, declared in _whole()["properties"].items() if "timed" in declared}
    return {"evaluation": blocks.pop("accuracy"), **blocks}


def method(kind):
    """The column of what is judged."""
    return table(f"{kind}.csv").get("method", "method")


def is_declared(file):
    """Whether a bundle can have this table."""
    return file in _whole()["properties"]


def written(file):
    """The columns that a program of today writes, in their order."""
    return list(columns(file))


def required(file):
    """The columns that every bundle with this table has."""
    return table(file)["items"]["required"]


def digested(file):
    """The columns that the digests of a bundle are of, in their order."""
    return [name for name in written(file) if columns(file)[name].get("digested", True)]


def description(file, column):
    """What the column means."""
    return columns(file)[column].get("description", "")


def unit(file, column):
    """What the numbers of the column are in; empty for counts and ratios, and for words."""
    return columns(file)[column].get("unit", "")


@functools.cache
def types(file, column):
    """What a field of the column may be, of `number`, `word` and `empty`; nothing for a column that is not declared."""
    return frozenset(kind for one in _alternatives(columns(file).get(column)) for kind in _kinds_of(one))


def _alternatives(declared):
    """The declarations of which a field follows any."""
    if declared is None:
        return []
    declared = _resolved(declared)
    return [one for part in declared["anyOf"] for one in _alternatives(part)] if "anyOf" in declared else [declared]


def _kinds_of(declared):
    values = declared.get("enum", [declared["const"]] if "const" in declared else None)
    if values is not None:
        return {"empty" if value is None else "number" if value in _NOT_FINITE or not isinstance(value, str) else "word" for value in values}
    given = declared.get("type", "string")
    return {{"number": "number", "integer": "number", "null": "empty"}.get(one, "word") for one in ([given] if isinstance(given, str) else given)}
