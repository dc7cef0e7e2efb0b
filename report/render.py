# SPDX-License-Identifier: MIT
"""Chapters into files: one HTML page, Markdown, and every table and figure by itself.

Whatever a template prints is escaped for its format, asked or not.
"""

import csv
import io
import re
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape

from . import latex, script
from .document import SAFE
from .inline import Markdown, to_html, to_markdown, to_plain

TEMPLATES = Path(__file__).parent / "templates"
MOST_TITLES = 3


def _environment(**more):
    return Environment(loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
                       keep_trailing_newline=True, **more)


def _checked(name):
    """An id that may stand in a link: build_all gives no other."""
    if not SAFE.fullmatch(name):
        raise ValueError(f"{name!r} is not an id")
    return name


def _html():
    environment = _environment(autoescape=True)
    environment.filters.update(html=to_html, plain=to_plain, inline_svg=lambda figure: Markup(inline_svg(figure)))
    return environment.get_template("page.html.j2")


def _markdown():
    environment = _environment(autoescape=False, finalize=to_markdown)
    environment.filters.update(plain=to_plain, md=to_markdown, raw=Markdown, code=lambda text: to_markdown(f"`{text}`"), id=lambda name: Markdown(_checked(name)))
    return environment.get_template("page.md.j2")


def title(bundle):
    """Of the page: what its suites call themselves."""
    titles = list(bundle.suites.values()) or [f"Bundle {bundle.name}"]
    return "; ".join(titles[:MOST_TITLES]) + (f" and {len(titles) - MOST_TITLES} more" if len(titles) > MOST_TITLES else "")


def files(bundle, chapters, left_out):
    """{path relative to the output directory: bytes}."""
    written = script.text()
    context = {"bundle": bundle, "title": title(bundle), "chapters": chapters, "left_out": left_out, "script": Markup(written),
               "script_digest": Markup(script.digest(written)), "data": script.block(script.data(bundle, chapters))}
    written = {"report.html": _html().render(context).encode(),
               "report.md": re.sub(r"\n{3,}", "\n\n", _markdown().render(context)).encode()}
    for table in _of_kind(chapters, "table"):
        head, rows = table.csv()
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerows([head, *rows])
        written[f"tables/{table.id}.csv"] = out.getvalue().encode()
        written[f"tables/{table.id}.tex"] = latex.table(table).encode()
    for figure in _of_kind(chapters, "figure"):
        written[f"figures/{figure.id}.svg"] = figure.drawing.svg.encode()
        written[f"figures/{figure.id}.png"] = figure.drawing.png()
    return written


def _of_kind(chapters, kind):
    blocks = [block.table if block.kind == "answer" and kind == "table" else block for chapter in chapters for block in chapter.blocks]
    return [block for block in blocks if block.kind == kind]


def inline_svg(figure):
    """The figure as part of the page: ids of its own, the page's ink and paper, no declaration, a name for readers aloud."""
    from .figures.canvas import INK, PAPER  # only where a figure was drawn

    svg = re.sub(r"<metadata>.*?</metadata>", "", figure.drawing.svg[figure.drawing.svg.index("<svg"):], flags=re.S)
    box = re.search(r'viewBox="([^"]+)"', svg)[1]
    head = (f'<svg viewBox="{box}" role="img" aria-labelledby="{figure.id}-title" aria-describedby="{figure.id}-alt">'
            f'<title id="{figure.id}-title">{escape(to_plain(figure.caption))}</title>'
            f'<desc id="{figure.id}-alt">{escape(to_plain(figure.alt))}</desc>')
    svg = re.sub(r"^<svg[^>]*>", lambda _: head, svg)
    svg = re.sub(r"<style type=\"text/css\">.*?</style>", "", svg, flags=re.S)
    own = f"{figure.id}-"
    svg = re.sub(r'\bid="(?!' + re.escape(own) + r')([^"]+)"', rf'id="{own}\1"', svg)
    svg = re.sub(r'(?:xlink:)?href="#([^"]+)"', rf'href="#{own}\1"', svg)
    svg = re.sub(r"url\(#([^)]+)\)", rf"url(#{own}\1)", svg)
    return svg.replace(INK, "var(--ink)").replace(PAPER, "var(--paper)").strip()
