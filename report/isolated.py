# SPDX-License-Identifier: MIT
"""Starts the report: python3 -I isolated.py ARGUMENTS.

`-I` keeps the current folder, PYTHONPATH and a user's own packages off the module path, so that no file of a bundle is run. The
package is found by its place and under no other name, whatever characters are in it.
"""

import importlib.util
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent


def load():
    """Makes the package `report` importable."""
    spec = importlib.util.spec_from_file_location("report", PACKAGE / "__init__.py", submodule_search_locations=[str(PACKAGE)])
    sys.modules["report"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["report"])


if __name__ == "__main__":
    load()
    from report.__main__ import main

    sys.exit(main())
