# SPDX-License-Identifier: MIT
"""What tables.schema.json declares of the columns of a bundle's tables: what they mean, and which of them hold numbers."""

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


def description(file, column):
    """What the column means."""
    return columns(file)[column].get("description", "")


@functools.cache
def holds_numbers(file, column):
    """Whether a field of the column is a number wherever it is not empty."""
    return column in columns(file) and _numeric(columns(file)[column])


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
