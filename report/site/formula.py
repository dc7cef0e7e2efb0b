# SPDX-License-Identifier: MIT
"""The plain text of headers, `b_i^k = (1-t) b_i^(k-1), p(t) = b_0^n for t <= 1/2`, as HTML: what is mathematics becomes MathML, by way
of TeX and pandoc; words stay words."""
import html
import re

GREEK = "alpha beta gamma delta epsilon eta theta kappa lambda phi pi rho sigma tau"
OPERATORS = "fma pow fl asinh sign cbrt"
PRODUCTS = "dn nk ik kj mn dC dM dh dt"  # of two letters, not words
NAMED = {"log2": r"\log_2", "floor": "", "ceil": "", **{name: f"\\{name}" for name in f"min max cos sin ln log sum prod sqrt {GREEK}".split()},
         **{name: rf"\operatorname{{{name}}}" for name in OPERATORS.split()}}
SIGNS = {"<=": r"\le ", ">=": r"\ge ", "!=": r"\ne ", "+-": r"\pm ", "-+": r"\mp ", "->": r"\to ", "<-": r"\leftarrow ", "..": r"\ldots ", "...": r"\dots ",
         "*": r"\cdot ", "~": r"\approx ", "{": r"\{", "}": r"\}", "%": r"\%"}
AROUND = {"floor": (r"\lfloor ", r"\rfloor "), "ceil": (r"\lceil ", r"\rceil "), "sqrt": (r"\sqrt{", "}")}
CLOSING = {"(": ")", "[": "]"}
DERIVED = ("C", "A", "W")  # C^(k) is a derivative, not a power
ARTICLES = ("the", "this", "that", "each", "into")
JOINING = ("and", "or", "is", "in", "to", "times")
TOKEN = re.compile(rf"""(?P<prose>`[^`]+`|\[[^\]\[]*[ ](?:\d{{4}}|\d{{3}})\](?:'s\b)?|[\w/]+\.(?:hpp|md|csv|cpp)\b|\b[CG][12]\b|\d+x\d+|\b[a-z]-th\b|\d*[.]?\d+[ ]%)
  |(?P<named>(?:{'|'.join(NAMED)})(?![A-Za-z0-9]|_[a-z]{{2}}))
  |(?P<letter>[A-Z](?=[A-Z]')|(?:{'|'.join(PRODUCTS.split())})(?![A-Za-z])|[A-Za-z](?![A-Za-z])(?:\d(?![\d._]))?~?'*)
  |(?P<word>(?:[A-Za-z]{{2,}}\d*|[a-z]\d)(?:[_:][A-Za-z0-9]{{2,}}|_[a-z](?=_))+|[A-Za-z]{{2,}}\d*(?:[-'’][A-Za-z]+)*)
  |(?P<number>\d{{1,3}}(?:,\d{{3}})+|\d+(?:\.\d+)?(?:e-?\d+)?(?![0-9])(?:'+(?!\w))?)
  |(?P<sign>\.{{2,3}}|<=|>=|!=|->|<-|\+-|-\+|[-+*/=<>|!^_~])
  |(?P<open>[(\[])|(?P<close>[)\]])|(?P<space>\s+)|(?P<other>.)""", re.VERBOSE)


def _tokens(text):
    """[kind, text, whether it is mathematics] of each token; brackets are it where what they enclose is."""
    text = re.sub(r"\b([PC])(\d),(\w|\([^)]*\))", r"\1_(\2,\3)", text)  # P1,i
    found = [[match.lastgroup, match[0], match.lastgroup in ("named", "number", "letter", "sign")] for match in TOKEN.finditer(text)]
    none = ["other", "", False]

    def next_to(at, step):
        at += step
        while 0 <= at < len(found) and found[at][0] == "space":
            at += step
        return found[at] if 0 <= at < len(found) else none

    for at, (kind, word, _) in enumerate(found):
        before, after = (found[at - 1] if at else none), (found[at + 1] if at + 1 < len(found) else none)
        follows = next_to(at, 1)
        if word == "A" and next_to(at, -1)[1] in ("", ".") and after[0] == "space" and follows[0] != "sign":
            found[at][2] = False
        elif word in ("a", "A", "I") and after[0] == "space" and next_to(at, -1)[0] != "sign":
            found[at][2] = not (follows[0] in ("prose", "number") or (follows[0] == "word" and follows[1] not in JOINING))
        elif word in ("sum", "prod", "sign"):
            found[at][2] = next_to(at, -1)[1] not in ARTICLES and (after[1] in ("_", "(") or (
                word != "sign" and (follows[0] in ("letter", "named", "open") or follows[1] == "|")))
        elif kind == "word" and before[1] == "_":
            found[at] = ["part", word, True]  # S_left
        elif word == "." and before[0] in ("letter", "number", "close", "part") and (after[0] == "letter" or after[1] == "("):
            found[at] = ["dot", r"\cdot ", True]
    opened = []
    for at, (kind, word, _) in enumerate(found):
        if kind == "open":
            opened.append(at)
        elif kind == "close" and opened and CLOSING[found[opened[-1]][1]] in word + "])":
            start = opened.pop()
            inner = found[start + 1:at]
            if inner and all(token[2] or token[0] == "space" or token[1] == "," for token in inner) and any(token[2] for token in inner):
                for token in (found[start], found[at], *inner):
                    token[2] = True
    return found


