# SPDX-License-Identifier: MIT
"""SHA256SUMS: which files a bundle has, and whether they are as they were written."""

import hashlib
import re

NAME = "SHA256SUMS"
_LINE = re.compile(r"([0-9a-f]{64})  ([A-Za-z0-9][A-Za-z0-9._-]*)")


class Malformed(Exception):
    """Line number and what is wrong with it."""


def parse(text):
    """{file name: digest}."""
    listed = {}
    for number, line in enumerate(text.split("\n"), 1):
        found = _LINE.fullmatch(line)
        if found:
            if found[2] in listed:
                raise Malformed(number, "lists a file twice")
            listed[found[2]] = found[1]
        elif line:
            raise Malformed(number, "is no line of sha256sum about a file of a bundle")
    return listed


def fits(digest, data):
    """Whether these bytes have that digest."""
    return hashlib.sha256(data).hexdigest() == digest
