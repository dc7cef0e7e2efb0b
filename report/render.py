# SPDX-License-Identifier: MIT
"""Chapters into files: one HTML page, Markdown, and every table and figure by itself."""

import csv
import io
import re
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from . import latex
from .inline import escape_html, to_html, to_markdown, to_plain

TEMPLATES = Path(__file__).parent / "templates"


def files(bundle, chapters, left_out):
    """{path relative to the output directory: bytes}."""
    environment = Environment(loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, trim_blocks=True,
                              lstrip_blocks=True, keep_trailing_newline=True, autoescape=False)
    environment.filters.update(html=to_html, plain=to_plain, md=to_markdown, attribute=lambda t: escape_html(to_plain(t)),
                               inline_svg=inline_svg)
    context = {"bundle": bundle, "chapters": chapters, "left_out": left_out, "figures": _of_kind(chapters, "figure")}
    written = {}
    for template, name in (("page.html.j2", "report.html"), ("page.md.j2", "report.md")):
        text = environment.get_template(template).render(context)
        written[name] = (re.sub(r"\n{3,}", "\n\n", text) if name.endswith(".md") else text).encode()
    for table in _of_kind(chapters, "table"):
        head, rows = table.csv()
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerows([head, *rows])
        written[f"tables/{table.id}.csv"] = out.getvalue().encode()
        written[f"tables/{table.id}.tex"] = latex.table(table).encode()
    for figure in _of_kind(chapters, "figure"):
        written[f"figures/{figure.id}.svg"] = figure.svg.encode()
        written[f"figures/{figure.id}.png"] = figure.png
    return written


def _of_kind(chapters, kind):
    return [block for chapter in chapters for block in chapter.blocks if block.kind == kind]


def inline_svg(figure):
    """The figure as part of the page: ids of its own, the page's ink and paper, no declaration, a name for readers aloud."""
    from .figures.canvas import INK, PAPER  # only where a figure was drawn

    svg = re.sub(r"<metadata>.*?</metadata>", "", figure.svg[figure.svg.index("<svg"):], flags=re.S)
    box = re.search(r'viewBox="([^"]+)"', svg)[1]
    svg = re.sub(r"^<svg[^>]*>", f'<svg viewBox="{box}" role="img" aria-labelledby="{figure.id}-title" '
                 f'aria-describedby="{figure.id}-alt"><title id="{figure.id}-title">{escape_html(figure.caption)}</title>'
                 f'<desc id="{figure.id}-alt">{escape_html(figure.alt)}</desc>', svg)
    svg = re.sub(r"<style type=\"text/css\">.*?</style>", "", svg, flags=re.S)
    own = f"{figure.id}-"
    svg = re.sub(r'\bid="(?!' + re.escape(own) + r')([^"]+)"', rf'id="{own}\1"', svg)
    svg = re.sub(r'(?:xlink:)?href="#([^"]+)"', rf'href="#{own}\1"', svg)
    svg = re.sub(r"url\(#([^)]+)\)", rf"url(#{own}\1)", svg)
    return svg.replace(INK, "var(--ink)").replace(PAPER, "var(--paper)").strip()
