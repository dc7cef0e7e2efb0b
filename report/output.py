# SPDX-License-Identifier: MIT
"""Writes files so that nothing is ever half-written: all under a temporary name first, then moved to their places.

A new directory appears with all its files. In one that has files each is replaced whole, the pages last, so that no page names a table that
is not there.
"""

import os
import re
import tempfile
from pathlib import Path

_NAME = re.compile(r"([a-z]+/)?[A-Za-z0-9][A-Za-z0-9._-]*")


def write(directory, files):
    """Writes {relative path: bytes}. On any error the directory keeps its files."""
    for name in files:
        if not _NAME.fullmatch(name):
            raise ValueError(f"{name!r} is not a name for a file of a report")
    directory = Path(directory).absolute()
    there = directory if directory.exists() else directory.parent
    there.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".report-", dir=there) as place:
        page = Path(place) / "page"
        for name, data in files.items():
            (page / name).parent.mkdir(parents=True, exist_ok=True)
            (page / name).write_bytes(data)
        if there != directory:
            os.rename(page, directory)
            return
        for name in sorted(files, key=lambda name: "/" not in name):
            (directory / name).parent.mkdir(exist_ok=True)
            os.replace(page / name, directory / name)
