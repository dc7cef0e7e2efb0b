# SPDX-License-Identifier: MIT
"""The table of docs/methods.md: the program's methods, each with its header."""
import csv
import io
import os

from report.chapters.provenance import METHOD_COLUMNS
from report.site import header
from scripts.pages.markdown import ROOT, table
from scripts.pages.program import method_list_of


def methods(page, program):
    """In the columns of the report's chapter; an id leads to the header, and in the site to the method's page."""
    rows = [row for row in csv.DictReader(io.StringIO(method_list_of(program))) if ":" not in row["id"]]

    def line(row):
        name, *others = (write(row) for _, write in METHOD_COLUMNS)
        headers = header.of(row["id"])
        one = next((one for one in headers if f"Form::{row['form']}" in one.text), headers[0])
        return [f"[{name}]({os.path.relpath(ROOT / one.path, page.parent)})", *others]
    return table([heading for heading, _ in METHOD_COLUMNS], map(line, rows))
