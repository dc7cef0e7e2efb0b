// SPDX-License-Identifier: MIT
// Parameters at known lengths, and the promise of every method: the result keeps the tolerance or says that it does
// not.
#include "core/arc_length/inverse/roster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/length/length_truth.hpp"

namespace bezierbench {
namespace {

using Points = std::vector<double>;
using reference::LongReal;
using LengthAlong = reference::LengthAlong<LongReal>;

CurveView<double> view(const Points& points, int dimension = 2) {
  return {Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points};
}

std::vector<InverseArcLengthKernel> methods_of(Form form, int dimension) {
  std::vector<InverseArcLengthKernel> methods;
  for (const auto& kernel : inverse_arc_length_kernels(dimension))
    if (kernel.info->form == form) methods.push_back(kernel);
  return methods;
}

std::vector<InverseArcLengthKernel> methods_of_polynomials(int dimension) {
  return methods_of(Form::bernstein, dimension);
}

InverseArcLengthKernel kernel_of(const MethodInfo& info, int dimension = 2) {
  for (const auto& kernel : methods_of_polynomials(dimension))
    if (kernel.info->id == info.id) return kernel;
  throw std::out_of_range("no such method");
}

/// |s(t) - target| over the length of the curve. A t beyond an end counts as that end.
double length_error(const LengthAlong& truth, double t, double target) {
  const LongReal error = abs(truth.length_to(LongReal(t)) - target) / truth.whole();
  return error.convert_to<double>();
}

const Points cusp{3, -3, -1, 3, -1, -3, 3, 3};  // 3 (u^2, u^3), u = 2t - 1
const Points sharp{0, 0, 1, 1, 0.1, 1, 1, 0};

struct Case {
  std::string name;
  int dimension;
  Points points;
};

std::vector<Case> nasty() {
  return {{"line", 2, {1, 2, 4, 6}},
          {"there and back", 1, {0, 1, 0}},
          {"there and farther back", 2, {0, 0, 2, 4, -1, -2}},
          {"parabola", 2, {0, 0, 0.5, 0, 1, 1}},
          {"cusp in the middle", 2, cusp},
          {"cusp at the beginning", 2, {0, 0, 0, 0, 1, 0, 3, 3}},
          {"cusp at the end", 2, {3, 3, 1, 0, 0, 0, 0, 0}},
          {"sharp", 2, sharp},
          {"rests at the beginning, of order 9", 1, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}},
          {"rests inside", 1, {-1, 1, -1, 1, -1, 1, -1, 1}},
          {"closed", 2, {0, 0, 3, 3, -3, 3, 0, 0}},
          {"in space", 3, {0, 0, 0, 1, 2, -1, 5, 0, 0, 1, 1, 9}}};
}

TEST(InverseArcLength, KeepsItsToleranceOrSaysSo) {
  for (const auto& curve : nasty())
    for (const int exponent : {0, -30, 33, -900, 900}) {
      Points points = curve.points;
      for (double& value : points) value = std::ldexp(value, exponent);
      const LengthAlong truth(view(points, curve.dimension));
      for (const double share : {0.0, 1e-9, 0.1, 0.3, 0.5, 0.77, 1 - 1e-9, 1.0})
        for (const double tolerance : {1e-2, 1e-4, 1e-9, 1e-12, 1e-15}) {
          const double target = LongReal(share * truth.whole()).convert_to<double>();
          for (const auto& kernel : methods_of_polynomials(curve.dimension)) {
            const auto result = kernel.solve(view(points, curve.dimension), target, tolerance);
            const auto what = std::string(kernel.info->id) + ", " + curve.name + ", share " + std::to_string(share) +
                              ", tolerance " + std::to_string(std::log10(tolerance)) + ", 2^" +
                              std::to_string(exponent);
            if (result.converged) {
              EXPECT_LE(length_error(truth, result.t, target), tolerance * (1 + 1e-9)) << what;
              EXPECT_TRUE(result.t >= 0 && result.t <= 1) << what;
              EXPECT_LE(result.error_estimate, tolerance * truth.whole()) << what;
            }
            const bool guarded = kernel.info->id == BracketedNewton::info.id || kernel.info->id == Halley::info.id;
            EXPECT_TRUE(result.converged || !guarded || tolerance < 1e-12) << what;
          }
        }
    }
}

/// The circle ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) reaches the angle a at tan(a / 2), whatever its size and weights.
TEST(InverseArcLength, OfTheQuarterCircleIsATangent) {
  EXPECT_GE(methods_of(Form::rational, 2).size(), 2U);
  for (const auto& kernel : methods_of(Form::rational, 2))
    for (const double size : {0x1p-900, 1.0, 0x1p+900}) {
      const Points points{size, 0, size, size, 0, size};
      const Points weights{-0x1p-30, -0x1p-30, -0x1p-29};
      for (const double angle : {0.0, 1e-9, 0.1, 0.7, 1.5, 1.57}) {
        const auto found = kernel.solve({Form::rational, 2, 2, points, weights}, angle * size, 1e-12);
        EXPECT_TRUE(found.converged) << kernel.info->id << " " << angle;
        EXPECT_NEAR(found.t, std::tan(angle / 2), 1e-11) << kernel.info->id;
      }
    }
}

/// Random rational curves, some of weights over forty binades, some of both signs.
TEST(InverseArcLength, OfRationalCurvesKeepsItsToleranceOrSaysSo) {
  Inputs inputs(9);
  int converged = 0;
  int trials = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 2 + trial % 4;
    Points points;
    Points weights;
    for (int i = 0; i <= n; ++i) {
      points.insert(points.end(), {inputs.symmetric(), inputs.symmetric()});
      const double inner =
          trial % 3 == 1 ? std::ldexp(1.0, static_cast<int>(20 * inputs.symmetric())) : inputs.symmetric() / n;
      weights.push_back(i == 0 || i == n || trial % 3 == 0 ? 1 + inputs.unit() : inner);
    }
    const CurveView<double> curve{Form::rational, 2, n, points, weights};
    if (reference::pole(curve)) continue;
    const LengthAlong truth(curve);
    for (const double tolerance : {1e-3, 1e-9, 1e-12})
      for (const auto& kernel : methods_of(Form::rational, 2)) {
        const double target = LongReal(inputs.unit() * truth.whole()).convert_to<double>();
        const auto found = kernel.solve(curve, target, tolerance);
        const double error = LongReal(length_error(truth, found.t, target) * truth.whole()).convert_to<double>();
        EXPECT_LE(error, found.error_estimate) << kernel.info->id << " " << trial;
        EXPECT_FALSE(found.converged && error > tolerance * (1 + 1e-9) * truth.whole())
            << kernel.info->id << " " << trial;
        ++trials;
        converged += found.converged ? 1 : 0;
      }
  }
  EXPECT_GT(trials, 100);
  EXPECT_GT(converged, trials / 2);
}

