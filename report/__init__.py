# SPDX-License-Identifier: MIT
"""Reads a bundle and writes tables, figures and pages. It computes no statistic of its own."""

import importlib.util
import sys
from pathlib import Path

_READER = Path(__file__).resolve().parent.parent / "bindings/python/bezierbench/files.py"

# The reader of bundles of the package bezierbench, whose other modules need NumPy and libbezierbench; a report needs neither.
_spec = importlib.util.spec_from_file_location("report.files", _READER)
files = importlib.util.module_from_spec(_spec)
sys.modules["report.files"] = files
_spec.loader.exec_module(files)
