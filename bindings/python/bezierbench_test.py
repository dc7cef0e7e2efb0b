# SPDX-License-Identifier: MIT
"""The Python package against rational arithmetic, and a bundle against its files."""
import csv
import decimal
import hashlib
import json
import math
import os
import shutil
import signal
import sys
import tempfile
import time
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np

if len(sys.argv) > 1:  # the installed package, instead of the one beside this file
    sys.path.insert(0, sys.argv.pop())
import bezierbench
from bezierbench import files

ROOT = Path(__file__).resolve().parents[2]

CURVE = [[0.0, 0.0], [1.0, 2.0], [3.0, 0.1]]
T = [0.0, 0.1, 0.7, 1.0]


def de_casteljau(values, t):
    """One coordinate of a Bezier curve in rational arithmetic."""
    row, t = [Fraction(value) for value in values], Fraction(t)
    while len(row) > 1:
        row = [(1 - t) * a + t * b for a, b in zip(row, row[1:])]
    return row[0]


def truths(t):
    return [de_casteljau([point[axis] for point in CURVE], t) for axis in range(2)]


class Points(unittest.TestCase):
    def test_shapes(self):
        self.assertEqual(bezierbench.evaluate(CURVE, 0.5).shape, (2,))
        self.assertEqual(bezierbench.exact(CURVE, 0.5).shape, (2,))
        self.assertEqual(bezierbench.evaluate(CURVE, T).shape, (4, 2))
        self.assertEqual(bezierbench.exact(CURVE, []).shape, (0, 2))
        self.assertEqual(bezierbench.evaluate([1, 2, 4], 0.5).shape, (1,))
        self.assertEqual(bezierbench.evaluate(np.asfortranarray(CURVE), np.array(T)[::-1]).shape, (4, 2))

    def test_exact_points_are_rounded_once(self):
        for t, point in zip(T, bezierbench.exact(CURVE, T)):
            self.assertEqual([float(x) for x in truths(t)], list(point))
            self.assertEqual(bezierbench.exact_fractions(CURVE, t), truths(t))

    def test_order_of_points_and_axes(self):
        values = bezierbench.evaluate(CURVE, T, "correctly_rounded")
        self.assertTrue(np.array_equal(values, bezierbench.exact(CURVE, T)))
        self.assertEqual(list(values[-1]), CURVE[-1])

    def test_the_method_that_is_not_named(self):
        """It is the recommended one, for the same curve in the same type."""
        for points, weights in ((CURVE, None), (np.float32(CURVE), None), (CURVE, [1, 2, 1, 0.5][:len(CURVE)])):
            name = bezierbench.recommended(points, weights=weights)
            self.assertIn(name, {method.id for method in bezierbench.methods()})
            for function in (bezierbench.evaluate,) if weights else (bezierbench.evaluate, bezierbench.bound):
                self.assertTrue(np.array_equal(function(points, T, weights=weights), function(points, T, name, weights=weights)))
        self.assertEqual(bezierbench.Prepared(CURVE).method, bezierbench.recommended(CURVE))
        self.assertEqual(bezierbench.recommended(CURVE, form="power"), "horner")

    def test_errors_and_bounds(self):
        values = bezierbench.evaluate(CURVE, T)
        judged = bezierbench.error(CURVE, T, values)
        for k, t in enumerate(T):
            for axis in range(2):
                difference = abs(Fraction(values[k, axis]) - truths(t)[axis])
                self.assertEqual(judged.error[k, axis], float(difference))
        proved = bezierbench.bound(CURVE, T, "de_casteljau")
        self.assertTrue((judged.error <= proved.bound).all())
        self.assertTrue((judged.error_u[1:] <= proved.bound_u[1:]).all())
        self.assertEqual(bezierbench.error(CURVE, 0.0, [1.0, math.nan]).error[1], math.inf)

    def test_other_forms(self):
        power = bezierbench.evaluate([1.0, 2.0, 3.0], 0.5, form="power")
        self.assertEqual(list(power), [2.75])
        half = bezierbench.exact_fractions(CURVE, 0.5, weights=[1, 0.5, 1])
        self.assertEqual(half[0], Fraction(4, 3))

    def test_float(self):
        points = np.array(CURVE, dtype=np.float32)
        exact = bezierbench.exact(points, T)
        self.assertEqual(exact.dtype, np.float32)
        self.assertTrue(np.array_equal(bezierbench.evaluate(points, T, "correctly_rounded"), exact))

    def test_what_is_in_double_only_refuses_float(self):
        points = np.array(CURVE, dtype=np.float32)
        self.assertGreater(bezierbench.error(points, 0.7, bezierbench.evaluate(points, 0.7)).error.max(), 1e-9)
        for call in (lambda: bezierbench.derivative(points, 0.7), lambda: bezierbench.grid(points, 3),
                     lambda: bezierbench.split(points, 0.7), lambda: bezierbench.box(points),
                     lambda: bezierbench.Prepared(points)):
            with self.assertRaisesRegex(ValueError, "give float64"):
                call()

    def test_bounds_of_float_hold_in_float(self):
        points, t = np.array(CURVE, dtype=np.float32), np.array([0.1, 0.7, 0.9], dtype=np.float32)
        for method in bezierbench.methods("evaluation", "bernstein"):
            if not method.bound:
                continue
            proved = bezierbench.bound(points, t, method.id)
            errors = bezierbench.error(points, t, bezierbench.evaluate(points, t, method.id))
            self.assertTrue((errors.error <= proved.bound).all(), method.id)
            self.assertTrue((errors.error_u <= proved.bound_u).all(), method.id)
        self.assertGreater(bezierbench.bound(points, 0.7).bound.max(), 2**20 * bezierbench.bound(CURVE, 0.7).bound.max())

    def test_derivatives_grids_and_halves(self):
        # x = 2t + t^2, and with t^2 for the second coefficient of the power form x' = 2t
        np.testing.assert_allclose(bezierbench.derivative(CURVE, T)[:, 0], [2 + 2 * t for t in T], rtol=1e-15)
        self.assertEqual(bezierbench.derivative(CURVE, 0.5, 2)[0], 2)
        self.assertEqual(bezierbench.derivative([0, 0, 1], 0.5, form="power").tolist(), [1])
        self.assertTrue(np.isnan(bezierbench.derivative(CURVE, [0.5, math.nan])[1]).all())
        np.testing.assert_array_equal(bezierbench.grid(CURVE, 5)[:, 0], [0, 0.5625, 1.25, 2.0625, 3])
        circle = bezierbench.grid([[1, 0], [1, 1], [0, 1]], 3, weights=[1, 1, 2])  # (1 - t^2, 2t) / (1 + t^2)
        np.testing.assert_allclose(circle, [[1, 0], [0.6, 0.8], [0, 1]], rtol=1e-15)
        halves = bezierbench.split(CURVE, 0.5)
        self.assertEqual((halves.left[:, 0].tolist(), halves.right[:, 0].tolist()), ([0, 0.5, 1.25], [1.25, 2, 3]))
        self.assertIsNone(halves.left_weights)
        weighted = bezierbench.split(CURVE, 0.5, weights=[1, 0.5, 1])
        self.assertEqual((weighted.left_weights.tolist(), weighted.right_weights.tolist()), ([1, 0.75, 0.75], [0.75, 0.75, 1]))
        box = bezierbench.box([[0, 0], [1, 2], [3, 0]])
        self.assertEqual((box.low.tolist(), box.high.tolist()), ([0, 0], [3, 1]))
        self.assertEqual(bezierbench.box([[0, 0], [1, 2], [3, 0]], "control_box").high.tolist(), [3, 2])
        self.assertEqual(bezierbench.box([0.5, 2, 0.5], weights=[1, 0.5, 1]).high.tolist(), [1])
        for call, message in ((lambda: bezierbench.grid(CURVE, 4), "power of two and one"),
                              (lambda: bezierbench.derivative(CURVE, 0.5, -1), "domain"),
                              (lambda: bezierbench.derivative(CURVE, 0.5, form="rational"), "weights")):
            with self.assertRaisesRegex(ValueError, message):
                call()

    def test_a_computed_length_is_one_of_the_curve(self):
        whole = bezierbench.arc_length(CURVE).length
        self.assertAlmostEqual(bezierbench.at_length(CURVE, whole).t, 1, places=8)
        half = bezierbench.at_length(CURVE, whole / 2)
        self.assertAlmostEqual(bezierbench.exact_arc_length(CURVE, stop=half.t), whole / 2, places=8)
        self.assertAlmostEqual(bezierbench.at_length([0, 0, 0, 1], 0.125, tolerance=1e-15).t, 0.5, places=14)
        with self.assertRaises(bezierbench.Error):
            bezierbench.at_length(CURVE, 1.1 * whole)

    def test_a_prepared_curve(self):
        prepared = bezierbench.Prepared(CURVE, "wozny_chudy")
        self.assertTrue(np.array_equal(prepared(T), bezierbench.evaluate(CURVE, T, "wozny_chudy")))

    def test_many_curves(self):
        """Each has the points that it has alone, whatever the strides and the shape of t."""
        random = np.random.default_rng(36)
        for dtype in (np.float64, np.float32):
            for m, n, d, k in ((1, 3, 2, 5), (4, 2, 3, 4), (33, 3, 2, 3), (20, 5, 1, 80)):
                dense, t = random.random((m, n + 1, d)).astype(dtype), random.random((m, k)).astype(dtype)
                each = np.array([bezierbench.evaluate(points, own) for points, own in zip(dense, t)])
                for points in (dense, np.asfortranarray(dense), np.concatenate([dense, dense], 1)[:, :n + 1],
                               np.repeat(dense[::-1], 2, 0)[::-2]):
                    self.assertTrue(np.array_equal(bezierbench.evaluate(points, t), each))
                    self.assertTrue(np.array_equal(bezierbench.evaluate(points, np.asfortranarray(t)), each))
                    self.assertTrue(np.array_equal(bezierbench.evaluate(points, t[:, 1]), each[:, 1]))
                shared = bezierbench.evaluate(dense, t[:1])
                self.assertEqual(shared.dtype, dtype)
                self.assertTrue(np.array_equal(shared, [bezierbench.evaluate(points, t[0]) for points in dense]))
                self.assertTrue(np.array_equal(bezierbench.evaluate(np.broadcast_to(dense[0], dense.shape), t[:1]),
                                               np.broadcast_to(shared[0], shared.shape)))
        self.assertEqual(bezierbench.evaluate(np.empty((0, 4, 2)), np.empty(0)).shape, (0, 2))
        both = bezierbench.evaluate([CURVE, CURVE], [[0.5], [0.7]], weights=[[1, 1, 1], [1, 2, 1]])
        self.assertTrue(np.array_equal(both[1], bezierbench.evaluate(CURVE, [0.7], weights=[1, 2, 1])))
        self.assertEqual(bezierbench.evaluate([[[1.0], [2.0]]], [3.0], form="power").tolist(), [[7]])
        t = np.array([[0.5, math.nan, 1]])
        found = bezierbench.evaluate([CURVE, CURVE], t)
        self.assertTrue(np.isnan(found[:, 1]).all())
        self.assertTrue(np.array_equal(found[0, [0, 2]], bezierbench.evaluate(CURVE, [0.5, 1])))
        for wrong in (0.5, [0.5], [0.5] * 3, [[0.5]] * 3, [[[0.5]]]):
            with self.assertRaisesRegex(ValueError, "for 2 curves; give"):
                bezierbench.evaluate([CURVE, CURVE], wrong)
        for call in (lambda: bezierbench.evaluate([CURVE, CURVE], [0.5, 0.5], weights=[1, 1, 1]),
                     lambda: bezierbench.evaluate([CURVE, CURVE], [0.5, math.inf]),
                     lambda: bezierbench.evaluate(np.float32([CURVE, CURVE]), [0.5, 0.5], form="power"),
                     lambda: bezierbench.evaluate(np.ma.masked_equal([CURVE], 0), [0.5])):
            with self.assertRaises(ValueError):
                call()

    def test_what_is_wrong_is_refused(self):
        for status, call in [(2, lambda: bezierbench.evaluate(CURVE, 0.5, "de_castlejau")),
                             (3, lambda: bezierbench.evaluate(CURVE, 0.5, "horner")),
                             (6, lambda: bezierbench.evaluate(CURVE, math.inf)),
                             (7, lambda: bezierbench.evaluate(CURVE, 2, "correctly_rounded")),
                             (10, lambda: bezierbench.bound(CURVE, 0.5, "direct_pow"))]:
            with self.assertRaises(bezierbench.Error) as caught:
                call()
            self.assertEqual(caught.exception.status, status)
        for call in [lambda: bezierbench.evaluate([], 0.5), lambda: bezierbench.evaluate(CURVE, [[0.5]]),
                     lambda: bezierbench.evaluate(CURVE, 0.5, weights=[1, 2]),
                     lambda: bezierbench.evaluate(CURVE, 0.5, form="hermite"),
                     lambda: bezierbench.error(CURVE, [0.5], [1.0, 2.0]), lambda: bezierbench.project(CURVE, [1.0]),
                     lambda: bezierbench.evaluate(CURVE, 0.5, ""), lambda: bezierbench.evaluate(CURVE, 0.5, "direct\0x"),
                     lambda: bezierbench.evaluate(CURVE, 0.5, form=[1]), lambda: bezierbench.exact_fractions(CURVE, [0.5])]:
            with self.assertRaises(ValueError):
                call()
        for method in (3, b"direct"):
            with self.assertRaises(TypeError):
                bezierbench.evaluate(CURVE, 0.5, method)

    def test_numbers_that_no_double_is_are_refused(self):
        """Functions that are called exact would answer for other numbers."""
        thirds = [[Fraction(1, 3), 0], [1, 1]]
        for points in [[[2**53 + 1, 0], [1, 1]], [[2**70 + 1, 0], [1, 1]], thirds, [[decimal.Decimal("0.1"), 0], [1, 1]],
                       np.array([[1, 0], [1, 1]], np.longdouble) / 3, np.array([[1j, 0], [1, 1]]), [["0", "0"], ["1", "1"]],
                       np.array([["2020-01-01"]], "datetime64[D]"), np.ma.masked_equal([[1.0, 0], [1, 1]], 0)]:
            for call in (bezierbench.exact, bezierbench.exact_fractions, bezierbench.evaluate):
                with self.subTest(points=points, call=call), self.assertRaises(ValueError):
                    call(points, 0.5)
        halves = [[Fraction(1, 2), 2**60], [np.longdouble(0.25), True]]
        self.assertEqual(bezierbench.exact_fractions(halves, 0), [Fraction(1, 2), 2**60])

    def test_fractions_of_thousands_of_digits(self):
        x, = bezierbench.exact_fractions([[0.0], *[[0.1]] * 300], 0.3)
        t, b = Fraction(0.3), Fraction(0.1)
        self.assertEqual(x, b * (1 - (1 - t)**300))

    def test_nan_in_t_concerns_its_own_point_only(self):
        t = np.array([0.25, math.nan, 0.75])
        prepared = bezierbench.Prepared(CURVE)
        for call in (lambda t: bezierbench.evaluate(CURVE, t), lambda t: bezierbench.exact(CURVE, t), prepared,
                     lambda t: bezierbench.evaluate(np.float32(CURVE), t), lambda t: bezierbench.bound(CURVE, t).bound,
                     lambda t: bezierbench.error(CURVE, t, np.zeros((*np.shape(t), 2))).error):
            found = call(t)
            self.assertTrue(np.isnan(found[1]).all())
            self.assertTrue(np.array_equal(found[[0, 2]], call(t[[0, 2]])))
            self.assertTrue(np.isnan(call(math.nan)).all())

    def test_errors_of_floats_are_in_units_of_float(self):
        points, t = np.float32([[0.1, 3], [0.7, -1], [1.9, 2]]), np.float32([0.3, 0.5])
        value = bezierbench.evaluate(points, t)
        found = bezierbench.error(points, t, value)
        self.assertTrue(np.array_equal(found.exact, bezierbench.exact(points, t)))
        for k in range(2):
            true = bezierbench.exact_fractions(points.astype(float), float(t[k]))
            for axis in range(2):
                error = abs(Fraction(float(value[k, axis])) - true[axis])
                ulp = Fraction(2)**(math.frexp(true[axis])[1] - 24)
                self.assertAlmostEqual(found.error_ulp[k, axis], float(error / ulp), 9)
                self.assertLess(found.error_u[k, axis], 10)
        swapped = points.astype(">f4")
        self.assertEqual(bezierbench.evaluate(swapped, t).dtype, np.float32)
        self.assertTrue(np.array_equal(bezierbench.evaluate(swapped, t), value))