TEST(InverseArcLength, EndsWhereRoundingPermitsNoMore) {
  Points large = sharp;
  for (double& value : large) value *= 5e7;  // a length near 1e8: 1e-9 of a unit is 1e-17 of it
  const LengthAlong truth(view(large));
  for (const auto& kernel : methods_of_polynomials(2)) {
    const auto result = kernel.solve(view(large), 0.3e8, 1e-17);
    EXPECT_FALSE(result.converged) << kernel.info->id;
    EXPECT_LE(result.evaluations, 60000) << kernel.info->id;
    EXPECT_GE(result.error_estimate, std::abs(length_error(truth, result.t, 0.3e8)) * 1e8 / 2) << kernel.info->id;
    if (kernel.info->id == BracketedNewton::info.id || kernel.info->id == Halley::info.id) {
      EXPECT_LE(length_error(truth, result.t, 0.3e8), 1e-14) << kernel.info->id;
      EXPECT_LE(result.iterations, 20) << kernel.info->id;
    }
  }
}

TEST(InverseArcLength, OfAPointIsItsBeginning) {
  const Points point{0.1, 0.2, 0.1, 0.2, 0.1, 0.2};
  for (const auto& kernel : methods_of_polynomials(2)) {
    const auto result = kernel.solve(view(point), 0, 1e-9);
    EXPECT_TRUE(result.converged && result.t == 0 && result.iterations == 0) << kernel.info->id;
    EXPECT_FALSE(kernel.solve(view(point), 1, 1e-9).converged) << kernel.info->id;
  }
}

