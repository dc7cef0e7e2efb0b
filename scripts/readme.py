#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Fills in the parts of README.md and docs/*.md that are data, from the committed bundles and from the program.

readme.py            compares, and exits 1 where a page differs from what the bundles give
readme.py --update   writes them
readme.py --program PROGRAM   also compares what only PROGRAM can say: its methods, suites and generators. Checks with PROGRAM that
                              each bundle is as it was written, and that PROGRAM still has every method of the baseline
                              with the facts that the baseline states about it

Such a part stands between the lines <!-- begin NAME --> and <!-- end NAME -->.
"""
import argparse
import csv
import functools
import io
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle  # noqa: E402
from report.wording import listing  # noqa: E402
from scripts.pages import bundles, figure, index, methods, program  # noqa: E402
from scripts.pages.answers import answers  # noqa: E402

WORDING = ("citation",)  # columns of methods.csv whose wording may change; they have no numbers of a bundle
PART = re.compile(r"(<!-- begin ([a-z_]+) -->\n).*?(<!-- end \2 -->)", re.DOTALL)
PARTS = {"answers": lambda _page: answers(Bundle(bundles.ANSWERS), bundles.real()), "figure": lambda page: figure.picture(Bundle(bundles.ANSWERS), page),
         "printed": bundles.printed, "printed_orders": bundles.printed_orders, "scorecard": bundles.scorecard,
         "digest": bundles.digest, "gates": bundles.gates, "doors": index.doors, "index": index.index, "statements": program.statements}
PARTS_OF_PROGRAM = {"methods": methods.methods, "generators": program.generators,
                    "questions": index.questions}


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def judged_methods():
    """The ids of evaluators and conversions whose errors are in the baseline's tables."""
    ids = set()
    for name, column in (("accuracy.csv", "method"), ("conversion.csv", "conversion")):
        with open(bundles.BASELINE / name, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                ids.update(re.split("[:+]", row[column]))
    return ids


def differing_method(listed, baseline, judged):
    """The id of the first of the `judged` methods in `baseline` whose facts differ in `listed`; None if there is
    none. Columns that the baseline does not have yet are not facts of it."""
    def facts(text):
        return [{column: field for column, field in row.items() if column not in WORDING}
                for row in csv.DictReader(io.StringIO(text))]
    known = facts(listed)
    return next((row["id"] for row in facts(baseline)
                 if row["id"] in judged and not any(row.items() <= one.items() for one in known)), None)


def parts(binary):
    """{name: what writes that part of a page}; None where only a program could, and there is none."""
    of_program = {name: functools.partial(make, program=binary) if binary else None for name, make in PARTS_OF_PROGRAM.items()}
    return PARTS | of_program


def filled(page, text, made):
    """The text of a page with its parts as they should be."""
    def fill(match):
        name = match[2]
        if name not in made:
            sys.exit(f"{page.relative_to(ROOT)}: no part is called {name}; scripts/readme.py knows {listing(made)}")
        return match[0] if made[name] is None else f"{match[1]}\n{made[name](page)}\n\n{match[3]}"
    return PART.sub(fill, text)


def new_lines(text, wanted):
    """The ids of methods, suites and generators of the program that are not on a page. Empty if anything else differs: what is added alone
    needs no update."""
    ours, theirs = text.splitlines(), wanted.splitlines()
    more = [line for line in theirs if line not in set(ours)]
    if not all(line.startswith(("| `", "| [`")) for line in more) or ours != [line for line in theirs if line not in set(more)]:
        return []
    return [line.split("`")[1] for line in more]


def compare(page, text, wanted):
    """A fault as one line; None where the page is as it should be, or is only without what was added, which is reported."""
    name = page.relative_to(ROOT)
    if new := new_lines(text, wanted):
        print(f"{name}: without {listing(new)}, which the program has; scripts/readme.py --update --program PROGRAM adds it")
    elif wanted != text:
        line = next((at for at, pair in enumerate(zip(text.splitlines(), wanted.splitlines()), 1) if pair[0] != pair[1]), "the end")
        return f"{name}:{line}: not what results and the program say; run scripts/readme.py --update --program PROGRAM"
    return None


def settle_figure(update):
    """A fault as one line; None where the figure is of the committed bundle."""
    bundle = Bundle(bundles.ANSWERS)
    if figure.described() == figure.words(bundle):
        return None
    if not update:
        return f"{figure.FILE.relative_to(ROOT)}: not of results/answers; run scripts/readme.py --update"
    figure.write(bundle)
    return None


def check_bundles(binary):
    for bundle in bundles.committed_bundles():
        if subprocess.run([binary, "verify", bundle], stdout=subprocess.DEVNULL, check=False).returncode != 0:
            sys.exit(f"{bundle.relative_to(ROOT)}: not as it was written; restore it")
    differing = differing_method(program.method_list_of(binary), (bundles.BASELINE / "methods.csv").read_text(encoding="utf-8"),
                                 judged_methods())
    if differing:
        sys.exit(f"results/baseline/methods.csv: {differing} is not as the program lists it; run scripts/check golden --update")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--program", metavar="PROGRAM", type=lambda text: Path(text).resolve())
    options = parser.parse_args()
    made = parts(options.program)
    there = {page: page.read_text(encoding="utf-8") for page in pages()}
    if missing := set(made) - {match[2] for text in there.values() for match in PART.finditer(text)}:
        sys.exit(f"no page has the part {listing(sorted(missing))}, between <!-- begin NAME --> and <!-- end NAME -->")
    faults = [fault for fault in [settle_figure(options.update)] if fault]
    for page, text in there.items():
        wanted = filled(page, text, made)
        if options.update:
            page.write_text(wanted, encoding="utf-8")
        elif fault := compare(page, text, wanted):
            faults.append(fault)
    if faults:
        sys.exit("\n".join(faults))
    if options.program:
        check_bundles(options.program)
    print("README.md and docs agree with results")


if __name__ == "__main__":
    main()
