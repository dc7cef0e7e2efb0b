#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""Fills in the parts of README.md that are numbers, from the committed bundles.

readme.py            compares, and exits 1 where README.md differs from what the bundles give
readme.py --update   writes them
readme.py --program PROGRAM   also compares what only PROGRAM can say: its methods and its comparison of the committed bundles.
                              Checks with PROGRAM that each bundle is as it was written, and that PROGRAM still has every
                              method of the baseline with the facts that the baseline states about it
"""
import argparse
import csv
import functools
import io
import json
import re
import subprocess
import sys
import tempfile
import textwrap
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle, Comparison, Folder  # noqa: E402
from report.chapters import method_list  # noqa: E402
from report.chapters.scorecard import VERDICTS, counts  # noqa: E402
from scripts.digests import Agreement  # noqa: E402
from report.wording import listing  # noqa: E402
RESULTS = ROOT / "results"
BASELINE = RESULTS / "baseline"
OTHER_BUILD = RESULTS / "clang"
README = ROOT / "README.md"
WIDTH = 118  # of a line of prose
WORDING = ("citation",)  # columns of methods.csv whose wording may change; they have no numbers of a bundle
TIMES = "2.4"  # the table of the report that prints times
SAID = {"inside": "inside the band that chance allows", "explained": "outside it for a stated cause", "outside": "outside it without a known cause",
        "untestable": "untestable, since they are no more than one tick of the report's clock"}


def table(header, body):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(field) for field in line) + " |" for line in body]
    return "\n".join(lines)


def scorecard():
    body = [[number, *(found[verdict] for verdict in VERDICTS), found.total()] for number, found in counts(Bundle(BASELINE)).items()]
    return table(["table of the report", *VERDICTS, "printed cells"], body)


def printed():
    """The numbers of printed cells by verdict, for errors and times separately, as sentences."""
    tables = counts(Bundle(BASELINE))
    times = tables.pop(TIMES)
    lines = [f"Of the {found.total()} {what}, "
             + listing(f"{found[verdict]} {'is' if found[verdict] == 1 else 'are'} {SAID[verdict]}" for verdict in VERDICTS if found[verdict])
             for what, found in ((f"errors and counts that it prints (tables {listing(tables)})", sum(tables.values(), Counter())),
                                 (f"times (table {TIMES}), measured on another machine", times))]
    return textwrap.fill(". ".join(lines) + ".", WIDTH)


def digest_of(bundle):
    return json.loads((bundle / "bundle.json").read_text(encoding="utf-8"))["accuracy_digest"]


def committed_bundles():
    return sorted(path.parent for path in RESULTS.glob("*/bundle.json"))


def timings(bundle):
    path = bundle / "timing.csv"
    if not path.exists():
        return "none"
    found = [row["quality"] for row in csv.DictReader(io.StringIO(path.read_text(encoding="utf-8")))]
    noisy = sum(quality != "ok" for quality in found)
    return f"{len(found)}, {noisy} of them noisy" if noisy else str(len(found))


def agreement(bundle):
    """How many methods of a committed bundle agree with the baseline, as text. Ends the program where one differs."""
    found = Agreement(BASELINE, bundle)
    if found.differing:
        sys.exit("\n".join([f"{bundle.relative_to(ROOT)}: differs from {BASELINE.relative_to(ROOT)}, {found.counts()}", *found.named(),
                            "make the bundle anew on a machine of its kind, or remove it"]))
    alone = {"more in the baseline": found.only_base, "only here": found.only_other}
    return ", ".join([f"{len(found.agreeing)} agree", *(f"{len(rows)} {where}" for where, rows in alone.items() if rows)])


def digest():
    """The baseline's digest, then a table of the committed bundles: where each was made and how many methods agree."""
    body = []
    for bundle in committed_bundles():
        name = bundle.relative_to(ROOT)
        machine = json.loads((bundle / "machine.json").read_text(encoding="utf-8"))
        body.append([f"[{name}]({name})", machine["build"]["compiler"], machine["system"]["libc"], machine["cpu"]["model_name"],
                     timings(bundle), agreement(bundle)])
    heads = ["bundle", "compiler", "C library", "processor", "timings", "methods in studies"]
    return f"    {digest_of(BASELINE)}\n\n" + table(heads, body)


class Listing(Folder):
    """The output of `list methods` as a folder that the report's code can read."""

    writer = "bezierbench list methods --format csv"

    def __getitem__(self, name):
        return self._csv(self.path / name)


def method_list_of(program):
    """Our own methods as CSV, without peers, which depend on what a machine has installed."""
    text = subprocess.run([program, "list", "methods", "--format", "csv"], check=True, capture_output=True, text=True).stdout
    return "".join(line for line in text.splitlines(keepends=True) if not line.startswith("peer_"))


def methods(program):
    """The program's methods in the columns of the report's chapter."""
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "methods.csv").write_text(method_list_of(program), encoding="utf-8")
        listed = method_list.listed(Listing(place))
    body = [[write(row).replace("|", "\\|") for _, write in method_list.COLUMNS] for row in listed]
    return table([heading for heading, _ in method_list.COLUMNS], body)