TEST(InverseArcLength, ALengthBeyondTheCurveIsNotReached) {
  for (const auto& kernel : methods_of_polynomials(2))
    for (const double target : {-1.0, 1e3, 1e300}) {
      const auto result = kernel.solve(view(cusp), target, 1e-9);
      EXPECT_FALSE(result.converged) << kernel.info->id << " " << target;
      if (kernel.info->id != Seed000Newton::info.id) {
        EXPECT_EQ(result.t, target < 0 ? 0 : 1) << kernel.info->id;
      }
    }
}

/// Points with distances of about 1e-30 on one axis and the same coordinate, 1e300, on the other: s = 2t + t^2 times
/// 1e-30.
TEST(InverseArcLength, IsThatOfTheDifferences) {
  const double target = 1.5e-30;
  for (const double far : {1e300, 1.7e308, 0.0})
    for (const auto& kernel : methods_of_polynomials(2)) {
      const auto result = kernel.solve(view({far, 0, far, 1e-30, far, 3e-30}), target, 1e-4);
      EXPECT_TRUE(result.converged) << kernel.info->id << " " << far;
      EXPECT_NEAR((2 + result.t) * result.t, 1.5, 3e-4) << kernel.info->id << " " << far;
    }
}

/// Curves on which two sums agree with each other although both miss part of the length.
TEST(InverseArcLength, KeepsItsToleranceOnThinCurves) {
  const std::vector<Case> thin{{"turns", 1, {1, 18, 0, 19}},
                               {"thin", 2, {-7, .005, 12, -.001, -8, .005, 13, -.001}},
                               {"thin in space", 3, {1, 0, 0, 18, 1e-4, 0, 0, 1e-4, 1e-3, 19, 0, 0}}};
  for (const auto& curve : thin) {
    const auto given = view(curve.points, curve.dimension);
    const LengthAlong truth(given);
    for (int part = 1; part < 40; ++part) {
      const double target = LongReal(truth.whole() * part / 40).convert_to<double>();
      for (const auto& kernel : methods_of_polynomials(curve.dimension))
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
          const auto result = kernel.solve(given, target, tolerance);
          EXPECT_TRUE(!result.converged || length_error(truth, result.t, target) <= tolerance * (1 + 1e-9))
              << kernel.info->id << ", " << curve.name << ", part " << part << ", tolerance " << tolerance;
        }
    }
  }
}

/// The length and the derivatives of one curve, for the formulas of [Document 000].
struct Formula {
  Points points;
  double target;
  [[nodiscard]] double distance(double t) const {
    return arc_length_kernels(2)[2].measure(view(points), 0, t, 1e-13).length - target;
  }
  [[nodiscard]] Point<double, 2> derivative(int order, double t) const {
    Curve<Form::bernstein, double, 2> curve(static_cast<int>(points.size()) / 2 - 1);
    for (std::size_t i = 0; i < points.size(); ++i) curve(static_cast<int>(i % 2), static_cast<int>(i / 2)) = points[i];
    return HornerBernstein::evaluate(HornerBernstein::prepare(hodograph(curve, order)), t);
  }
};

/// [Document 000], eq. (19) and (20), as printed: g'' is without the factor 2 of |C'|^2, so near the root a step is
/// twice Newton's, and t jumps from one side to the other for ever.
TEST(SourceDocument, PrintedFormulaNeverConverges) {
  const Formula formula{{0, 0, 0.5, 0, 1, 1}, 0.7};
  double t = 0.7 / 1.4789428575445974;  // s / L, L = sqrt(5)/2 + asinh(2)/4
  double nearest = 1;
  for (int k = 0; k < 40; ++k) {
    const double d = formula.distance(t);
    nearest = std::min(nearest, std::abs(d));
    const double speed = formula.derivative(1, t).norm();
    t -= 2 * d * speed / (2 * d * formula.derivative(2, t).norm() + speed * speed);
  }
  EXPECT_GT(nearest, 1e-3);
  const auto code = kernel_of(Seed000Newton::info).solve(view(formula.points), formula.target, 1e-9);
  EXPECT_TRUE(code.converged);  // the code divides both derivatives by 2
}

