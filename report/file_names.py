# SPDX-License-Identifier: MIT
"""Ids of tables and figures: names of files, targets of links, attributes. From a fixed alphabet, and each but once."""

import re
from dataclasses import replace

SAFE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
LONGEST = 120  # characters; with what is added to them they are names of files everywhere
FIXED = ("content", "left-out", "title", "page-data", "page-script", "picker", "view", "said", "answer-sentence")  # of the page itself


def safe(text):
    """The text with anything else replaced, and not too long."""
    return re.sub(r"[^A-Za-z0-9._-]", "_", text).lstrip("._-")[:LONGEST] or "unnamed"


def unique(text, taken):
    """A safe id that none of `taken` equals, whatever their case; it is added to them."""
    wanted = found = safe(text)
    number = 1
    while found.casefold() in taken:
        number += 1
        found = f"{wanted}-{number}"
    taken.add(found.casefold())
    return found


def with_unique_ids(chapters):
    """The chapters with ids that name files and places, of tables and figures in the order of the page."""
    taken = {*FIXED, *(chapter.id.casefold() for chapter in chapters),
             *(f"finding-{block.id}".casefold() for chapter in chapters for block in chapter.blocks if block.kind == "finding")}

    def own(block):
        if block.kind == "answer":
            return replace(block, table=own(block.table))
        return replace(block, id=unique(block.id, taken)) if block.kind in ("table", "figure") else block
    return [replace(chapter, blocks=tuple(map(own, chapter.blocks))) for chapter in chapters]
