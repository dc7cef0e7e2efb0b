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
    """With what a $ref names; what is said beside it goes before."""
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
def timed():
    """{problem: what is declared of its times}: what one is of (`unit`, in Chinese `unit_zh`), the axis that runs `across` their
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
    return [name for name, column in columns(file).items() if not column.get("deprecated")]


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
def holds_numbers(file, column):
    """Whether a field of the column is a number wherever it is not empty."""
    return column in columns(file) and _numeric(columns(file)[column])


@functools.cache
def holds_words(file, column):
    """Whether a field of the column is never a number."""
    return column in columns(file) and not _may_be_number(columns(file)[column])


@functools.cache
def may_be_empty(file, column):
    """Whether a field of the column may be empty."""
    return column not in columns(file) or _may_be_null(columns(file)[column])


def _alternatives(declared):
    """The declarations of which a field follows any."""
    declared = _resolved(declared)
    return [one for part in declared["anyOf"] for one in _alternatives(part)] if "anyOf" in declared else [declared]


def _types(declared):
    types = declared.get("type", ())
    return {types} if isinstance(types, str) else set(types)


def _may_be_number(declared):
    return any(_types(one) & {"number", "integer"} for one in _alternatives(declared))


def _may_be_null(declared):
    return any("null" in _types(one) or None in one.get("enum", ()) for one in _alternatives(declared))


def _numeric(declared):
    declared = _resolved(declared)
    if "anyOf" in declared:
        kinds = [one for one in map(_resolved, declared["anyOf"]) if one.get("type") != "null"]
        return any(_is_number(one) for one in kinds) and all(_numeric(one) or _words(one) <= _NOT_FINITE for one in kinds)
    return _is_number(declared)


def _is_number(declared):
    types = declared.get("type")
    types = {types} if isinstance(types, str) else set(types or ())
    return bool(types - {"null"}) and types <= {"number", "integer", "null"} or "anyOf" in declared and _numeric(declared)


def _words(declared):
    return set(declared.get("enum", [declared["const"]] if "const" in declared else ["any word"]))