/// (t, t^2), whose length up to t is t sqrt(1 + 4 t^2)/2 + asinh(2t)/4. [Document 000] means t = 1/4 where it prints
/// 0.4; [Document 004] says that t = 0.2 cuts a curve into 20 % and 80 %.
TEST(SourceDocument, AQuarterOfTheLengthIsNotAtAQuarterOfT) {
  const Points parabola{0, 0, 0.5, 0, 1, 1};
  const auto share = [](double t) {
    const auto length = [](double x) { return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4; };
    return length(t) / length(1);
  };
  EXPECT_NEAR(share(0.25), 0.1758, 1e-4);
  EXPECT_NEAR(share(0.4), 0.2970, 1e-4);
  EXPECT_NEAR(share(0.2), 0.1388, 1e-4);
  const double whole = LengthAlong(view(parabola)).whole().convert_to<double>();
  for (const auto& info : {BracketedNewton::info, Halley::info}) {
    const auto quarter = kernel_of(info).solve(view(parabola), whole / 4, 1e-12);
    EXPECT_NEAR(share(quarter.t), 0.25, 1e-11) << info.id;
    EXPECT_GT(quarter.t, 0.3) << info.id;
  }
}

/// [Document 000], eq. (15): the derivative of C by the length is C'/|C'|, of size 1. The equation before it, that this
/// size is |C'(t)|, holds on (2t, 0) nowhere: there |C'| is 2.
TEST(SourceDocument, TheDerivativeByTheLengthHasSizeOne) {
  for (const auto& points : {Points{0, 0, 2, 0}, sharp}) {
    const Formula formula{points, 0};
    const double whole = LengthAlong(view(points)).whole().convert_to<double>();
    constexpr double step = 1e-4;
    for (const double part : {0.1, 0.4, 0.8}) {
      const auto t_at = [&](double length) {
        return kernel_of(BracketedNewton::info).solve(view(points), length, 1e-13).t;
      };
      const auto chord =
          (formula.derivative(0, t_at(whole * part + step)) - formula.derivative(0, t_at(whole * part))).eval();
      EXPECT_NEAR(chord.norm() / step, 1, 1e-5);
      EXPECT_GT(std::abs(formula.derivative(1, t_at(whole * part)).norm() - 1), 0.01);
    }
  }
}

/// Equal chords are not equal arcs. At half the length of a parabola the error falls by 4 when the number of chords is
/// doubled.
TEST(ChordEqualising, IsBiasedBySecondOrder) {
  const Points parabola{0, 0, 0.5, 0, 1, 1};
  const LengthAlong truth(view(parabola));
  const double half = LongReal(truth.whole() / 2).convert_to<double>();
  const auto& kernel = kernel_of(ChordEqualising::info);
  double before = 0;
  for (const double tolerance : {1e-3, 1e-3 / 4, 1e-3 / 16}) {
    const auto result = kernel.solve(view(parabola), half, tolerance);
    ASSERT_TRUE(result.converged);
    const double error = length_error(truth, result.t, half);
    EXPECT_GT(error, 0);
    EXPECT_NEAR(before / error, 4, before == 0 ? 4 : 1);
    before = error;
  }
}

/// s(t) = 3 2^size t up to the least targets: the estimate includes what underflows.
TEST(InverseArcLength, EstimatesWhatUnderflows) {
  for (const int size : {0, 500, 1000})
    for (const double target : {0x1p-1074, 0x5p-1074, 0x1.8p-1060, 1e-310, 1e-100}) {
      const std::vector<double> line{0, std::ldexp(3, size)};
      for (const auto& kernel : methods_of_polynomials(1)) {
        const auto result = kernel.solve({Form::bernstein, 1, 1, line}, target, 1e-9);
        if (std::isnan(result.error_estimate)) continue;
        const reference::LongReal error = abs(reference::LongReal(result.t) * line[1] - reference::LongReal(target));
        EXPECT_LE(error, result.error_estimate) << kernel.info->id << " " << size << " " << target;
      }
    }
}

}  // namespace
}  // namespace bezierbench
