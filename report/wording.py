# SPDX-License-Identifier: MIT
"""How numbers and lists read in sentences, tables and figures. One notation everywhere: 6.92e-11, as the report prints."""

import math
import re


def plain(text):
    """A number's text with the shortest exponent: 1e-06 becomes 1e-6, 1e+06 becomes 1e6."""
    return re.sub(r"e([+-])0*(\d)", lambda m: "e" + ("-" if m[1] == "-" else "") + m[2], text)


def scientific(value, digits=3):
    """An error with `digits` significant digits: 6.92e-11; 0 stays 0."""
    if value is None:
        return ""
    if not math.isfinite(value) or value == 0:
        return f"{value:g}"
    return plain(f"{value:.{digits - 1}e}")


def general(value, digits=3):
    """A number of ordinary size with `digits` significant digits; whole numbers below a million in full."""
    if value is None:
        return ""
    if not math.isfinite(value):
        return f"{value:g}"
    if value == int(value) and abs(value) < 1e6:
        return f"{int(value)}"
    if 1e-3 <= abs(value) < 10 ** digits:
        decimals = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
        return f"{value:.{decimals}f}"
    if 1e-3 <= abs(value) < 1e4:
        return f"{value:.0f}"
    return scientific(value, digits)


def shortest(value):
    """The fewest digits that tell the value: ranges, intervals and printed values."""
    if value is None:
        return ""
    if not math.isfinite(value):
        return f"{value:g}"
    if value == int(value) and abs(value) < 1e4:
        return f"{int(value)}"
    text = repr(value)
    if "e" not in text and (abs(value) < 1e-2 or abs(value) >= 1e4):
        digits = len(text.replace("-", "").replace(".", "").strip("0"))
        text = f"{value:.{max(digits - 1, 0)}e}"
    return plain(text)


def as_printed(value):
    """An error of the source report in its notation: three digits and an exponent, but 0.054."""
    if value is not None and value >= 1e-2 and len(f"{value:g}") <= len("0.000"):
        return f"{value:g}"
    return scientific(value)


def factor(value):
    """A ratio: two significant digits, then a power of ten where it is large."""
    return general(value, 2) if abs(value) < 1e4 else scientific(value, 2)


def percent(value):
    """A share as a percentage without decimals, with one where that would read 0 or 100 and is not."""
    text = f"{100 * value:.0f}"
    if text in ("0", "100") and value not in (0, 1):
        text = f"{100 * value:.1f}"
    return "less than 0.1 %" if text == "0.0" else "more than 99.9 %" if text == "100.0" else f"{text} %"


def span(low, high, write):
    """`a to b`, or one number where both read the same."""
    a, b = write(low), write(high)
    return a if a == b else f"{a} to {b}"


def interval(low, high):
    return f"[{shortest(low)}, {shortest(high)}]"


def large(value):
    """A count with its thousands apart: 89,032,000."""
    return "" if value is None else f"{value:,.0f}"


def listing(words, last="and"):
    words = list(words)
    if len(words) <= 1:
        return "".join(words)
    return f"{', '.join(words[:-1])} {last} {words[-1]}"


def count(n, singular, plural=None):
    return f"{n} {singular if n == 1 else plural or singular + 's'}"