def _script(tokens, at):
    """(TeX of the index or exponent that begins at `at`, where it ends): a group in brackets, or as much as stands without a blank."""
    if at < len(tokens) and tokens[at][1] == "(":
        end = _matching(tokens, at)
        return _tex(tokens[at + 1:end]), end + 1
    if at < len(tokens) and tokens[at][1] == "-":
        inner, end = _script(tokens, at + 1)
        return "-" + inner, end
    end = at + 1
    if at < len(tokens) and tokens[at][0] == "number" and end < len(tokens) and tokens[end][0] == "letter":
        end += 1  # gamma_3n
    while end + 1 < len(tokens) and tokens[end][1] == "," and tokens[end + 1][0] == "letter":
        end += 4 if end + 3 < len(tokens) and tokens[end + 2][1] == "-" and tokens[end + 3][0] == "letter" else 2  # B_j,k and B_i,n-k
    return _tex(tokens[at:end]), end


def _matching(tokens, at):
    depth = 0
    for end in range(at, len(tokens)):
        depth += (tokens[end][0] == "open") - (tokens[end][0] == "close")
        if depth == 0:
            return end
    return len(tokens) - 1


def _number(text):
    digits, _, exponent = text.replace(",", "{,}").partition("e")
    power = f"10^{{{exponent}}}"
    return digits if not exponent else power if digits == "1" else rf"{digits} \cdot {power}"


def _letter(text):
    name, primes = text.rstrip("'"), text[len(text.rstrip("'")):]
    body = rf"\tilde {name[0]}" if name.endswith("~") else f"{name[0]}_{name[1]}" if name[1:].isdigit() else name
    return body + primes


def _tex(tokens):
    """TeX of tokens that are mathematics."""
    parts, at = [], 0
    while at < len(tokens):
        kind, word, _ = tokens[at]
        at += 1
        if word in ("_", "^"):
            base, grouped = parts[-1] if parts else "", at < len(tokens) and tokens[at][1] == "("
            inner, at = _script(tokens, at)
            primes = inner[len(inner.rstrip("'")):]
            inner = inner.rstrip("'")
            parts.append(f"{word}{{({inner})}}" if word == "^" and grouped and base in DERIVED else f"{word}{{{inner}}}{primes}")
        elif word in AROUND and at < len(tokens) and tokens[at][1] == "(":
            end = _matching(tokens, at)
            parts += [AROUND[word][0], _tex(tokens[at + 1:end]), AROUND[word][1]]
            at = end + 1
        elif word == "C" and at < len(tokens) and tokens[at][1] == "(" and [one[1] for one in tokens[at:_matching(tokens, at)]].count(",") == 1:
            end = _matching(tokens, at)
            comma = next(one for one in range(at, end) if tokens[one][1] == ",")
            parts.append(rf"\binom{{{_tex(tokens[at + 1:comma])}}}{{{_tex(tokens[comma + 1:end])}}}")
            at = end + 1
        elif kind == "number":
            parts.append(_number(word))
        elif kind == "letter":
            parts.append(_letter(word))
        elif kind == "part":
            parts.append(rf"\mathrm{{{word}}}")
        else:
            parts.append(NAMED[word] + " " if kind == "named" else SIGNS.get(word, word))
    return "".join(parts)


def segments(text):
    """[(whether it is mathematics, TeX or words)] of a text. A run of numbers and signs alone, between words, stays as it is."""
    found, run = [], []

    def flush():
        trailing = []
        while run and run[-1][0] == "space":
            trailing.insert(0, run.pop())
        if any(token[0] in ("letter", "named", "dot") or token[1] == "^" for token in run):
            found.append((True, _tex(run).strip()))
        elif run:
            found.append((False, "".join(token[1] for token in run)))
        if trailing:
            found.append((False, "".join(token[1] for token in trailing)))
        run.clear()

    tokens = _tokens(text)
    for at, token in enumerate(tokens):
        before_index = token[1] == "," and run and at + 2 < len(tokens) and tokens[at + 1][0] == "letter" and run[-1][0] == "letter" \
            and any(one[1] == "_" for one in run[-2:])  # B_j,k: no blank, behind an index
        if token[2] or before_index or (token[0] == "space" and run):
            run.append(token)
        else:
            flush()
            found.append((False, token[1]))
    flush()
    joined = []
    for is_math, words in found:
        if joined and not is_math and not joined[-1][0]:
            joined[-1] = (False, joined[-1][1] + words)
        else:
            joined.append((is_math, words))
    return joined


class Typesetter:
    """Makes MathML of all texts at once, then HTML of each."""

    def __init__(self, texts, to_html):
        wanted = sorted({words for text in texts for is_math, words in segments(text) if is_math})
        made = to_html({"formulas of the headers": "\n\n".join(f"${words}$" for words in wanted)})["formulas of the headers"]
        found = re.findall(r"(?:<span[^>]*>)?<math\b.*?</math>(?:</span>)?", made, re.DOTALL)
        if len(found) != len(wanted):
            raise ValueError(f"{len(wanted)} formulas became {len(found)}")
        self.made = dict(zip(wanted, found))

    def __call__(self, text, words=html.escape):
        """HTML; `words` makes it of the other parts."""
        return "".join(self.made[part] if is_math else words(part) for is_math, part in segments(text))
