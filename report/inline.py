# SPDX-License-Identifier: MIT
"""The two marks of a text, `code` and **strong**, in each output format, and everything else escaped: one function per format. A text of a
bundle may have the marks, too."""

import re

from markupsafe import Markup, escape

# Control and format characters, line and paragraph separators, surrogates, private use.
_ACTING = re.compile("[\0-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff\ue000-\uf8ff\ufeff"
                     "\ufff9-\uffff\U000e0000-\U0010ffff]")
_CODE = re.compile(r"`([^`]+)`")
_STRONG = re.compile(r"\*\*([^*]+)\*\*")
_HAN = re.compile(r"([\u3400-\u9fff][\u3000-\u303f\u3400-\u9fff\uff00-\uffef]*)")
_NUMBER = re.compile(r"[0-9.e+-]*", re.ASCII)
_WORD, _PART = re.compile(r"(?<=[a-z0-9]_)(?=[a-z])"), re.compile(r"(?<=[:.])(?=[a-z])")  # where ids may be broken, in any text and in code
_TOGETHER = re.compile(r"\d %|\bR = \S|\bu p~|\d (?:µs|ms|ulp)\b")  # never parted by a line break


def visible(text):
    """One line in which every character can be seen: a tab is \\t, an escape \\x1b."""
    return _ACTING.sub(lambda found: found[0].encode("unicode_escape").decode("ascii"), text)


def visible_json(value):
    """`visible` for every text in a value of json.loads, keys included."""
    if isinstance(value, dict):
        return {visible(key): visible_json(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [visible_json(inner) for inner in value]
    return visible(value) if isinstance(value, str) else value


def to_html(text):
    """Escaped, marked, and with Chinese text tagged for screen readers and fonts."""
    if _NUMBER.fullmatch(text):  # most cells of a large page
        return Markup(text)
    escaped = _WORD.sub("<wbr>", str(escape(text)).replace("&#39;", "'"))  # between tags and in double quotes it is itself
    text = _STRONG.sub(r"<strong>\1</strong>", _CODE.sub(lambda m: f"<code>{_PART.sub('<wbr>', m[1])}</code>", escaped))
    text = _TOGETHER.sub(lambda m: m[0].replace(" ", "\u00a0"), text)
    return Markup(_HAN.sub(r'<span lang="zh-Hans">\1</span>', text))


def to_plain(text):
    """Without marks: terminals, and attributes, which the template escapes."""
    return _STRONG.sub(r"\1", _CODE.sub(r"\1", text))


class Markdown(str):
    """Text that is Markdown already."""


# What Markdown, in GitHub's dialect, would take for markup, a table, a formula or a link wherever it stands.
_MARKDOWN = re.compile(r"[\\`*_\[\]|~#$]|:(?=//)|(?<=www)\.", re.I)
_MARKDOWN_TAGS = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}


def _markdown_code(text):
    """A bar would end the cell of a table even here."""
    return f"`{text}`".replace("|", "\\|")


def _markdown_words(text):
    escaped = re.sub("[&<>]", lambda m: _MARKDOWN_TAGS[m[0]], text)
    return _MARKDOWN.sub(lambda m: "\\" + m[0], escaped)


def to_markdown(text):
    """Escaped and marked, on one line."""
    if isinstance(text, Markdown):
        return text
    parts = re.split(r"(`[^`]+`|\*\*)", str(text))
    return Markdown("".join(part if part == "**" else _markdown_code(part[1:-1]) if _CODE.fullmatch(part) else _markdown_words(part)
                            for part in parts))


_LATEX = {"\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}",
          "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
          "|": r"\textbar{}", "≤": r"$\le$", "≥": r"$\ge$", "×": r"$\times$", "≈": r"$\approx$", "µ": r"\textmu{}",
          "–": "--", "—": "---", "…": r"\ldots{}", "“": "``", "”": "''", "é": r"\'e", "✓": r"", "✗": r"", "\u3000": r"\quad{}",
          '"': r"\textquotedbl{}", "`": r"\textasciigrave{}",
          # after a line break these would read as its argument, or as a part of it
          "[": "{[}", "]": "{]}", "*": "{*}"}


def _latex_words(text):
    return "".join(_LATEX.get(c, c) for c in text)


def to_latex(text):
    """Escaped, with code in typewriter type."""
    parts = re.split(r"(`[^`]+`)", text.replace("**", ""))
    return "".join(rf"\texttt{{{_latex_words(p[1:-1]).strip()}}}" if _CODE.fullmatch(p) else _latex_words(p)
                   for p in parts).strip()
