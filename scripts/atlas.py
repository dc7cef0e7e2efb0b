#!/usr/bin/python3 -I
# SPDX-License-Identifier: MIT
"""The record of what the shipped suites found: a bundle of each in results/atlas, its page in results/pages/atlas.

atlas.py suites PROGRAM        prints the ids of the suites that belong here
atlas.py keep BUNDLE ...       keeps a bundle of one suite and its page; of a bundle above 2 MiB its page and the digests of its rows
atlas.py pages [SUITE ...]     renders the pages of kept bundles (all of them) and the index
atlas.py check PROGRAM         verifies every bundle, and that each has its page, the index names them all, and their size is
                               within the limit; exit 1 where one of these fails
atlas.py sample PROGRAM DIR    runs one deterministic study of every suite into DIR and compares it with the bundle, or with its
                               digests, method by method and bit for bit; exit 1 where rows are missing or differ

A page is Markdown with figures in SVG, which a browser shows where the repository lies. The page with controls, report.html, is made
by `scripts/report results/atlas/SUITE`.
"""
import csv
import io
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle  # noqa: E402
from report.chapters import first_glance  # noqa: E402
from report.findings.roster import find_all  # noqa: E402
from report.inline import to_plain  # noqa: E402
from scripts.digests import Agreement  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
BUNDLES = ROOT / "results/atlas"
PAGES = ROOT / "results/pages/atlas"
INDEX = PAGES / "README.md"
ELSEWHERE = {"report": "../baseline/report.md", "answers": "../../answers", "real": "../../real", "hard_cases": "../../hard_cases/README.md"}
MOST_SECONDS = 120  # of a suite that is run again to be compared
MOST_OF_A_BUNDLE = 2 * 2**20
OF_A_LARGE_BUNDLE = ("bundle.json", "digests.csv")
MOST_BYTES = 16 * 2**20  # of all bundles and pages together


def shipped(program):
    """The suites that the program comes with and that belong here: {id: seconds of processor time, 0 where none are stated}."""
    text = subprocess.run([program, "list", "suites", "--format", "csv"], check=True, capture_output=True, text=True).stdout
    return {row["id"]: float(row["seconds"] or 0) for row in csv.DictReader(io.StringIO(text)) if row["id"] not in ELSEWHERE}


def listed(program):
    """The methods that the program lists, as one text."""
    return subprocess.run([program, "list", "methods"], check=True, capture_output=True, text=True).stdout


def recorded():
    """The suites whose bundles are kept."""
    return sorted(path.name for path in BUNDLES.iterdir() if (path / "SHA256SUMS").exists()) if BUNDLES.exists() else []


def digested():
    """The suites of whose bundles the digests alone are kept."""
    return sorted(path.name for path in BUNDLES.iterdir() if path.name not in recorded()) if BUNDLES.exists() else []


def shown():
    """The suites that have a page."""
    return sorted(path.name for path in PAGES.iterdir() if (path / "README.md").exists()) if PAGES.exists() else []


def toml_of(suite):
    return tomllib.loads((ROOT / f"experiments/suites/{suite}.toml").read_text(encoding="utf-8"))


