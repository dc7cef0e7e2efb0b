# SPDX-License-Identifier: MIT
"""Chapters of the page. One file per chapter with TITLE and `blocks(bundle, findings)`; roster.py lists them."""
