# SPDX-License-Identifier: MIT
"""All chapters, in the order of the page."""

from importlib import import_module

from ..bundle import Missing, decided_by
from ..document import Chapter
from ..file_names import with_unique_ids

NAMES = """found scorecard tables figures truth ladder regimes conditioning conversion worst rational derivative arc_length
           inverse_arc_length projection interpolation fitting subdivision timing choosing roofline peers comparison audit
           method_list how_measured provenance""".split()
ROSTER = tuple(import_module(f".{name}", __package__) for name in NAMES)


def build_all(bundle, findings):
    """(chapters, [(title, what the bundle lacks)]); a chapter without its data is left out and said to be."""
    chapters, left_out = [], []
    for module in ROSTER:
        try:
            name = module.__name__.rsplit(".", 1)[-1].replace("_", "-")
            with decided_by(bundle, f"the chapter '{module.TITLE}'"):
                chapters.append(Chapter(name, module.TITLE, tuple(module.blocks(bundle, findings))))
        except Missing as lack:
            left_out.append((module.TITLE, str(lack)))
    return with_unique_ids(chapters), left_out
