# SPDX-License-Identifier: MIT
"""Chapters of the page: functions `name(bundle, findings)` with the decorator `chapter`, in a file for each part of the page."""

from . import first_glance, real_curves, choice, printed, evaluators, guarantees, companions, speed, provenance  # noqa: F401, I001  the order of the page
