# SPDX-License-Identifier: MIT
"""A page for each method of the program, made of its header, of the program's list and of the committed bundles."""
import csv
import functools
import html
import posixpath
import re
from pathlib import Path

from report.bundle import Bundle
from report.guarantee_words import WORDS, of_all, with_share
from report.rows import grouped
from report.wording import general, shortest
from scripts.pages import answers, bundles, index
from scripts.pages.program import rows_of

from . import drawing, header
from .repository import ROOT, place

ATLAS = ROOT / "results/atlas"
USES = Path(__file__).resolve().parent / "uses.csv"
SEARCHED = {"bernstein": ATLAS / "worst", "power": ATLAS / "worst", "rational": ATLAS / "rational"}
KNOWN = {"bernstein": ("de_casteljau", "horner_bernstein", "compensated_volk_schumaker"), "power": ("horner", "compensated_horner"),
         "rational": ("de_casteljau", "horner_bernstein")}
DRAWN = {"bernstein": answers.NEEDS[0], "rational": next(need for need in answers.NEEDS if need.name == "Rational curve"),
         "power": next(need for need in answers.NEEDS if need.name == "Data in power form")}
JUDGED_BY = {"bernstein": "horner", "power": "de_casteljau"}  # the evaluator behind a conversion, where its errors are shown
FORM = {"bernstein": "Bernstein form", "power": "power form", "rational": "rational curves"}
CURVES = {"bernstein": "Bézier curves", "power": "curves in power form", "rational": "rational curves"}
PROBLEM = {"bspline": "B-splines", "bounds": "boxes", "easing": "easing curves", "grid": "grids", "interpolation": "interpolation",
           "arc_length": "arc length", "inverse_arc_length": "points at a length", "projection": "nearest points"}
MENTIONED = re.compile(r"`([^`]+)`|([\w/]+\.(?:hpp|md)\b)|\b([A-Za-z]\w*_[\w:]*\w)")  # code, a file, a method or header of two words and more


def address(method):
    """The file of a method's page."""
    return f"methods/{method.replace(':', '.')}.html"


def problem(row):
    return PROBLEM.get(row["problem"], row["problem"])


class Answers:
    """The rows of the committed answers by need, read once."""

    def __init__(self):
        real, random = bundles.real(), Bundle(bundles.ANSWERS)
        self.asked = {need.name: (need, bundle) for needs, bundle in ((answers.REAL, real), (answers.NEEDS, random)) for need in needs}
        self.errors = {name: answers.errors_of(bundle, need) for name, (need, bundle) in self.asked.items()}
        self.times = {name: answers.times_of(bundle, need) for name, (need, bundle) in self.asked.items()}
        self.winners = {name: answers.winner(bundle, need) for name, (need, bundle) in self.asked.items()}
        self.degrees = {name: answers.degrees(bundle, need) for name, (need, bundle) in self.asked.items()}
        self.demands = {name: answers.demand(bundle, need) for name, (need, bundle) in self.asked.items()}

    def needs(self, method):
        return [need for need, _ in self.asked.values() if method in self.errors[need.name]]

    def cell(self, need, method, degree):
        """(error, time) of a method as texts."""
        rows = [row for row in self.errors[need.name][method].get(degree, ()) if row["study"] == need.studies[0]]
        timed = self.times[need.name].get(method, {}).get(degree)
        return need.error(rows) if rows else "", answers.time_text(timed, None).partition("<br>")[0] if timed else ""

    def table(self, method):
        """(degrees, rows of needs): the method beside the one that times are ratios to, and the one that is recommended."""
        needs = self.needs(method)
        degrees = sorted({degree for need in needs for degree in self.degrees[need.name]})
        found = []
        for need in needs:
            base = next((row["relative_to"] for rows in self.times[need.name].values() for row in rows.values()), None)
            winner = self.winners[need.name]
            shown = [one for one in dict.fromkeys([method, base, winner and winner.method]) if one in self.errors[need.name]]
            found.append({"need": need.name, "demand": self.demands[need.name], "base": base, "rows": [
                (one, one == method, bool(winner) and one == winner.method, [self.cell(need, one, degree) for degree in degrees]) for one in shown]})
        return {"degrees": [shortest(degree) for degree in degrees], "needs": found}

    def chart(self, method, form):
        """Largest errors over the degree, of the method and well-known ones, with the proved bound."""
        need = DRAWN.get(form)
        if need is None or method not in self.errors[need.name]:
            return ""
        lines = []
        for at, one in enumerate(dict.fromkeys((method, *KNOWN[form]))):
            rows = {degree: max(answers.number(row, "max_error_u") for row in rows) for degree, rows in self.errors[need.name].get(one, {}).items()}
            lines.append((one, f"known{at}" if at else "own", False, [(degree, error) for degree, error in rows.items() if 0 < error < 1e30]))
        bound = [(degree, rows[0]["bound_u"]) for degree, rows in self.errors[need.name][method].items() if isinstance(rows[0]["bound_u"], float)]
        if bound and all(0 < value < 1e30 for _, value in bound):
            lines.append((f"bound of {method}", "own", True, bound))
        lines = [line for line in lines if line[3]]
        title = f"Largest error by degree of {', '.join(one for one, *_ in lines)}, in u p~"
        return {"form": CURVES[form], "svg": drawing.chart(title, "degree n", "u p~", lines),
                "names": [(one, style, dashed) for one, style, dashed, _ in lines]}


