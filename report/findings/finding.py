# SPDX-License-Identifier: MIT
"""How a finding is declared: a function of the bundle, marked with the suite whose bundles it is about."""

ROSTER = []  # (function, suite), in the order in which they are declared


def finding(suite="report"):
    """Marks a function that returns a document.Finding or raises Missing; `suite=None` means that any bundle may have it."""
    def declare(find):
        ROSTER.append((find, suite))
        return find
    return declare
