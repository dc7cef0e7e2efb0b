# SPDX-License-Identifier: MIT
"""What the header of a method says: the labelled lines of its comment, its label, and the function that is the method."""
import functools
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CORE = ROOT / "core"
SECTION = re.compile(r"([A-Z][a-z]+): ")
PROOF = re.compile(r"docs/proofs/\w+\.md")
# The functions that are the methods, of evaluators and conversions first; the first that there is.
FUNCTIONS = ("evaluate", "convert", "split", "project", "measure", "find", "flatten", "range", "run", "solve")
LONGEST = 34  # lines of a function that is shown whole


@dataclass(frozen=True)
class Header:
    path: str  # from the root of the repository
    sections: tuple  # of (label, [paragraphs])
    text: str

    @property
    def proofs(self):
        return tuple(dict.fromkeys(PROOF.findall(self.text)))


def _sections(text):
    """[(label, paragraphs)] of the comment that opens a header; a line that is set off is a paragraph of its own."""
    found = []
    for line in text.splitlines()[1:]:
        if not line.startswith("//"):
            break
        words = line[2:].removeprefix(" ")
        label = SECTION.match(words)
        if label:
            found.append((label[1], [words[label.end():]]))
        elif found and words.strip():
            paragraphs, inner = found[-1][1], words.strip()
            off = words.startswith("    ") or re.match(r"[a-zA-Z][\w -]{2,40}: ", inner) or (paragraphs[-1].endswith(";") and "=" in inner.split(" for ")[0])
            if off:
                paragraphs.append(inner)
            else:
                paragraphs[-1] += " " + inner
    return tuple(found)


@functools.cache
def all_headers():
    """Every header of core that states a formula."""
    found = []
    for path in sorted(CORE.rglob("*.hpp")):
        text = path.read_text(encoding="utf-8")
        if re.search(r"^// Formula: ", text, re.MULTILINE):
            found.append(Header(str(path.relative_to(ROOT)), _sections(text), text))
    return tuple(found)


@functools.cache
def of(method):
    """The headers of a method's id: those that spell it, or, where ids are made of parts, the beginning of it."""
    spelled = tuple(one for one in all_headers() if f'"{method}"' in one.text)
    return spelled or tuple(one for one in all_headers() if any(method.startswith(start) for start in re.findall(r'Literal<"(\w+[_:])"', one.text)))


def label(method, header):
    found = re.search(rf'"{re.escape(method)}"[,;]\s*(?:static constexpr std::string_view label = |\w*\.label =\s*)"([^"]*)"', header.text)
    return found[1] if found else ""


def _definition(name, text):
    """The function of this name, a member or a free one, without its indentation."""
    found = re.search(rf"^(?P<indent> *)(?:template <[^\n]*>\n *)?[^\n/=;]*\b{name}\((?:[^;{{}}]|\{{\}})*?\{{\n.*?^(?P=indent)\}}$", text,
                      re.MULTILINE | re.DOTALL)
    return "\n".join(line.removeprefix(found["indent"]) for line in found[0].splitlines()) if found else ""


def code(method, header):
    """The function that is the method, with those of its header that it calls, or at most LONGEST lines of it alone; where a header
    only composes others, what it composes."""
    at = header.text.find(f'"{method}"')
    start = max(header.text.rfind("\nstruct ", 0, at), 0) if at >= 0 else 0
    for text in (header.text[start:], header.text):
        for name in FUNCTIONS:
            if function := _definition(name, text):
                called = [_definition(word, header.text) for word in dict.fromkeys(re.findall(r"\b(\w+)\(", function)) if word != name]
                whole = "\n".join([*(text for text in called if text), function])
                return _cut(whole if whole.count("\n") < LONGEST else function)
    composed = re.search(r"^(?:template <[^\n]*>\n)?(?:struct|using) .*?(?=\n\}  // namespace)", header.text[max(start, header.text.find("namespace bezierbench {")):],
                         re.MULTILINE | re.DOTALL)
    return _cut(composed[0]) if composed else ""


def _cut(text):
    lines = text.splitlines()
    dedented = [line.removeprefix("  ") for line in lines] if lines[0].startswith("  ") else lines
    return "\n".join(dedented if len(lines) <= LONGEST else [*dedented[:LONGEST - 1], "  // ..."])
