# SPDX-License-Identifier: MIT
"""The two marks of a text, `code` and **strong**, in each output format."""

import re

_CODE = re.compile(r"`([^`]+)`")
_STRONG = re.compile(r"\*\*([^*]+)\*\*")
_HAN = re.compile(r"([\u3400-\u9fff][\u3000-\u303f\u3400-\u9fff\uff00-\uffef]*)")
_TOGETHER = re.compile(r"\d %|\bR = \S|\bu p~|\d (?:µs|ms|ulp)\b")  # never parted by a line break


def escape_html(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def to_html(text):
    """Escaped, marked, and with Chinese words named as such for readers aloud and for fonts."""
    text = _STRONG.sub(r"<strong>\1</strong>", _CODE.sub(r"<code>\1</code>", escape_html(text)))
    text = _TOGETHER.sub(lambda m: m[0].replace(" ", "\u00a0"), text)
    return _HAN.sub(r'<span lang="zh-Hans">\1</span>', text)


def to_plain(text):
    """Without marks: terminals, attributes."""
    return _STRONG.sub(r"\1", _CODE.sub(r"\1", text))


def to_markdown(text):
    """As it stands, with what a table row or a tag would be taken for escaped outside of code."""
    parts = re.split(r"(`[^`]+`)", text)
    return "".join(p.replace("|", "\\|") if p.startswith("`") else
                   p.replace("|", "\\|").replace("<", "&lt;").replace("_", "\\_").replace("~", "\\~") for p in parts)


_LATEX = {"\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}",
          "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
          "|": r"\textbar{}", "≤": r"$\le$", "≥": r"$\ge$", "×": r"$\times$", "≈": r"$\approx$", "µ": r"\textmu{}",
          "–": "--", "—": "---", "…": r"\ldots{}", "“": "``", "”": "''", "é": r"\'e", "✓": r"", "✗": r"", "\u3000": r"\quad{}",
          '"': r"\textquotedbl{}", "[": "{[}", "]": "{]}"}


def _latex_plain(text):
    return "".join(_LATEX.get(c, c) for c in text).strip()


def to_latex(text):
    """Escaped, with code in typewriter type. Brackets are protected: after a line break they would read as its argument."""
    parts = re.split(r"(`[^`]+`)", text.replace("**", ""))
    return "".join(rf"\texttt{{{_latex_plain(p[1:-1])}}}" if p.startswith("`") and len(p) > 1 else
                   "".join(_LATEX.get(c, c) for c in p) for p in parts).strip()
