# SPDX-License-Identifier: MIT
"""Tables as LaTeX: each file compiles by itself (xelatex) and can be \\input into a document that loads the same packages."""

from .inline import to_latex

_HEAD = r"""% Compile twice with xelatex, or \def\bezierbenchinput{} and \input this file where ctex and longtable are loaded.
\ifdefined\bezierbenchinput\else
\documentclass[10pt]{article}
\usepackage[landscape,margin=12mm]{geometry}
\usepackage[UTF8]{ctex}
\usepackage{textcomp}
\usepackage{longtable}
\begin{document}
\fi
\begingroup\footnotesize\setlength{\tabcolsep}{4pt}
"""
_FOOT = r"""\endgroup
\ifdefined\bezierbenchinput\else
\end{document}
\fi
"""
BAND = " – "


def _row(texts):
    return " & ".join(map(to_latex, texts)) + r" \\"


def _lines(label, texts):
    """A row; a row of bands becomes two, so that the table stays as narrow as a page."""
    if all(BAND in t and "[" not in t for t in texts if t) and any(texts):
        ends = [t.split(BAND, 1) if t else ("", "") for t in texts]
        return [[f"{label}, from", *(low for low, _ in ends)], ["to", *(high for _, high in ends)]]
    return [[label, *texts]]


def table(block):
    """The text of one .tex file. Groups of several rows stand under a heading of their own."""
    single = block.single
    head = [block.group_head if single else block.row_head, *block.head]
    align = ["l", *("p{65mm}" if wordy else "l" if single else "r" for wordy in block.wordy)]
    across = rf"\multicolumn{{{len(head)}}}"
    caption = to_latex(block.caption) + (rf"\\ {to_latex(block.caption_zh)}" if block.caption_zh else "")
    lines = [rf"\begin{{center}}{caption}\end{{center}}\nopagebreak", rf"\begin{{longtable}}{{{''.join(align)}}}",
             r"\hline", _row(head), r"\hline", r"\endhead"]
    for group in block.groups:
        if single:
            lines.append(_row([group.label, *(c.text for c in group.rows[0][1])]))
            continue
        lines.append(rf"{across}{{l}}{{\textbf{{{to_latex(group.label)}}}}} \\*")
        for label, cells in group.rows:
            lines += map(_row, _lines(label, [c.text for c in cells]))
        lines.append(r"\hline")
    if single:
        lines.append(r"\hline")
    lines.append(r"\end{longtable}")
    return _HEAD + "\n".join(lines) + "\n" + _FOOT
