# SPDX-License-Identifier: MIT
"""What a bundle says about the source report, and what its suites show: a function for each finding."""