class Problems(unittest.TestCase):
    def test_length(self):
        line = [[0, 0], [3, 4]]
        self.assertEqual(bezierbench.exact_arc_length(line, start=0.25, stop=0.75), 2.5)
        found = bezierbench.arc_length(CURVE)
        self.assertTrue(found.converged)
        self.assertLess(bezierbench.arc_length_error(CURVE, found.length), 1e-9 * found.length)
        quarter_circle = [[1, 0], [1, 1], [0, 1]]
        self.assertEqual(bezierbench.exact_arc_length(quarter_circle, weights=[1, 1, 2]), math.pi / 2)
        found = bezierbench.arc_length(quarter_circle, weights=[1, 1, 2])
        self.assertLess(bezierbench.arc_length_error(quarter_circle, found.length, weights=[1, 1, 2]), 2e-9)
        half = bezierbench.at_length(quarter_circle, math.pi / 4, weights=[1, 1, 2])
        self.assertAlmostEqual(half.t, math.tan(math.pi / 8), 8)
        with self.assertRaisesRegex(bezierbench.Error, "sum to zero"):
            bezierbench.arc_length(quarter_circle, weights=[1, -1, 1])

    def test_projection_on_a_rational_curve(self):
        quarter_circle = [[1, 0], [1, 1], [0, 1]]
        self.assertEqual(bezierbench.exact_project(quarter_circle, [3, 4], weights=[1, 1, 2]), (0.5, 4))
        self.assertAlmostEqual(bezierbench.project(quarter_circle, [3, 4], weights=[1, 1, 2]).t, 0.5, 14)
        with self.assertRaisesRegex(bezierbench.Error, "sum to zero"):
            bezierbench.exact_project(quarter_circle, [3, 4], weights=[1, -1, 1])

    def test_projection(self):
        self.assertEqual(bezierbench.exact_project([[0, 0], [4, 0]], [1, 3]), (0.25, 3))
        found = bezierbench.project(CURVE, [1, 1])
        self.assertLess(bezierbench.project_error(CURVE, [1, 1], found.t, found.distance), 1e-9)

    def test_the_default_projection_knows_t(self):
        """A public report; the root of (C - P).C' in 18 digits is known from mpmath."""
        foot = bezierbench.project([[259, 322], [272, 329], [297, 341], [350, 397]], [300, 340])
        self.assertAlmostEqual(foot.t, 0.565499632684385754, delta=2e-16)

    def test_a_signal_ends_a_truth_that_takes_minutes(self):
        def interrupt(_number, _frame):
            raise KeyboardInterrupt

        points = [[math.cos(i), math.sin(2 * i)] for i in range(401)]
        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            begin = time.monotonic()
            signal.setitimer(signal.ITIMER_REAL, 0.5)
            with self.assertRaises(KeyboardInterrupt):
                bezierbench.exact_project(points, [1, 2])
            self.assertLess(time.monotonic() - begin, 2)
        finally:
            signal.signal(signal.SIGALRM, before)

    def test_fit(self):
        angles = np.linspace(0, 4, 41)
        data = np.column_stack([np.cos(angles), np.sin(angles)])
        found = bezierbench.fit(data, 1e-3)
        self.assertEqual(found.segments.shape[1:], (4, 2))
        self.assertTrue(np.array_equal(found.segments[0, 0], data[0]))
        self.assertTrue(np.array_equal(found.segments[-1, 3], data[-1]))
        self.assertLessEqual(found.exact_error, found.max_error)

    def test_fit_between_directions_and_closed(self):
        arch = [[0, 0], [1, 1], [2, 1], [3, 0]]
        found = bezierbench.fit(arch, 0.1, start_direction=[0, 2], end_direction=[1, -1]).segments
        self.assertEqual(found[0, 1, 0], 0)
        self.assertGreater(found[0, 1, 1], 0)
        side = found[-1, 3] - found[-1, 2]
        self.assertAlmostEqual(side[0], -side[1], 12)
        closed = bezierbench.fit(arch, 0.1, closed=True).segments
        self.assertTrue(np.array_equal(closed[-1, 3], closed[0, 0]))
        for direction in ([0, 0], [1], [1, 2, 3]):
            with self.assertRaisesRegex(ValueError, "direction"):
                bezierbench.fit(arch, 0.1, end_direction=direction)

    def test_chords(self):
        """The parabola (0,0), (1,2), (2,0) with the apex (1, 1): two chords are 1/4 / sqrt(2) away."""
        parabola = [[0, 0], [1, 2], [2, 0]]
        for method in (None, "wang_count"):
            chords = bezierbench.flatten(parabola, 0.25, method)
            np.testing.assert_allclose(chords.t, [0, 0.5, 1], atol=1e-15)
            np.testing.assert_allclose(chords.points, [[0, 0], [1, 1], [2, 0]], atol=1e-15)
        self.assertGreater(len(bezierbench.flatten([[0, 0], [1, 2], [2, 0], [3, 1], [4, 4]], 1e-3).t), 10)
        for call, message in ((lambda: bezierbench.flatten(parabola, 0), "tolerance"),
                              (lambda: bezierbench.flatten(parabola, 0.1, "de_casteljau"), "method"),
                              (lambda: bezierbench.flatten(parabola, 0.1, "hain"), "degree")):
            with self.assertRaisesRegex(bezierbench.Error, message):
                call()
        with self.assertRaisesRegex(ValueError, "too fine"):
            bezierbench.flatten(parabola, 1e-18)
        circle = bezierbench.flatten([[1, 0], [1, 1], [0, 1]], 0.16, weights=[1, 0.5**0.5, 1])  # of each half the inner point is 0.159 away
        np.testing.assert_allclose(circle.points, [[1, 0], [0.5**0.5, 0.5**0.5], [0, 1]], atol=1e-15)

    def test_interpolation(self):
        """What the keywords say; the test in C has the numbers."""
        self.assertEqual(bezierbench.interpolate([0, 1, 0, 1])[:, 3, 0].tolist(), [1, 0, 1])
        square = bezierbench.interpolate([0, 1, 4], "uniform", "clamped", start_derivative=0, end_derivative=4)
        np.testing.assert_allclose(square, bezierbench.interpolate([0, 1, 4], "uniform", "not-a-knot"), atol=1e-15)
        self.assertEqual(bezierbench.interpolate([[0, 0], [1, 0], [1, 1], [0, 1]], closed=True).shape, (4, 4, 2))
        steep = bezierbench.interpolate([0, 0, 1, 1.1, 9], "uniform", monotone=True).ravel()
        self.assertEqual(steep.tolist(), sorted(steep))
        with self.assertRaisesRegex(bezierbench.Error, "repeats"):
            bezierbench.interpolate([0, 0, 1])
        for arguments, message in (({"parameters": "arc"}, "arc"), ({"ends": "clamped"}, "derivative"),
                                   ({"ends": "not-a-knot", "closed": True}, "no ends"), ({"start_derivative": 1}, "clamped")):
            with self.assertRaisesRegex(ValueError, message):
                bezierbench.interpolate([0, 1, 4], **arguments)

    def test_easing(self):
        """x1 = x2 = 0 gives x = t^3, so that y(1/8) is (3 y1 + 3 y2 + 1) / 8."""
        self.assertEqual(bezierbench.ease((0, 1, 0, 1), [0, 0.125, 1]).tolist(), [0, 0.875, 1])
        x = np.linspace(0, 1, 257)
        curve = (0.25, 0.1, 0.25, 1)
        self.assertEqual(bezierbench.ease(curve, x).tolist(), bezierbench.exact_ease(curve, x).tolist())
        single = bezierbench.ease(curve, x.astype(np.float32))
        self.assertEqual(single.dtype, np.float32)
        rounded = bezierbench.exact_ease(np.float32(curve), x).astype(np.float32)
        self.assertEqual(single.tolist(), rounded.tolist())
        self.assertEqual(float(bezierbench.ease(curve, -1.0)), -0.4)
        self.assertEqual(float(bezierbench.exact_ease((0.5, 1, 0.5, 0), 2)), 3)
        for arguments in (((2, 0, 0, 1), 0.5), ((0, 0, 0, np.inf), 0.5), ((0, 0, 1), 0.5), (curve, np.nan)):
            with self.assertRaises(ValueError):
                bezierbench.ease(*arguments)
        with self.assertRaises(ValueError):
            bezierbench.exact_ease(curve, np.inf)

    def test_parts_and_elevated_curves(self):
        arch = [[0, 0], [1, 2], [2, 0]]
        found = bezierbench.part(arch, 0.5, 1)
        self.assertEqual((found.points.tolist(), found.weights), ([[1, 1], [1.5, 1], [2, 0]], None))
        circle, weights = [[1, 0], [1, 1], [0, 1]], [1, 1, 2]
        middle = bezierbench.part(circle, 0, 0.5, weights=weights)
        self.assertEqual((middle.points.tolist(), middle.weights.tolist()), ([[1, 0], [1, 0.5], [0.6, 0.8]], [1, 1, 1.25]))
        cubic = bezierbench.elevate(circle, 3, weights=weights)
        self.assertEqual(cubic.weights.tolist(), [1, 1, 4 / 3, 2])
        self.assertEqual(bezierbench.elevate(arch, 2).points.tolist(), arch)
        self.assertEqual(len(bezierbench.elevate(arch, 1023).points), 1024)
        for degree in (1, 1024, 10**13):
            with self.assertRaisesRegex(ValueError, "must be from 2, that of the curve, to 1023"):
                bezierbench.elevate(arch, degree)

    def test_points_and_parts_in_five_dimensions(self):
        line = np.array([[0, 1, 2, 3, 4], [1, 3, 5, 7, 9]], float)
        middle = line.mean(axis=0)
        np.testing.assert_array_equal(bezierbench.evaluate(line, [0.5, 1]), [middle, line[1]])
        np.testing.assert_array_equal(bezierbench.exact(line, 0.5), middle)
        np.testing.assert_array_equal(bezierbench.split(line, 0.5).right, [middle, line[1]])
        np.testing.assert_array_equal(bezierbench.part(line, 0.5, 0).points, [middle, line[0]])
        np.testing.assert_array_equal(bezierbench.elevate(line, 2).points, [line[0], middle, line[1]])

    def test_bspline_curves(self):
        """A uniform quadratic, which goes through the middles of its control polygon at its knots, and a circle."""
        curve = bezierbench.Bspline([0, 4, 12, 2], range(7))
        for method in {method.id for method in bezierbench.methods("bspline")}:
            self.assertEqual(curve([2, 3, 4], method).tolist(), [[2], [8], [7]], method)
        self.assertEqual(curve.exact(3).tolist(), [8])
        clamped = curve.insert(2, 2, 3, 4, 4)
        self.assertEqual((clamped.points.ravel().tolist(), clamped.knots.tolist()), ([2, 4, 8, 12, 7], [2, 2, 2, 3, 3, 4, 4, 4]))
        self.assertEqual([span.points.ravel().tolist() for span in curve.spans()], [[2, 4, 8], [8, 12, 7]])
        self.assertEqual(clamped.remove(3).points.ravel().tolist(), [2, 4, 12, 7])
        with self.assertRaisesRegex(ValueError, "might move by 5.0; give"):
            bezierbench.Bspline([[0, 0], [3, 4], [0, 0]], [0, 0, 1, 2, 2]).remove(1)
        self.assertEqual(curve.part(3, 4).points.ravel().tolist(), [8, 12, 7])
        self.assertEqual(curve.derivative().points.ravel().tolist(), [4, 8, -10])
        quarter = bezierbench.Bspline([[1, 0], [1, 1], [0, 1]], [0, 0, 0, 1, 1, 1], [1, 1, 2])
        self.assertEqual(quarter(0.5).tolist(), [0.6, 0.8])
        self.assertEqual(quarter.elevate(3).weights.tolist(), [1, 1, 4 / 3, 2])
        self.assertEqual(bezierbench.Bspline([0, 64], [0, 0, 1, 1]).elevate(64).points.ravel().tolist(), list(range(65)))
        for call, words in ((lambda: curve(5), "outside of the domain"), (lambda: curve.insert(3, 3), "knot 3 would stand 3 times; leave 1 of"),
                            (lambda: clamped.insert(2), "knot 2 would stand 4 times"), (lambda: curve.remove(2.5), "knot 2.5 stands 0 times"),
                            (lambda: curve.remove(2), "stands 0 times between the ends"), (lambda: curve.remove(3, 3), "stands 1 times"),
                            (lambda: bezierbench.Bspline(range(4), [0, 0, 0, 1, 2, 2, 2], [1, 0.5, 0.5, 1]).remove(1, tolerance=9), "weight of the new curve"),
                            (lambda: curve.remove(3, tolerance=-1), "tolerance is -1; give"), (lambda: quarter.derivative(), "with weights"),
                            (lambda: curve.derivative(2), "from 0 to 1"), (lambda: curve.part(3, 3), "start below stop"),
                            (lambda: curve.elevate(1), "curve, 2, to 64"), (lambda: curve.elevate(65), "curve, 2, to 64"),
                            (lambda: bezierbench.Bspline([0, 1], [0, 0, 0]), "give 4 to 4"), (lambda: bezierbench.Bspline([0, 1], [0, 1, 0, 1]), "knots descend"),
                            (lambda: bezierbench.Bspline([0, 1], [0, 1, 1, 1]), "begins and ends at 1"),
                            (lambda: bezierbench.Bspline([0, 1], [0, 0, 1, 1], [1, 0]), "weight is not above 0"),
                            (lambda: bezierbench.Bspline([0, 1], [0, 0, 1, 1], [1, np.nan]), "NaN or infinite|not finite")):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                call()

    def test_roots_have_multiplicities(self):
        self.assertEqual(bezierbench.roots([1, -1, 1]), [(0.5, 2)])
        self.assertEqual(bezierbench.roots([[0, 0], [1, 2], [2, 0]], 1, axis=1), [(0.5, 2)])
        self.assertEqual(bezierbench.roots([0, 1, -1, 0], of="extrema"), [(0.21132486540518711775, 1), (0.78867513459481288225, 1)])
        self.assertEqual(bezierbench.roots([[0, 0], [1, 1], [0, 1], [1, 0]], of="inflections"), [(0.5, 2)])
        self.assertEqual(bezierbench.roots([0, -1, 2], form="power"), [(0, 1), (0.5, 1)])
        with self.assertRaisesRegex(ValueError, "every parameter"):
            bezierbench.roots([[0, 0], [1, 1]], of="inflections")
        with self.assertRaisesRegex(ValueError, "use value, extrema, inflections"):
            bezierbench.roots([0, 1], of="minima")
        for axis in (-1, 2, 2**32):
            with self.assertRaisesRegex(ValueError, "must be from 0 to 1"):
                bezierbench.roots([[0, 0], [1, 1]], axis=axis)

    def test_every_listed_method_is_there(self):
        problems = {method.problem for method in bezierbench.methods()}
        self.assertEqual(problems, {"evaluation", "derivative", "grid", "subdivision", "arc_length", "inverse_arc_length", "projection",
                                    "fitting", "flattening", "bounds", "easing", "bspline"})


