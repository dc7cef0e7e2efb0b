#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the playground as one file, index.html, that works from a folder without a server: bundle.py FOLDER.

Browsers refuse modules, workers and fetch from file://. So each module becomes a function in one script, the worker a second script
that the page starts from its text, and the library base64 of its gzip. The page's policy names the script by its hash.
"""
import base64
import gzip
import hashlib
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
LIBRARY = ROOT / "build/web/bezierbench.wasm"
WRAPPER = ROOT / "bindings/web/bezierbench.mjs"
IMPORT = re.compile(r'^import \{ (.*) \} from "\./(\w+)\.mjs";$', re.MULTILINE)
EXPORT = re.compile(r"^export ((?:async )?(?:const|let|function|class)) (\w+)", re.MULTILINE)


class Fault(Exception):
    """A sentence that says what is wrong and what to do."""


def _script(entry, wrapper):
    """The module and all that it imports, in the order in which they run, as one classic script."""
    done = {}

    def add(name):
        if name in done:
            return
        text = (wrapper if name == "bezierbench" else HERE / f"{name}.mjs").read_text(encoding="utf-8")
        for _, other in IMPORT.findall(text):
            add(other)
        names = ", ".join(name for _, name in EXPORT.findall(text))
        body = EXPORT.sub(r"\1 \2", IMPORT.sub(r"const { \1 } = modules.\2;", text))
        if left := re.search(r"^(?:import|export)\b.*$", body, re.MULTILINE):
            raise Fault(f"{name}.mjs: “{left[0]}” is not an import or export that bundle.py reads; write it as the others")
        done[name] = f"modules.{name} = (() => {{\n{body}return {{ {names} }};\n}})();\n"

    add(entry)
    script = '"use strict";\nconst modules = {};\n' + "".join(done.values())
    if "</script" in script or "<!--" in script:
        raise Fault(f"{entry}.mjs or what it imports has “</script” or “<!--”; write it in two strings")
    return script


def _hash(text):
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def page(library=LIBRARY, wrapper=WRAPPER, site_css=True):
    """The text of the page. Without `site_css` it does not look for ../site.css."""
    for path in (library, wrapper):
        if not path.is_file():
            raise Fault(f"{path}: no such file; make it by scripts/build web")
    parts = {name: "\n" + _script(entry, wrapper) for name, entry in (("script", "main"), ("worker", "worker"))}
    parts["style"] = (HERE / "playground.css").read_text(encoding="utf-8")
    if not site_css:
        parts["style"] = re.sub(r"^@import .*\n", "", parts["style"], flags=re.MULTILINE)
    parts["program"] = base64.b64encode(gzip.compress(library.read_bytes(), mtime=0)).decode()
    parts["policy"] = (f"default-src 'none'; script-src {_hash(parts['script'])} 'wasm-unsafe-eval'; worker-src blob:; "
                       f"style-src 'self' {_hash(parts['style'])}; img-src data:; base-uri 'none'; form-action 'none'")
    return re.sub(r"\{\{(\w+)\}\}", lambda match: parts[match[1]], (HERE / "index.html").read_text(encoding="utf-8"))


def write(folder, **given):
    """Writes the page into a folder, which is made where it is missing."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(page(site_css=(folder.parent / "site.css").is_file(), **given), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: bundle.py FOLDER")
    try:
        write(sys.argv[1])
    except (Fault, OSError) as fault:
        sys.exit(f"bundle.py: {fault}")
