# SPDX-License-Identifier: MIT
"""The list of methods."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

from ._arrays import FORM_NAMES
from ._library import MethodEntry, check, library


class Method(NamedTuple):
    """What is known of a method. Several have one id where they take curves in different forms."""

    id: str
    label: str
    problem: str  # evaluation, arc_length, projection or fitting
    form: str  # bernstein, power or rational: what it takes
    min_degree: int
    max_degree: int  # in double
    max_degree_float: int
    bound: str  # the proved bound in words; empty where there is none
    unit_interval_only: bool  # whether t outside of [0,1] is outside of its domain
    bit_stable: bool  # False where the C library decides the last bits
    flops: str  # per point, in the degree n and the dimension d
    citation: str


def methods(problem: str | None = None, form: str | None = None) -> list[Method]:
    """All methods, or those for a problem ("evaluation", "arc_length", "projection", "fitting") or a form."""
    found = []
    for index in range(library.bb_method_count()):
        entry = MethodEntry()
        check(library.bb_method_at(index, ctypes.byref(entry)))
        method = Method(entry.id.decode(), entry.label.decode(), entry.problem.decode(), FORM_NAMES[entry.form],
                        entry.min_degree, entry.max_degree, entry.max_degree_float, entry.bound.decode(),
                        bool(entry.unit_interval_only), bool(entry.bit_stable), entry.flops.decode(), entry.citation.decode())
        if problem in (None, method.problem) and form in (None, method.form):
            found.append(method)
    return found


def version() -> str:
    """The version of the library."""
    number = library.bb_version()
    return f"{number >> 16}.{number >> 8 & 255}.{number & 255}"
