# SPDX-License-Identifier: MIT
"""Figures. One file and one function `draw(bundle)` per figure; roster.py lists them. Text in figures is English."""
