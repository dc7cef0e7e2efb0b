# SPDX-License-Identifier: MIT
"""What the bundle says about the source report. One file per finding; roster.py lists them."""
