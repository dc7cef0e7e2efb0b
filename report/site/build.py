# SPDX-License-Identifier: MIT
"""Writes the site into a folder: see scripts/site."""
import argparse
import posixpath
import re
import shutil
import subprocess
import sys
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from . import methods, repository, start
from .formula import Typesetter
from .repository import AS_THEY_ARE, ROOT, Fault

TEMPLATES = Path(__file__).resolve().parent / "templates"
PAGE_CSS = ROOT / "report/templates/page.css"
PLAYGROUND = ROOT / "report/site/playground"
ENGINE = (ROOT / "build/web/bezierbench.wasm", ROOT / "bindings/web/bezierbench.mjs")
DOORS = (("Methods", "methods/index.html"), ("Introduction", "docs/introduction.html"), ("Documents", "docs/index.html"), ("Atlas", "atlas/index.html"),
         ("Playground", "playground/index.html"))
METHODS = "docs/methods.md"  # whose ids lead to headers, and here to pages
NO_PLAYGROUND = "without the playground, whose engine is not compiled; run scripts/build web, then scripts/site"


class Site:
    """A folder that is written page by page."""

    def __init__(self, out):
        self.out, self.playground, self.wanted = Path(out), False, set()  # `wanted`: files of the repository that pages link to
        self.environment = Environment(loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, autoescape=True, trim_blocks=True, lstrip_blocks=True)

    def write(self, at, text):
        path = self.out / at
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def page(self, at, template, **values):
        """Writes a page; `up` leads to the site's first folder from it."""
        up = posixpath.relpath(".", posixpath.dirname(at) or ".") + "/"
        doors = [door for door in DOORS if self.has(door[1])]
        self.write(at, self.environment.get_template(template).render(up="" if up == "./" else up, at=at, doors=doors, **values))

    def has(self, at):
        """Whether a page that other pages link to is part of this site."""
        return {"docs/introduction.html": (ROOT / "docs/introduction.md").exists(), "playground/index.html": self.playground}.get(at, True)

    def copy(self, path):
        """A file that is a page or picture already."""
        there = self.out / repository.place(path)
        there.parent.mkdir(parents=True, exist_ok=True)
        if path.endswith(".svg"):
            there.write_text(repository.picture((ROOT / path).read_text(encoding="utf-8")), encoding="utf-8")
        else:
            shutil.copyfile(ROOT / path, there)


def style():
    """The colours of the report's pages, then what the site adds."""
    colours = re.match(r"(:root \{.*?\n\}\n@media \(prefers-color-scheme: dark\) \{.*?\n\}\n)", PAGE_CSS.read_text(encoding="utf-8"), re.DOTALL)
    if not colours:
        raise Fault(f"{PAGE_CSS.relative_to(ROOT)}: does not begin with its colours, light and dark; report/site/build.py reads them")
    return colours[1] + (TEMPLATES / "site.css").read_text(encoding="utf-8")


def write_documents(site, pages):
    """The documents, and what they and all other pages link to, until nothing new is linked."""
    todo = set(repository.documents()) | site.wanted
    done = set()
    while todo:
        rendered = repository.to_html({path: (ROOT / path).read_text(encoding="utf-8") for path in sorted(todo)
                                       if path.endswith(".md")})
        seen = set()
        for path in sorted(todo):
            if path.endswith(AS_THEY_ARE):
                site.copy(path)
                continue
            body = rendered[path] if path in rendered else repository.source_text(path)
            body = repository.linked(repository.scrolling(body), path, seen) if path in rendered else body
            if path == METHODS:
                body = re.sub(r'<a href="[^"]*"><code>([\w:]+)</code></a>', lambda found: pages.link(found[1], "..") if found[1] in pages.rows else found[0], body)
            site.page(repository.place(path), "page.html.j2", title=repository.title_of(body, path), body=body)
        done |= {repository.place(path) for path in todo}
        todo = {path for path in seen if repository.place(path) not in done}
        todo = {path if not (ROOT / path / "README.md").exists() else posixpath.join(path, "README.md") for path in todo}


def write_start(site, known):
    needs, seen = start.every_need()
    site.wanted |= seen
    site.page("index.html", "start.html.j2", cards=start.cards(known), ways=start.doors(), needs=needs, playground=site.playground,
              introduction="docs/introduction.html" if site.has("docs/introduction.html") else "")


def write_methods(site, pages):
    """A page for each method, and their index."""
    typeset = Typesetter(pages.texts(), repository.to_html)
    for method in pages.rows:
        site.page(methods.address(method), "method.html.j2", title=method, **pages.page(method, typeset, site.wanted))
    site.page("methods/index.html", "methods.html.j2", title="Methods", groups=pages.index(typeset), composed=pages.composed())


def write_playground(site):
    """Whether there is one: its page with the engine inside, where that is built."""
    if not (PLAYGROUND / "bundle.py").exists() or not all(path.exists() for path in ENGINE):
        return False
    from .playground import bundle
    try:
        bundle.write(site.out / "playground")
    except bundle.Fault as fault:
        raise Fault(str(fault)) from None
    return True


def build(out, program):
    """Writes the site. Lines that say what it does not hold."""
    site = Site(out)
    said = []
    site.write("site.css", style())
    site.playground = write_playground(site)
    if not site.playground:
        said.append(NO_PLAYGROUND)
    pages = methods.Pages(program)
    write_start(site, pages.answers)
    write_methods(site, pages)
    write_documents(site, pages)
    return said


def main(given):
    parser = argparse.ArgumentParser(prog="site", description="Writes the static site: start page, documents, a page for each method, atlas, playground.")
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "site", help="where to; default: site")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/bezierbench", help="lists the methods; default: build/release/bezierbench")
    parser.add_argument("--pictures", action="store_true", help="draws those of docs/introduction.md instead")
    options = parser.parse_args(given)
    if options.pictures:
        from . import pictures  # needs NumPy and matplotlib
        pictures.write()
        return 0
    try:
        if not shutil.which("pandoc"):
            raise Fault("pandoc is missing, which makes HTML of the documents; install the package pandoc")
        if not options.program.exists():
            raise Fault(f"{options.program}: no such program; build it with scripts/build release bezierbench, or name one with --program")
        for line in build(options.folder, options.program.resolve()):
            print(f"site: {line}")
    except (Fault, subprocess.CalledProcessError, OSError) as fault:
        print(f"site: {fault}", file=sys.stderr)
        return 3
    print(f"site: {options.folder / 'index.html'}")
    return 0
