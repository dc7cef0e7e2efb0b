# SPDX-License-Identifier: MIT
"""Text that comes from a bundle, whoever wrote it, as part of the report's own texts.

Our texts have two marks, `code` and **strong**. `literal` puts private characters in the place of a bundle's backticks and
asterisks, so that nothing that a bundle says is taken for a mark; `restored` puts them back when the text is written. Characters
that act on a terminal, end a line or turn the direction of writing become visible.
"""

import re

_STAND_INS = {"`": "\ue000", "*": "\ue001"}
_BACK = str.maketrans({private: own for own, private in _STAND_INS.items()})
# Control and format characters, line and paragraph separators, surrogates, private use.
_ACTING = re.compile("[\0-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff\ue000-\uf8ff\ufeff"
                     "\ufff9-\uffff\U000e0000-\U0010ffff]")
_MARKS = re.compile("[`*]")


def visible(text):
    """One line in which every character can be seen: a tab is \\t, an escape \\x1b."""
    return _ACTING.sub(lambda found: found[0].encode("unicode_escape").decode("ascii"), text)


def literal(text):
    """Foreign text for a text of ours."""
    return _MARKS.sub(lambda found: _STAND_INS[found[0]], visible(text))


def literal_json(value):
    """`literal` for every text in what json.loads returns, keys included."""
    if isinstance(value, dict):
        return {literal(key): literal_json(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [literal_json(inner) for inner in value]
    return literal(value) if isinstance(value, str) else value


def restored(text):
    """The text with the bundle's own backticks and asterisks again."""
    return text.translate(_BACK)


def one_line(text):
    """A message for a terminal, whatever file names and fields it repeats."""
    return visible(restored(str(text)))
