# SPDX-License-Identifier: MIT
"""What produced the bundle."""

import json

from ..document import Cell, Group, Table, Text

TITLE = "Provenance"


def _flatten(value, prefix=""):
    """(dotted key, text) for nested objects."""
    if isinstance(value, dict):
        return [pair for key, inner in value.items() for pair in _flatten(inner, f"{prefix}.{key}" if prefix else key)]
    if isinstance(value, list):
        return [(prefix, ", ".join(one if isinstance(one, str) else json.dumps(one, ensure_ascii=False) for one in value))]
    return [(prefix, {True: "yes", False: "no", None: "unknown"}.get(value, str(value)) if isinstance(value, (bool, type(None)))
             else str(value))]


def _table(table_id, caption, caption_zh, value):
    groups = tuple(Group(f"`{key}`", key, (("", [Cell(text, text)]),)) for key, text in _flatten(value))
    return Table(id=table_id, caption=caption, caption_zh=caption_zh, group_head="key", head=("value",), groups=groups)


def blocks(bundle, _findings):
    """bundle.json and machine.json as they are, then the files of the bundle."""
    yield _table("provenance-bundle", "The bundle", "结果包", bundle.info)
    if bundle.machine is None:
        yield Text("The machine is not known: the bundle has no machine.json.")
    else:
        yield _table("provenance-machine", "The machine and the build", "机器与编译", bundle.machine)
    yield Text("Read from " + ", ".join(f"`{name}` ({len(table.rows)} rows)" for name, table in bundle.tables.items()) + ". "
               + ("The suite is in `suite.toml`, the checksums in `SHA256SUMS`." if bundle.suite is not None else
                  "The bundle has no suite.toml."))
