# SPDX-License-Identifier: MIT
"""All figures of the source report's tables, in the order of the page. Other chapters draw theirs themselves."""

from . import error_against_degree, error_against_interval, error_against_range, error_over_range, time_against_degree

ROSTER = (error_against_degree, error_against_range, error_over_range, error_against_interval, time_against_degree)