def compared(program):
    """The rows of `compare`, from the committed build to the other."""
    with tempfile.TemporaryDirectory() as place:
        done = subprocess.run([program, "compare", BASELINE.relative_to(ROOT), OTHER_BUILD.relative_to(ROOT), "--out", place],
                              cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(done.stderr.strip() or "compare failed")
        return Comparison(place)


def comparison(program):
    """A description of both builds, then the ratios of the times in the mode for prepared curves."""
    found = compared(program)
    judged = [row for row in found.rows.rows if row["kind"] == "accuracy"]
    times = [row for row in found.rows.rows if row["kind"] == "timing" and row["degree"] is not None]
    places = {Path(row["bundle"]).name: f"{row['compiler']} on {row['cpu']}" for row in found.standings.rows}
    one_machine = all(row["machine"] == "same" for row in found.standings.rows)
    ratio, verdict = ("ratio", "verdict") if one_machine else ("normalised", "normalised_verdict")
    unit = "" if one_machine else ", each in units of the sentinel of its own machine"
    found_of = Counter(row[verdict] for row in times)
    noisy = sum(row["quality"] != "ok" for row in times)
    words = (f"a is {places[BASELINE.name]}, b is {places[OTHER_BUILD.name]}. Accuracy: identical, bit for bit, in all "
             f"{len(judged)} common rows. Time of b over time of a{unit}: "
             + ", ".join(f"{word} in {found_of[word]}" for word in ("faster", "slower", "same", "unresolved"))
             + f" of {len(times)}, {noisy} of them from noisy races, marked ~. By degree, where curves are prepared and evaluated "
             "one point at a time:")
    point = [row for row in times if row["mode"] == "point"]
    degrees = sorted({row["degree"] for row in point})
    cells = {(row["curve"], row["method"], row["degree"]): row for row in point}
    body = [[curve, f"`{method}`"] + [f"{cells[curve, method, n][ratio]:.2f}"
                                      + ("" if cells[curve, method, n]["quality"] == "ok" else " ~") for n in degrees]
            for curve, method in dict.fromkeys((row["curve"], row["method"]) for row in point)]
    return textwrap.fill(words, WIDTH) + "\n\n" + table(["curve", "method", *(f"n = {n:.0f}" for n in degrees)], body)


def judged_methods():
    """The ids of evaluators and conversions whose errors are in the baseline's tables."""
    ids = set()
    for name, column in (("accuracy.csv", "method"), ("conversion.csv", "conversion")):
        with open(BASELINE / name, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                ids.update(re.split("[:+]", row[column]))
    return ids


def differing_method(listed, baseline, judged):
    """The id of the first of the `judged` methods in `baseline` whose facts differ in `listed`; None if there is
    none. Columns that the baseline does not have yet are no facts of it."""
    def facts(text):
        return [{column: field for column, field in row.items() if column not in WORDING}
                for row in csv.DictReader(io.StringIO(text))]
    known = facts(listed)
    return next((row["id"] for row in facts(baseline)
                 if row["id"] in judged and not any(row.items() <= one.items() for one in known)), None)


PARTS = {"printed": printed, "scorecard": scorecard, "digest": digest}
PARTS_OF_PROGRAM = {"comparison": comparison, "methods": methods}


def filled(text, program):
    parts = dict(PARTS)
    if program:
        parts |= {name: functools.partial(make, program) for name, make in PARTS_OF_PROGRAM.items()}
    for name, make in parts.items():
        pattern = re.compile(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)", re.DOTALL)
        if not pattern.search(text):
            sys.exit(f"README.md: no part between <!-- begin {name} --> and <!-- end {name} -->")
        part = make()
        text = pattern.sub(lambda match: f"{match[1]}\n{part}\n\n{match[2]}", text)
    return text


def new_methods(text, wanted):
    """The methods of the program that README.md lacks. Empty if anything else differs: an added method alone needs no
    update."""
    ours, theirs = text.splitlines(), wanted.splitlines()
    more = [line for line in theirs if line not in set(ours)]
    if not all(line.startswith("| `") for line in more) or ours != [line for line in theirs if line not in set(more)]:
        return []
    return [line.split("`")[1] for line in more]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--program", metavar="PROGRAM", type=lambda text: Path(text).resolve())
    options = parser.parse_args()
    text = README.read_text(encoding="utf-8")
    wanted = filled(text, options.program)
    if options.update:
        README.write_text(wanted, encoding="utf-8")
    elif new := new_methods(text, wanted):
        print(f"README.md: lacks {listing(new)}, which the program has; scripts/readme.py --update --program PROGRAM adds it")
    elif wanted != text:
        sys.exit("README.md: its numbers are not those of results; run scripts/readme.py --update --program PROGRAM")
    if options.program:
        for bundle in committed_bundles():
            if subprocess.run([options.program, "verify", bundle], stdout=subprocess.DEVNULL, check=False).returncode != 0:
                sys.exit(f"{bundle.relative_to(ROOT)}: not as it was written; restore it")
        differing = differing_method(method_list_of(options.program), (BASELINE / "methods.csv").read_text(encoding="utf-8"),
                                     judged_methods())
        if differing:
            sys.exit(f"results/baseline/methods.csv: {differing} is not as the program lists it; run scripts/check golden "
                     "--update")
    print("README.md agrees with results")


if __name__ == "__main__":
    main()
