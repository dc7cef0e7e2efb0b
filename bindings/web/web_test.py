#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The module for WebAssembly against the native library, bit for bit: random curves of every form, ordinary and nasty, through
every method, in double and float, and their exact values, errors and bounds, which GMP computes here and cpp_int there; then
lengths, feet, halves, chords, boxes, roots and easings.

web_test.py BUILT LIBRARY [--inputs N] [--seed S]    BUILT is the folder with bezierbench.wasm. Exit 77: skipped, and why.
"""
import argparse
import ctypes
import json
import os
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
SKIPPED = 77
FORMS = ("bernstein", "power", "rational")
PLACES = 50  # parameters a curve
# They divide std::complex, which is a function of the compiler's library: the number of candidates may differ by one.
COMPLEX = {b"quintic_durand_kerner", b"quintic_jenkins_traub"}


def curve_of(random, form, dimension, degree, kind, largest):
    """Points and weights; `largest` is the exponent of the largest number of the type, so that kinds fit into both types."""
    shape = (degree + 1, dimension)
    points = random.uniform(-1, 1, shape)
    if kind == "subnormal":
        points = points * 2.0 ** (-largest - random.integers(0, 40))
    elif kind == "huge":
        points = points * 2.0 ** (largest - 3 - random.integers(0, 8))
    elif kind == "wide":
        points = points * 2.0 ** random.integers(-largest // 2, largest // 3, shape)
    elif kind == "cancelling":
        points = 1000 + points * 2.0 ** -random.integers(5, 40)
    elif kind == "lattice":
        points = random.integers(-4, 5, shape).astype(float)
    if form != "rational":
        return points, None
    weights = random.uniform(0.1, 10, degree + 1)
    if random.integers(16) == 0:
        weights[random.integers(degree + 1)] *= -1
    return points, weights


def parameters_of(random, inside):
    at = random.uniform(0, 1, PLACES)
    at[:10] = [0, 1, 0.5, 5e-324, 1 - 2.0**-53, 2.0**-30, *random.integers(0, 65, 4) / 64]
    if not inside:
        at[10:20] = random.uniform(-2, 3, 10)
    return at


class Native:
    """Puts a question to the native library, as web_test.mjs does to the module. An answer is the numbers of the module's, in
    the order of its members, a text, or the status."""

    def __init__(self, library, curve_type, batch_type, half_type):
        self.library, self.curve_type, self.batch_type, self.half_type = library, curve_type, batch_type, half_type

    def set(self, curve):
        self.form, self.points, self.weights = FORMS.index(curve["form"]), *(
            None if curve.get(key) is None else np.array(curve[key]) for key in ("points", "weights"))
        self.dimension = curve["dimension"]
        self.degree = self.points.size // self.dimension - 1
        self.curve = self.curve_type(self.form, self.dimension, self.degree, self.points.ctypes.data,
                                     None if self.weights is None else self.weights.ctypes.data)
        self.at = np.array(curve["ts"])

    def ask(self, name, *arguments, size, kind=np.float64):
        out = np.zeros(size, kind)
        status = getattr(self.library, name)(*arguments, out.ctypes.data)
        return out.astype(np.float64).tolist() if status == 0 else status

    def evaluate(self, method, float=False):
        if not float:
            return self.ask("bb_curve_evaluate", method.encode(), self.curve, self.at.ctypes.data, self.at.size,
                            size=self.at.size * self.dimension)
        batch = self.batch_type(self.form, self.dimension, self.degree, 1, self.at.size, None, None, None)
        points, at = self.points.astype(np.float32), self.at.astype(np.float32)
        weights = None if self.weights is None else self.weights.astype(np.float32)
        return self.ask("bb_evaluate_curves_float", method.encode(), batch, points.ctypes.data,
                        None if weights is None else weights.ctypes.data, at.ctypes.data,
                        size=at.size * self.dimension, kind=np.float32)

    def exact(self, float=False):
        if not float:
            return self.ask("bb_curve_exact", self.curve, self.at.ctypes.data, self.at.size, size=self.at.size * self.dimension)
        points, at = self.points.astype(np.float32), self.at.astype(np.float32)
        return self.ask("bb_exact_float", self.dimension, self.degree, points.ctypes.data, at.ctypes.data, at.size,
                        size=at.size * self.dimension, kind=np.float32)

    def error(self, values):
        given = np.array(values)
        return self.ask("bb_curve_error", self.curve, self.at.ctypes.data, self.at.size, given.ctypes.data, size=4 * given.size)

    def bound(self, method, float=False):
        size = 2 * self.at.size * self.dimension
        if not float:
            return self.ask("bb_curve_bound", method.encode(), self.curve, self.at.ctypes.data, self.at.size, size=size)
        points, at = self.points.astype(np.float32), self.at.astype(np.float32)
        return self.ask("bb_bound_float", method.encode(), self.dimension, self.degree, points.ctypes.data, at.ctypes.data,
                        at.size, size=size)

    def exactText(self, t, axis):
        text = ctypes.create_string_buffer(1 << 20)
        status = self.library.bb_curve_exact_text(self.curve, t, axis, text, len(text), None)
        return status or text.value.decode()

    def structure(self, name, *arguments, fields):
        """Of doubles, integers of 64 bits and of 32 bits, as `fields` says by d, q and i."""
        kind = np.dtype({"names": list("abcd"[: len(fields)]),
                         "formats": [{"d": "f8", "q": "i8", "i": "i4"}[field] for field in fields]}, align=True)
        out = np.zeros(1, kind)
        function = getattr(self.library, name)
        status = function(*arguments, out.ctypes.data_as(function.argtypes[-1]))
        return status or [float(number) for number in out[0]]

    def arcLength(self, method, *arguments):
        return self.structure("bb_arc_length", method.encode(), self.curve, *arguments, fields="ddqi")

    def atLength(self, method, *arguments):
        return self.structure("bb_at_length", method.encode(), self.curve, *arguments, fields="ddqi")

    def project(self, method, point):
        given = np.array(point)
        return self.structure("bb_project", method.encode(), self.curve, given.ctypes.data, fields="ddii")

    def exactArcLength(self, begin, end):
        return self.structure("bb_exact_arc_length", self.curve, begin, end, fields="d")

    def exactProject(self, point):
        given, t, distance = np.array(point), ctypes.c_double(), ctypes.c_double()
        status = self.library.bb_exact_project(self.curve, given.ctypes.data, t, distance)
        return status or [t.value, distance.value]

    def lengthError(self, begin, end, length):
        return self.structure("bb_arc_length_error", self.curve, begin, end, length, fields="d")

    def projectError(self, point, t, distance):
        given = np.array(point)
        return self.structure("bb_project_error", self.curve, given.ctypes.data, t, distance, fields="d")

    def split(self, method, t):
        halves = [(np.zeros(self.points.size), np.zeros(self.degree + 1)) for _ in range(2)]
        status = self.library.bb_split(method.encode(), self.curve, t,
                                       *(self.half_type(points.ctypes.data, weights.ctypes.data) for points, weights in halves))
        kept = 1 if self.weights is None else 2
        return status or [x for half in halves for numbers in half[:kept] for x in numbers.tolist()]

    def flatten(self, method, tolerance):
        t, points = np.zeros(1 << 17), np.zeros(self.dimension << 17)
        ends, complete = ctypes.c_size_t(), ctypes.c_int()
        status = self.library.bb_flatten(method.encode(), self.curve, tolerance, t.ctypes.data, points.ctypes.data, t.size, ends, complete)
        return status or [*t[: ends.value].tolist(), *points[: ends.value * self.dimension].tolist(), complete.value]

    def box(self, method):
        return self.ask("bb_box", method.encode(), self.curve, size=2 * self.dimension)

    def roots(self, of, axis, value):
        t, multiplicities, count = np.zeros(256), np.zeros(256, np.int32), ctypes.c_size_t()
        status = self.library.bb_roots(self.curve, ("value", "derivative", "curvature").index(of), axis, value, t.ctypes.data,
                                       multiplicities.ctypes.data, t.size, count)
        everywhere = count.value > t.size
        last = 0 if everywhere else count.value
        return status or [float(everywhere), *t[:last].tolist(), *multiplicities[:last].tolist()]

    def ease(self, method, bezier, xs, float=False):
        kind = np.float32 if float else np.float64
        given, at = np.array(bezier, kind), np.array(xs, kind)
        return self.ask("bb_ease_float" if float else "bb_ease", method.encode(), given.ctypes.data, at.ctypes.data, at.size,
                        size=at.size, kind=kind)

    def exactEase(self, bezier, xs):
        given, at = np.array(bezier), np.array(xs)
        return self.ask("bb_exact_ease", given.ctypes.data, at.ctypes.data, at.size, size=at.size)


def is_compared(method):
    return method.bit_stable and method.id not in COMPLEX


def takes(method, curve, float=False):
    degree = len(curve["points"]) // curve["dimension"] - 1
    largest = method.max_degree_float if float else method.max_degree
    return FORMS[method.form] == curve["form"] and method.min_degree <= degree <= largest


def questions(random, native, methods, curves, few):
    """(question, answer) for every curve; an error is that of the numbers of the answer before it. Lengths, feet and roots, which
    take longer, are for the first `few`."""
    evaluators = [method for method in methods if method.problem == b"evaluation"]
    for number, curve in enumerate(curves):
        native.set(curve)
        for is_float in (False, True):
            if is_float and not curve["fits_float"]:
                continue
            taking = [method for method in evaluators if takes(method, curve, is_float)]
            for method in taking:
                if is_compared(method):
                    answer = native.evaluate(method.id.decode(), is_float)
                    yield [number, "evaluate", method.id.decode(), {"float": is_float}], answer
                    last = answer if isinstance(answer, list) else None
            method = taking[number % len(taking)].id.decode()
            if not is_float:
                if last:
                    yield [number, "error", {"float": False}], native.error(last)
                yield [number, "bound", method, {"float": False}], native.bound(method)
                yield [number, "exact", {"float": False}], native.exact()
            elif curve["form"] == "bernstein":
                yield [number, "bound", method, {"float": True}], native.bound(method, True)
                yield [number, "exact", {"float": True}], native.exact(True)
        if number >= few:
            continue
        t = float(native.at[20])
        point = random.uniform(-1, 1, curve["dimension"]).tolist()
        yield [number, "exactText", t, 0], native.exactText(t, 0)
        for of in ("value", "derivative", *(["curvature"] if curve["dimension"] == 2 else [])):
            yield [number, "roots", of, 0, 0.25], native.roots(of, 0, 0.25)
        size = max(map(abs, curve["points"])) or 1
        of_problem = {"arc_length": ("arcLength", 0.125, 0.875, 1e-9), "inverse_arc_length": ("atLength", 0.5 * size, 1e-9),
                      "projection": ("project", point), "subdivision": ("split", t), "flattening": ("flatten", 1e-3 * size),
                      "bounds": ("box",)}
        for method in methods:
            name, *arguments = of_problem.get(method.problem.decode(), (None,))
            if name and is_compared(method) and takes(method, curve):
                yield [number, name, method.id.decode(), *arguments], getattr(native, name)(method.id.decode(), *arguments)
        if curve["form"] != "power" and len(curve["points"]) <= 7 * curve["dimension"]:
            length, foot = native.exactArcLength(0.125, 0.875), native.exactProject(point)
            yield [number, "exactArcLength", 0.125, 0.875], length
            yield [number, "exactProject", point], foot
            for given in [size, *(length if isinstance(length, list) else [])]:
                yield [number, "lengthError", 0.125, 0.875, given], native.lengthError(0.125, 0.875, given)
            for given in [[t, size], *([foot] if isinstance(foot, list) else [])]:
                yield [number, "projectError", point, *given], native.projectError(point, *given)
        bezier = random.uniform([0, -1, 0, -1], [1, 2, 1, 2]).tolist()
        xs = random.uniform(0, 1, 20).tolist()
        yield [number, "exactEase", bezier, xs], native.exactEase(bezier, xs)
        for method in methods:
            if method.problem == b"easing" and is_compared(method):
                for is_float in (False, True):
                    yield ([number, "ease", method.id.decode(), bezier, xs, {"float": is_float}],
                           native.ease(method.id.decode(), bezier, xs, is_float))


def nearest_float(value):
    """The float nearest to a fraction: of the two about it, or the even one of two that are as near."""
    near = np.float32(float(value))
    about = [np.nextafter(near, np.float32(-np.inf)), near, np.nextafter(near, np.float32(np.inf))]
    return float(min(about, key=lambda x: (abs(Fraction(float(x)) - value), int(x.view(np.uint32)) & 1)))


def float_questions(native, curves):
    """In float, what the C interface has in double only, from the exact fractions: errors, and the true points of two forms."""
    for number, curve in enumerate(curves):
        if not curve["fits_float"] or curve["kind"] != "ordinary":
            continue
        narrow = {**curve, **{key: np.array(curve[key], np.float32).astype(float).tolist()
                              for key in ("points", "weights", "ts") if curve.get(key) is not None}}
        native.set(narrow)
        texts = [native.exactText(t, axis) for t in narrow["ts"] for axis in range(curve["dimension"])]
        if any(isinstance(text, int) for text in texts):
            continue
        true = [Fraction(text) for text in texts]
        rounded = [nearest_float(value) for value in true]
        yield [number, "exact", {"float": True}], rounded
        errors = native.error(rounded)
        answer = []
        for k, (value, exact) in enumerate(zip(rounded, true)):
            difference = abs(Fraction(value) - exact)
            spacing = Fraction(abs(float(np.spacing(np.float32(value)))))  # ordinary values are not next to a power of two
            answer += [value, errors[4 * k + 1], float(difference / spacing), errors[4 * k + 3] * 2.0**-29]
        yield [number, "error", {"float": True}], answer


def main(arguments):
    options = argparse.ArgumentParser()
    options.add_argument("built", type=Path)
    options.add_argument("library", type=Path)
    options.add_argument("--inputs", type=int, default=20000)
    options.add_argument("--seed", type=int, default=1)
    options = options.parse_args(arguments)
    node = shutil.which("node")
    wasm = options.built / "bezierbench.wasm"
    if not wasm.exists() or node is None:
        print("web: skipped: " + ("no node; install nodejs" if wasm.exists() else f"no {wasm}; scripts/build web builds it"))
        return SKIPPED
    os.environ["BEZIERBENCH_LIBRARY"] = str(options.library)
    sys.path.insert(0, str(HERE.parent / "python"))
    from bezierbench import _library as bound
    methods = [bound.MethodEntry() for _ in range(bound.library.bb_method_count())]
    for index, method in enumerate(methods):
        bound.library.bb_method_at(index, method)
    native = Native(bound.library, bound.Curve, bound.Batch, bound.HalfEntry)
    random = np.random.default_rng(options.seed)
    kinds = ["ordinary", "ordinary", "subnormal", "huge", "wide", "cancelling", "lattice"]
    curves = []
    for number in range(options.inputs // PLACES):
        form, kind = FORMS[number % 3], kinds[number // 3 % len(kinds)]
        largest = 126 if number % 2 else 1022
        degree = int(random.integers(13, 31)) if number % 20 == 0 else int(random.integers(1, 13))
        dimension = int(random.integers(1, 4))
        points, weights = curve_of(random, form, dimension, degree, kind, largest)
        curves.append({"form": form, "dimension": dimension, "points": points.ravel().tolist(), "kind": kind,
                       **({} if weights is None else {"weights": weights.tolist()}),
                       "ts": parameters_of(random, number % 4 > 0).tolist(), "fits_float": largest == 126 or kind in ("ordinary", "cancelling", "lattice")})
    asked = 0
    numbers = 0
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/questions", "w", encoding="utf-8") as lines, open(f"{folder}/numbers", "wb") as answers:
            lines.write(json.dumps(curves) + "\n")
            for source in (questions(random, native, methods, curves, few=max(len(curves) // 20, 12)), float_questions(native, curves)):
                for question, answer in source:
                    expected = len(answer) if isinstance(answer, list) else -answer if isinstance(answer, int) else answer
                    lines.write(json.dumps([question, expected]) + "\n")
                    if isinstance(answer, list):
                        np.array(answer, np.float64).tofile(answers)
                        numbers += len(answer)
                    asked += 1
        print(f"web: seed {options.seed}: {len(curves) * PLACES} inputs, {asked} calls, {numbers} numbers of the native library; "
              f"{sum(not is_compared(method) for method in methods)} methods that functions of other libraries decide are left out")
        sys.stdout.flush()
        return subprocess.run([node, HERE / "web_test.mjs", wasm, folder], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
