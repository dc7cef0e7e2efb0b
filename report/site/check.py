# SPDX-License-Identifier: MIT
"""Checks a written site: every page is well-formed, every link and anchor resolves, and nothing is loaded from elsewhere."""
import posixpath
import re
import urllib.parse
import xml.etree.ElementTree as XML
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

LOADED = {"src", "srcset", "poster", "data"}  # attributes whose target a browser fetches by itself; and href of these:
LOADING = ("link", "use", "image")
ABSOLUTE = re.compile(r"(?i)(?:https?:|ftp:)?//|file:")
FETCHED = re.compile(r"""(?i)url\(\s*["']?((?:https?:)?//[^)"']*)|@import\s+["']((?:https?:)?//[^"']*)""")
ONCE = ("main", "h1")


class _Elements(HTMLParser):
    """[(tag, attributes)] of a page that need not be XML."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))


def elements(text, ours):
    """[(tag, attributes)]. A page of ours has to be XML as well: a browser accepts more, and a fault would be seen by nobody."""
    return [(one.tag.rpartition("}")[2], one.attrib) for one in XML.fromstring(text).iter()] if ours else _Elements(text).found


def faults(folder, ours=lambda name: True):
    """One line per fault; `ours` says which pages have to be well-formed, the others were rendered before."""
    folder = Path(folder)
    pages = {}
    for path in sorted(folder.rglob("*.html")):
        name, text = str(path.relative_to(folder)), path.read_text(encoding="utf-8")
        try:
            pages[name] = elements(text, ours(name))
        except XML.ParseError as error:
            yield f"{name}: {error}"
            continue
        yield from _elsewhere(name, text)
        tags = Counter(tag for tag, _ in pages[name])
        yield from (f"{name}: {tags[tag]} elements {tag}; write one" for tag in ONCE if ours(name) and tags[tag] != 1)
    ids = {name: Counter(attributes["id"] for _, attributes in found if attributes.get("id")) for name, found in pages.items()}
    for name, found in pages.items():
        yield from (f"{name}: {count} elements have the id {one}" for one, count in ids[name].items() if count > 1 and ours(name))
        for tag, attributes in found:
            if tag == "img" and "alt" not in attributes:
                yield f"{name}: a picture without a text: {attributes.get('src')}"
            for attribute, url in attributes.items():
                loaded = attribute in LOADED or (attribute == "href" and tag in LOADING)
                if loaded and ABSOLUTE.match(url or ""):
                    yield f"{name}: loads {url} from elsewhere"
                elif url and (loaded or attribute == "href") and not re.match(r"[a-z]+:", url):
                    yield from _unresolved(folder, name, url, ids)
    for path in sorted(folder.rglob("*.css")):
        yield from _elsewhere(path.relative_to(folder), path.read_text(encoding="utf-8"))


def _elsewhere(name, text):
    return (f"{name}: loads {a or b} from elsewhere" for a, b in FETCHED.findall(text))


def _unresolved(folder, name, url, ids):
    path, _, anchor = url.partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(name), urllib.parse.unquote(path.partition("?")[0]))) if path else name
    if path.startswith("/"):
        yield f"{name}: the link {url} is not relative"
    elif target.startswith("..") or not (folder / target).is_file():
        yield f"{name}: the link {url} leads nowhere"
    elif anchor and target in ids and urllib.parse.unquote(anchor) not in ids[target] and not target.startswith("playground/"):
        yield f"{name}: {target} has no anchor {anchor}"
