# SPDX-License-Identifier: MIT
"""Tables and links of Markdown."""
import os
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTH = 118  # of a line of prose


def cell(text):
    return str(text).replace("|", "\\|")


def table(header, body):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(map(cell, line)) + " |" for line in body]
    return "\n".join(lines)


def link(page, target):
    """A link from a page to a file or folder of the repository, named by its path from the root."""
    return f"[{target.relative_to(ROOT)}]({os.path.relpath(target, page.parent)})"
