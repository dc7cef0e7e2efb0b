# SPDX-License-Identifier: MIT
"""Files of the repository as pages: where each lies in the site, and its Markdown as HTML whose links stay within the site.

A page's path mirrors its file's. Whatever a page links to becomes a page, too: documents rendered, sources as they are read, folders as
lists. So no link leaves the site, and it works from a folder and from any sub-path.
"""
import html
import os
import posixpath
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path, PurePosixPath

from scripts.pages.figure import DARK, for_both_screens

ROOT = Path(__file__).resolve().parents[2]
PLACES = (("docs", "docs"), ("results/pages/atlas", "atlas"), ("results/pages", "pages"))  # folder of the repository: of the site
ELSEWHERE = "files"
AS_THEY_ARE = (".svg", ".png", ".html", ".csv", ".tex")
READ = ("pandoc", "--from=gfm+tex_math_dollars", "--to=html5", "--mathml", "--wrap=preserve", "--no-highlight")
LINK = re.compile(r'(<(?:a|img)\b[^>]*? (?:href|src)=")([^"]*)(")')
LONG = 40  # characters of TeX, above which a formula scrolls by itself: browsers do not break it
OUTSIDE = re.compile(r"[a-z]+:")


class Fault(Exception):
    """What is wrong and what to do, in one line."""


def place(path):
    """Where a file or folder of the repository, a path from its root, lies in the site."""
    path = str(path)
    if (ROOT / path).is_dir():
        return place(posixpath.join(path, "README.md")) if (ROOT / path / "README.md").exists() else f"{ELSEWHERE}/{path}/index.html"
    for folder, there in PLACES:
        if path.startswith(folder + "/"):
            path = there + path.removeprefix(folder)
            break
    else:
        path = f"{ELSEWHERE}/{path}"
    if path.endswith("/README.md"):
        return path.removesuffix("README.md") + "index.html"
    if path.endswith(AS_THEY_ARE):
        return path
    return path.removesuffix(".md") + ".html"


def _pandoc(text):
    """Markdown of GitHub's dialect as HTML, formulas as MathML. Its TeX has sizes of delimiters that pandoc does not know."""
    text = re.sub(r"\\Big([lr])", r"\\big\1", text)
    done = subprocess.run(READ, input=text, capture_output=True, text=True, encoding="utf-8", check=False)
    if done.returncode or done.stderr:
        raise Fault(f"pandoc: {done.stderr.strip().splitlines()[0]}; correct it there")
    found = re.sub(r"<math\b.*?</math>", _readable, done.stdout.replace("<br>", "<br />"), flags=re.DOTALL)
    for own in re.findall(r'<a id="([^"]*)">', found):  # pages of the report name their headings themselves
        found = re.sub(rf'(<h\d) id="{re.escape(own)}"', r"\1", found)
    return found


def _readable(formula):
    """MathML as browsers read it, which know no style for several letters: a word is text. Brackets grow around fractions alone."""
    text = re.sub(r'<mstyle mathvariant="normal">((?:<mi>\w</mi>)+)</mstyle>', lambda word: f"<mtext>{re.sub('<.?mi>', '', word[1])}</mtext>", formula[0])
    tex = re.search(r"<annotation\b[^>]*>(.*?)</annotation>", text, re.DOTALL)
    text = re.sub(r"<annotation\b.*?</annotation>|</?semantics>", "", text, flags=re.DOTALL)
    if "<mfrac>" not in text:
        text = re.sub(r'<mo stretchy="true" form="prefix">([(|])</mo>(?!<mfrac)', r'<mo stretchy="false" form="prefix">\1</mo>', text)
        text = re.sub(r'(?<!</mfrac>)<mo stretchy="true" form="postfix">([)|])</mo>', r'<mo stretchy="false" form="postfix">\1</mo>', text)
    if 'display="block"' in text:
        return text.replace("<math ", '<math tabindex="0" ', 1)
    return f'<span class="wide" tabindex="0">{text}</span>' if tex and len(tex[1]) > LONG else text


def to_html(texts):
    """{key: HTML} of {key: Markdown}"""
    def one(item):
        try:
            return item[0], _pandoc(item[1])
        except Fault as fault:
            raise Fault(f"{item[0]}: {fault}") from None
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(pool.map(one, texts.items()))


def scrolling(body):
    """Tables within boxes that scroll, so that a page never does sideways; what scrolls can be focused."""
    body = body.replace("<pre", '<pre tabindex="0"')
    return re.sub(r"<table\b.*?</table>", lambda table: f'<div class="scroll" tabindex="0">{table[0]}</div>', body, flags=re.DOTALL)


def linked(body, source, seen, at=None):
    """HTML with its links to files of the repository as links of the site. `seen` collects these files; `at` is the page's place in the site."""
    at = at or place(source)

    def within(match):
        url, _, anchor = html.unescape(match[2]).partition("#")
        if not url or OUTSIDE.match(url):
            return match[0]
        target = posixpath.normpath(posixpath.join(posixpath.dirname(str(source)), url))
        if not (ROOT / target).exists():
            raise Fault(f"{source}: links to {url}, which is not there; correct the link")
        seen.add(target)
        there = posixpath.relpath(place(target), posixpath.dirname(at) or ".")
        return match[1] + html.escape(there + (f"#{anchor}" if anchor else "")) + match[3]
    return LINK.sub(within, body)


def title_of(body, path):
    found = re.search(r"<h1[^>]*>(.*?)</h1>", body, re.DOTALL)
    return html.unescape(re.sub(r"<[^>]*>", "", found[1])).replace("\n", " ") if found else str(path)


def source_text(path):
    """A source or a folder as a page's body: what a link to it leads to."""
    name = html.escape(str(path))
    if (ROOT / path).is_dir():
        names = sorted(one.name + "/" * one.is_dir() for one in (ROOT / path).iterdir() if not one.name.startswith((".", "__")))
        inner = "<p>A folder of the repository, which holds:</p>\n<ul>" + "".join(f"<li><code>{html.escape(one)}</code></li>" for one in names) + "</ul>"
    else:
        text = (ROOT / path).read_text(encoding="utf-8")
        inner = f'<pre class="source" tabindex="0"><code>{html.escape(text, quote=False)}</code></pre>'
    return f"<h1><code>{name}</code></h1>\n{inner}"


def picture(svg):
    """A drawing in the colours of the reader's screen: ink and paper of figures; one in colours of its own keeps its white paper."""
    return for_both_screens(svg, "") if "prefers-color-scheme" not in svg and all(colour in svg for colour in DARK) else svg


def documents():
    """The documents and pages from which every link is followed."""
    found = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md"), *(ROOT / "results/pages").rglob("*.md")]
    return sorted(str(PurePosixPath(path.relative_to(ROOT))) for path in found if path.name != "report.md")