class CurveFiles(unittest.TestCase):
    def test_curves_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "größe.svg"
            file.write_text("<svg><path id='a' d='M0,0 L1,2 q1,1 2,0'/><circle r='2'/></svg>", encoding="utf-8")
            line, quadratic, *quarters = bezierbench.curves(file)
            self.assertEqual((line.id, line.form, line.weights, line.begins_path), ("a:0:0", "bernstein", None, True))
            np.testing.assert_array_equal(quadratic.points, [[1, 2], [2, 3], [3, 2]])
            self.assertFalse(quadratic.begins_path)
            self.assertEqual(len(quarters), 4)
            np.testing.assert_array_equal(quarters[0].weights, [1, math.sqrt(0.5), 1])
            file.write_text("<svg><path d='M0,0 L1,x'/></svg>", encoding="utf-8")
            with self.assertRaisesRegex(bezierbench.Error, "größe.svg:1:23: .*number"):
                bezierbench.curves(str(file))
        with self.assertRaisesRegex(bezierbench.Error, "cannot be read"):
            bezierbench.curves(folder)


class Bundles(unittest.TestCase):
    baseline = ROOT / "results/baseline"

    def test_tables_are_those_of_the_files(self):
        bundle = bezierbench.read(self.baseline, frames=False)
        self.assertEqual(bundle.info["state"], "complete")
        self.assertEqual(len(bundle), len(list(self.baseline.glob("*.csv"))))
        with open(self.baseline / "accuracy.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        table = bundle["accuracy"]
        self.assertEqual(list(table["method"]), [row["method"] for row in rows])
        self.assertEqual([int(row["degree"]) for row in rows], list(table["degree"]))
        for row, value in zip(rows, table["max_error_u"]):
            self.assertTrue(float(row["max_error_u"]) == value if row["max_error_u"] else math.isnan(value))

    def test_worst_cases_can_be_evaluated(self):
        worst = bezierbench.read(self.baseline, frames=False)["worst"]
        judged = 0
        for k, method in enumerate(worst["method"]):
            if worst["form"][k] != "bernstein" or worst["scalar"][k] != "double":
                continue
            points = bezierbench.numbers(worst["coefficients"][k]).reshape(worst["dimension"][k], -1).T
            t = worst["t"][k]
            judged_error = bezierbench.error(points, t, bezierbench.evaluate(points, t, method)).error
            self.assertAlmostEqual(math.hypot(*judged_error) / worst["error"][k], 1, delta=1e-6)
            judged += 1
        self.assertGreater(judged, 10)

    def test_what_is_damaged_is_refused(self):
        with self.assertRaisesRegex(bezierbench.BundleError, "SHA256SUMS"):
            bezierbench.read(ROOT / "results")
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / "bundle"
            shutil.copytree(self.baseline, copy)
            file = copy / "accuracy.csv"
            file.write_text(file.read_text(encoding="utf-8").replace("400000", "400001", 1), encoding="utf-8")
            with self.assertRaisesRegex(bezierbench.BundleError, "accuracy.csv: is not what SHA256SUMS lists"):
                bezierbench.read(copy)
            (copy / "SHA256SUMS").unlink()
            with self.assertRaisesRegex(bezierbench.BundleError, "SHA256SUMS"):
                bezierbench.read(copy)

    def test_what_a_stranger_may_put_there_is_refused(self):
        """No pipe is waited for, no device read to its end, no link followed, and there is one kind of exception."""
        def seal(bundle):
            (bundle / "SHA256SUMS").write_text("".join(
                f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in sorted(bundle.iterdir())
                if file.is_file() and not file.is_symlink() and file.name != "SHA256SUMS"))

        def changed(name, content):
            def change(bundle):
                (bundle / name).write_bytes(content)
                seal(bundle)
            return change

        def replaced(name, make):
            def change(bundle):
                (bundle / name).unlink()
                make(bundle / name)
            return change

        complete = (self.baseline / "bundle.json").read_bytes()
        changes = [replaced(name, os.mkfifo) for name in ("SHA256SUMS", "bundle.json", "machine.json", "accuracy.csv")]
        changes += [replaced("accuracy.csv", lambda path: path.symlink_to("/dev/zero")),
                    replaced("accuracy.csv", lambda path: path.symlink_to(self.baseline / "accuracy.csv")),
                    replaced("accuracy.csv", Path.mkdir), replaced("accuracy.csv", lambda path: None)]
        changes += [changed("bundle.json", text) for text in (
            b"[]", b"[" * 100000, b"\xff", b"{", b'{"schema_version": ' + b"9" * 5000 + b"}", b'{"schema_version": true}',
            complete.replace(b'"complete"', b'"partial"'))]
        changes += [changed("machine.json", b"null"), changed("accuracy.csv", b'a\n"b'), changed("accuracy.csv", b"a\n\0\n"),
                    changed("accuracy.csv", b"a,b\n1\n"), changed("accuracy.csv", b""), changed("accuracy.csv", b"a,a\n1,2\n")]
        lines = (self.baseline / "SHA256SUMS").read_text().splitlines(keepends=True)
        for sums in (lines + lines[:1], [*lines, "0" * 64 + "  ../x\n"], lines + ["x\n"]):
            changes.append(lambda bundle, sums=sums: (bundle / "SHA256SUMS").write_text("".join(sums)))
        changes.append(lambda bundle: (bundle / "suite.toml").write_text("garbage"))
        for number, change in enumerate(changes):
            with self.subTest(number=number), tempfile.TemporaryDirectory() as folder:
                bundle = Path(folder) / "bundle"
                shutil.copytree(self.baseline, bundle)
                change(bundle)
                with self.assertRaises(bezierbench.BundleError) as caught:
                    bezierbench.read(bundle, frames=False)
                self.assertIn(str(bundle), str(caught.exception))
                self.assertLess(len(str(caught.exception)), 500 + len(str(bundle)))

    def test_numbers_are_those_of_the_program(self):
        """Python's float() takes more: 1_0, infinity, blanks, digits of other scripts."""
        for word, value in (("1.5", 1.5), ("-0x1.8p+1", -3.0), ("inf", math.inf), ("1_0", None), ("infinity", None), (" 1", None), ("٣", None),
                            ("0x1p99999", None)):
            self.assertEqual(files.number(word), value)
        with self.assertRaisesRegex(ValueError, "is not a number"):
            bezierbench.numbers("1 1_0")

    def test_the_schema_version_is_that_of_the_program(self):
        schema = json.loads((ROOT / "experiments/bundle/schema/tables.schema.json").read_text(encoding="utf-8"))
        self.assertEqual((files.SCHEMA, files.LAST_READER), (schema["version"], schema["last_reader_of_earlier"]))

    def test_frames(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        table = bezierbench.read(self.baseline)["accuracy"]
        self.assertIsInstance(table, pandas.DataFrame)
        self.assertGreater(table.query("method == 'de_casteljau'").max_error_u.max(), 1)


if __name__ == "__main__":
    unittest.main()
