# SPDX-License-Identifier: MIT
"""Writes files so that nothing is ever half-written: all under temporary names first, then renamed one by one."""

import os
import shutil
import tempfile
from pathlib import Path


def write(directory, files):
    """Writes {relative path: bytes}. On any error the directory keeps what it had."""
    directory = Path(directory)
    directory.mkdir(parents=True, exist_ok=True)
    staging = Path(tempfile.mkdtemp(prefix=".report-", dir=directory))
    try:
        for name, data in files.items():
            path = staging / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        for name in files:
            target = directory / name
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(staging / name, target)
    finally:
        shutil.rmtree(staging, ignore_errors=True)
