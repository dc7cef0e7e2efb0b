# SPDX-License-Identifier: MIT
"""Reads a bundle and writes tables, figures and pages. It computes no statistic of its own."""