@functools.cache
def searched():
    """{(form, method): [row of a search that found a worst case, with its bundle]}"""
    rows = [{**row, "bundle": str(bundle.relative_to(ROOT))} for bundle in dict.fromkeys(SEARCHED.values())
            for row in csv.DictReader((bundle / "search.csv").read_text(encoding="utf-8").splitlines())
            if row["status"] != "out_of_range" and row["coefficients"]]
    return grouped(rows, "form", "method")


def worst(method, form):
    """The worst case at the lowest degree, drawn, with the command that recomputes it, and the largest error at any degree; None where
    nothing was searched."""
    rows = searched().get((form, method))
    if rows is None:
        return None
    row, largest = min(rows, key=lambda one: int(one["degree"])), max(rows, key=lambda one: float(one["searched_error_u"]))
    degree, numbers = int(row["degree"]), [float.fromhex(one) for one in row["coefficients"].split()]
    coefficients = [[numbers[i], numbers[degree + 1 + i]] for i in range(degree + 1)]
    weights = [float.fromhex(one) for one in row["weights"].split()] or None
    control = drawing.control_points(coefficients, form)
    t = float.fromhex(row["t"])
    svg, stretched = drawing.curve(f"The curve of degree {degree} at which a search found the largest error of {method}", control, t, weights)
    numbers = {name: general(float(row[column])) if row[column] else ""
               for name, column in (("error", "searched_error_u"), ("sampled", "sampled_error_u"), ("bound", "bound_u"))}
    return {**numbers, "svg": svg, "stretched": stretched, "degree": degree, "form": form, "name": FORM[form], "t": repr(t),
            "command": f"bezierbench replay {row['bundle']} {row['search_id']}",
            "largest": None if largest is row else {"error": general(float(largest["searched_error_u"])), "degree": largest["degree"], "id": largest["search_id"]},
            "points": [(repr(x), repr(y)) for x, y in coefficients], "weights": [repr(one) for one in weights or ()]}


@functools.cache
def guarantees():
    """{method: [(property, verdict, words)]} of the committed bundle."""
    bundle = Bundle(ATLAS / "guarantees")
    found = {}
    for (method, name), rows in grouped(bundle.judged("guarantees.csv").rows, "method", "property").items():
        verdict = of_all(rows)
        broken = min((row for row in rows if row["verdict"] == "refuted"), key=lambda row: row["degree"], default=None)
        replay = f"bezierbench replay results/atlas/guarantees {broken['guarantee_id']}" if broken else ""
        found.setdefault(method, []).append((name, verdict, with_share(rows), replay))
    return found


def uses():
    """{method: [row]}: which libraries are known to compute so, with the place that says it."""
    with open(USES, newline="", encoding="utf-8") as file:
        return grouped(csv.DictReader(file), "method")


def parts_of(method):
    """`conversion:evaluator` is two methods, and `local:` one about the nearer end."""
    return [part for part in method.split(":") if part != "local"] if ":" in method else []