def size_of(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def keep(bundle):
    suite = bundle.name
    render(bundle, PAGES / suite)
    shutil.rmtree(BUNDLES / suite, ignore_errors=True)
    if size_of(bundle) <= MOST_OF_A_BUNDLE:
        shutil.copytree(bundle, BUNDLES / suite)
    else:
        (BUNDLES / suite).mkdir(parents=True)
        for name in OF_A_LARGE_BUNDLE:
            shutil.copy(bundle / name, BUNDLES / suite)


def render(bundle, page):
    """The page and figures of a suite's bundle, and nothing else."""
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "page"
        subprocess.run([ROOT / "scripts/report", bundle, "--out", out], check=True, stdout=subprocess.DEVNULL)
        shutil.rmtree(page, ignore_errors=True)
        (page / "figures").mkdir(parents=True)
        shutil.copy(out / "report.md", page / "README.md")
        for figure in sorted((out / "figures").glob("*.svg")):
            (page / "figures" / figure.name).write_text(compact(figure.read_text(encoding="utf-8")), encoding="utf-8")


def compact(svg):
    """The same picture in a third less: a style that stands at several elements becomes a class, ids are short, and spaces that mean
    nothing and names of groups that nobody refers to are left out."""
    svg = re.sub(r"(?m)^ +", "", svg)
    svg = re.sub(r'<g id="[A-Za-z_]*\d+">', "<g>", svg)
    for number, one in enumerate(dict.fromkeys(re.findall(r'id="([mp][0-9a-f]{10})"', svg))):
        svg = svg.replace(one, f"{one[0]}{number}")
    uses = Counter(re.findall(r'style="([^"]*)"', svg))
    classes = {style: f"c{number}" for number, (style, count) in enumerate(uses.items()) if count > 1}
    rules = "".join(f".{name}{{{style}}}" for style, name in classes.items())
    svg = re.sub(r'style="([^"]*)"', lambda style: f'class="{classes[style[1]]}"' if style[1] in classes else style[0], svg)
    return svg.replace("</style>", f"{rules}</style>", 1)


def index():
    """The text of the index: what each suite asks, what it found, and how it was judged."""
    lines = ["<!-- written by scripts/atlas.py -->", "# What the suites found", "",
             "One bundle of every shipped suite, recorded on one machine, with its page. Accuracy is the same everywhere, bit for "
             "bit; times are those of the machine that the page names. Sentences are computed from the bundles.", ""]
    for suite in shown():
        if suite not in recorded():
            lines += [f"## [{toml_of(suite)['suite']['title']}]({suite}/README.md)", "",
                      f"Suite `{suite}`: its bundle has more than {MOST_OF_A_BUNDLE // 2**20} MiB; "
                      f"[the digests of its rows](../../atlas/{suite}/digests.csv) are kept.", ""]
            continue
        bundle = Bundle(BUNDLES / suite)
        tiles = {tile.label: tile for block in first_glance.opening(bundle, None) for tile in getattr(block, "items", ())}
        title = bundle.suites.get(suite) or suite
        lines += [f"## [{title}]({suite}/README.md)", "",
                  f"Suite `{suite}`: {tiles['judged'].value} {tiles['judged'].note}; violations: {tiles['violations'].value}; "
                  f"width of ratios: {tiles['times'].value}. [Bundle](../../atlas/{suite}).", ""]
        found, _ = find_all(bundle)
        lines += [f"- {to_plain(finding.headline)}" for finding in found if finding.suite == suite]
        lines.append("")
    lines += ["## Elsewhere", ""] + [f"- [`{suite}`]({place})" for suite, place in ELSEWHERE.items()]
    return "\n".join(lines) + "\n"


def faults(program):
    """A line for each thing that is not as it should be."""
    here = recorded()
    for suite, seconds in shipped(program).items():
        if suite in shown() and suite not in (*here, *digested()):
            yield f"results/atlas/{suite}: neither the bundle nor its digests; make it with scripts/check atlas --update {suite}"
        if suite not in shown() and seconds:  # those of other libraries state none; they need a build of the preset peers
            yield f"suite {suite}: no page in results/pages/atlas; make it with scripts/check atlas --update {suite}"
    for suite in here:
        verified = subprocess.run([program, "verify", BUNDLES / suite], capture_output=True, text=True)
        # That a method is wrong on an input of a race is a result, which the page tells.
        found = [line for line in verified.stderr.splitlines() if "/timing.csv:" not in line]
        if verified.returncode not in (0, 1) or (verified.returncode == 1 and found):
            yield f"results/atlas/{suite}: {(verified.stdout + verified.stderr).strip()}"
        if not (PAGES / suite / "README.md").exists():
            yield f"results/pages/atlas/{suite}: no page; make it with scripts/atlas.py pages {suite}"
    if shown() and INDEX.read_text(encoding="utf-8") != index():
        yield "results/pages/atlas/README.md does not match the bundles; run scripts/atlas.py pages"
    size = size_of(BUNDLES) + size_of(PAGES)
    if size > MOST_BYTES:
        yield f"results/atlas and results/pages/atlas hold {size / 2**20:.1f} MiB, more than {MOST_BYTES / 2**20:g}"


def sampled_study(bundle):
    """The first study whose rows are digested; None in a bundle of times alone."""
    with open(bundle / "digests.csv", newline="", encoding="utf-8") as file:
        return next((row["study"] for row in csv.DictReader(file)), None)


def takes_long(suite, seconds):
    """Whether a suite takes long without its times, in which most of the time of a suite goes that has some."""
    return seconds > MOST_SECONDS and all(study["kind"] != "timing" for study in toml_of(suite)["study"])


def needs_other_libraries(suite, study):
    """Whether a study names methods of other libraries, which only builds of the preset `peers` have."""
    return any(name.startswith("peer_") for one in toml_of(suite)["study"] if one["id"] == study for name in one.get("methods", []))


def sample(program, place):
    """Whether one study of every suite comes out as recorded."""
    holds = True
    seconds = shipped(program)
    for suite in sorted([*recorded(), *digested()]):
        study = sampled_study(BUNDLES / suite)
        if study is None:
            continue
        if needs_other_libraries(suite, study) and "peer_" not in listed(program):
            print(f"{suite}: left out, it needs a build of the preset peers")
            continue
        if takes_long(suite, seconds.get(suite, 0)):
            print(f"{suite}: left out, it takes {seconds[suite]:g} seconds")
            continue
        fresh = Path(place) / suite
        shutil.rmtree(fresh, ignore_errors=True)
        subprocess.run([program, "run", ROOT / f"experiments/suites/{suite}.toml", "--only", study, "--no-timing", "--quiet", "--out", fresh],
                       check=True)
        found = Agreement(BUNDLES / suite, fresh, {study})
        holds &= found.holds()
        print(f"{suite}, study {study}: {found.counts()}", *found.named(), sep="\n", flush=True)
    return holds


def main(arguments):
    match arguments:
        case ["suites", program]:
            print(*shipped(Path(program).resolve()), sep="\n")
        case ["keep" | "pages" as what, *names]:
            PAGES.mkdir(exist_ok=True)
            for name in names or recorded():
                if what == "keep":
                    keep(Path(name).resolve())
                else:
                    render(BUNDLES / name, PAGES / name)
            INDEX.write_text(index(), encoding="utf-8")
        case ["check", program]:
            found = list(faults(Path(program).resolve()))
            print(*(found or ["the atlas is whole"]), sep="\n")
            return 1 if found else 0
        case ["sample", program, place]:
            return 0 if sample(Path(program).resolve(), place) else 1
        case _:
            sys.exit(__doc__)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