class Pages:
    """The pages of all methods that a program lists."""

    def __init__(self, program):
        rows = [row for row in rows_of(program, "methods") if not row["id"].startswith("peer_")]
        self.rows = grouped(rows, "id")
        self.answers, self.uses = Answers(), uses()
        stems = {Path(one.path).stem: one.path for one in header.all_headers()}
        self.files = {path.name: str(path.relative_to(ROOT)) for path in sorted((ROOT / "core").rglob("*.hpp"))}
        self.stems = stems
        if unknown := set(self.uses) - set(self.rows):
            raise ValueError(f"{USES.name}: the program has no method {', '.join(sorted(unknown))}")

    @staticmethod
    def link(method, up):
        return f'<a href="{up}/{address(method)}"><code>{html.escape(method)}</code></a>'

    def texts(self):
        """Every text that holds mathematics."""
        for one in header.all_headers():
            for _, paragraphs in one.sections:
                yield from paragraphs
        for rows in self.rows.values():
            for row in rows:
                yield from (row["bound"], row["flops"])

    def words(self, text, own, files):
        """HTML of words: code, files of core, proofs and methods as links, except for the names `own`. `files` collects the files."""
        def one(match):
            code, path, name = match.groups()
            if code:
                return f"<code>{code}</code>"
            if path or (name in self.stems and name not in self.rows and name not in own):
                file = self.stems[name] if name else path if (ROOT / path).exists() else self.files.get(posixpath.basename(path))
                if file is None:
                    return path
                files.add(file)
                shown = f"<code>{name}</code>" if name else posixpath.basename(path) if path.endswith(".hpp") else path
                return f'<a href="{posixpath.relpath(place(file), "methods")}">{shown}</a>'
            return self.link(name, "..") if name in self.rows and name not in own else name

        return MENTIONED.sub(one, html.escape(text, quote=False))

    def page(self, method, typeset, files):
        """The values of a method's template."""
        rows = self.rows[method]
        headers = header.of(method)
        own = {Path(one.path).stem for one in headers} | {method}
        form = rows[0]["form"]
        judged = f"{method}:{JUDGED_BY[form]}" if rows[0]["problem"] == "conversion" else method
        files.update(one.path for one in headers)

        def text(words):
            return typeset(words, lambda part: self.words(part, own, files))

        name = rows[0]["problem"]
        atlas = f"atlas/{'ladder' if name == 'evaluation' else name}/index.html"  # suites are named after problems
        forms = [row["form"] for row in rows]
        return {
            "method": method, "label": next((found for one in headers if (found := header.label(method, one))), ""), "problem": problem(rows[0]),
            "facts": [{"form": FORM[row["form"]], "degrees": f"{row['min_degree']} to {row['max_degree']}",
                       "bound": typeset(row["bound"]) if row["bound"] else "none proved",
                       "flops": typeset(row["flops"], html.escape), "stable": row["bit_stable"] == "yes",
                       "source": row["citation"]} for row in rows],
            "parts": [(part, address(part)) for part in parts_of(method) if part in self.rows],
            "is_local": method.startswith("local:") or ":local:" in method,
            "headers": [{"path": one.path, "link": posixpath.relpath(place(one.path), "methods"), "code": header.code(method, one),
                         "proofs": [(index.title(ROOT / proof), posixpath.relpath(place(proof), "methods"))
                                    for proof in one.proofs if (ROOT / proof).exists()],
                         "sections": {label: [text(paragraph) for paragraph in paragraphs] for label, paragraphs in one.sections}} for one in headers],
            "judged": judged if judged != method else "",
            "guarantees": guarantees().get(method, ()), "marks": WORDS, "uses": self.uses.get(method, ()),
            "table": self.answers.table(judged),
            "charts": [chart for one in forms if (chart := self.answers.chart(judged, one))],
            "worst": [found for one in forms if (found := worst(judged, one))],
            "atlas": atlas, "address": lambda one: posixpath.basename(address(one)) if one in self.rows else None,
        }

    def index(self, typeset):
        """[(problem, [row of a table])] of the methods that are not compositions."""
        def line(row):
            return {"id": row["id"], "link": posixpath.basename(address(row["id"])), "form": FORM[row["form"]],
                    "bound": typeset(row["bound"]) if row["bound"] else "none", "flops": typeset(row["flops"])}
        alone = [row for rows in self.rows.values() for row in rows if not parts_of(row["id"]) or row["id"].startswith("local:")]
        return [(name, [line(row) for row in rows]) for name, rows in grouped(({**row, "problem": problem(row)} for row in alone), "problem").items()]

    def composed(self):
        return [(method, posixpath.basename(address(method))) for method in self.rows if parts_of(method)]
