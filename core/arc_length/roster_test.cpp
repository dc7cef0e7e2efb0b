// SPDX-License-Identifier: MIT
// Lengths known in closed form, and the promise of every method: the result keeps the tolerance or says that it does
// not.
#include "core/arc_length/roster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench {
namespace {

/// A curve with the length of the part between two parameters.
struct Known {
  std::string name;
  int dimension;
  std::vector<double> points;
  double length;
  double from = 0;
  double to = 1;
  [[nodiscard]] CurveView<double> view() const {
    return {Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points};
  }
};

/// (u^2, u^3) with u = 2t - 1 has a cusp at u = 0; its length from there is ((4 + 9 u^2)^(3/2) - 8)/27.
const std::vector<double> cusp{1, -1, -1.0 / 3, 1, -1.0 / 3, -1, 1, 1};
double from_cusp(double u) { return (std::pow(4 + 9 * u * u, 1.5) - 8) / 27; }

/// C' = ((a(1-t) + bt) + i (c(1-t) + dt))^2, a Pythagorean hodograph: |C'| is a polynomial
/// ([Farouki and Sakkalis 1990]).
Known pythagorean(double a, double b, double c, double d) {
  const double hodograph[3][2]{{a * a - c * c, 2 * a * c}, {a * b - c * d, a * d + b * c}, {b * b - d * d, 2 * b * d}};
  Known curve{"Pythagorean hodograph", 2, {0, 0}, (a * a + a * b + b * b + c * c + c * d + d * d) / 3};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      curve.points.push_back(curve.points[2 * i + axis] + hodograph[i][axis] / 3);
  return curve;
}

std::vector<Known> known_curves() {
  std::vector<Known> all{
      {"line", 2, {1, 2, 4, 6}, 5},
      {"line of degree 3", 3, {0, 0, 0, 1, 2, 2, 2, 4, 4, 3, 6, 6}, 9},
      {"there and back", 1, {0, 1, 0}, 1},
      {"there and farther back", 1, {0, 2, -1}, 13.0 / 5},  // 4t - 5t^2 rises to 4/5, falls to -1: 4/5 + 9/5
      {"parabola", 2, {0, 0, 0.5, 0, 1, 1}, std::sqrt(5) / 2 + std::asinh(2) / 4},
      {"cusp at the beginning", 2, {0, 0, 0, 0, 1.0 / 3, 0, 1, 1}, (13 * std::sqrt(13) - 8) / 27},
      {"cusp in the middle", 2, cusp, 2 * from_cusp(1)},
  };
  for (const double to : {0.51, 0.7, 0.9})
    all.push_back({"cusp inside", 2, cusp, from_cusp(1) + from_cusp(2 * to - 1), 0, to});
  all.push_back({"cusp inside", 2, cusp, from_cusp(0.8) + from_cusp(0.3), 0.1, 0.65});
  all.push_back({"part of a parabola",
                 2,
                 {0, 0, 0.5, 0, 1, 1},
                 (std::sqrt(2) + std::asinh(1)) / 4 * 2 - (std::sqrt(2) + std::asinh(1)) / 4,
                 0,
                 0.5});
  Inputs inputs(3);
  for (int k = 0; k < 20; ++k)
    all.push_back(pythagorean(inputs.symmetric(), inputs.symmetric(), inputs.symmetric(), inputs.symmetric()));
  for (const double nearness : {1e-1, 1e-2, 1e-3, 1e-5, 1e-8}) {  // 0 would give a cusp at t = k
    const double k = 0.2 + 0.5 * inputs.unit();
    all.push_back(pythagorean(-k, 1 - k, nearness, nearness * 1.5));
  }
  return all;
}

Known scaled(Known curve, double factor) {
  for (double& value : curve.points) value *= factor;
  curve.length *= factor;
  return curve;
}

std::vector<ArcLengthKernel> methods_of_polynomials(int dimension) {
  std::vector<ArcLengthKernel> methods;
  for (const auto& kernel : arc_length_kernels(dimension))
    if (kernel.info->form == Form::bernstein) methods.push_back(kernel);
  return methods;
}

bool promises_something(const ArcLengthKernel& kernel) { return !kernel.info->promise.starts_with("none"); }

TEST(ArcLength, KeepsItsToleranceOrSaysSo) {
  for (const auto& original : known_curves())
    for (const double factor : {1.0, 1e-9, 1e10, 0x1p-900, 0x1p+900})
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17}) {
        const auto curve = scaled(original, factor);
        for (const auto& kernel : methods_of_polynomials(curve.dimension)) {
          const auto result = kernel.measure(curve.view(), curve.from, curve.to, tolerance);
          if (!result.converged) continue;
          const double error = std::abs(result.length - curve.length);
          const double of_known = 1e-14 * curve.length;  // rounding errors of the control points and the known length
          EXPECT_LE(error, tolerance * curve.length + of_known)
              << kernel.info->id << " " << curve.name << " x " << factor << " tolerance " << tolerance;
          EXPECT_LE(result.error_estimate, tolerance * result.length);
        }
      }
}

/// Cusps and near cusps at any place between the abscissae of the rules.
TEST(ArcLength, KeepsItsToleranceWhereverACuspIs) {
  Inputs inputs(5);
  for (int trial = 0; trial < 200; ++trial) {
    const double from = 0.499 * inputs.unit();
    const double to = 0.501 + 0.499 * inputs.unit();
    const double k = inputs.unit();
    const double nearness = std::ldexp(1.0, -static_cast<int>(30 * inputs.unit()));
    for (const auto& curve :
         {Known{"cusp", 2, cusp, from_cusp(1 - 2 * from) + from_cusp(2 * to - 1), from, to},
          Known{"turn", 1, {k * k, k * k - k, (1 - k) * (1 - k)}, k * k + (1 - k) * (1 - k)},  // (t - k)^2
          pythagorean(-k, 1 - k, nearness, nearness * 1.5)})
      for (const auto& kernel : methods_of_polynomials(curve.dimension))
        for (const double tolerance : {1e-2, 1e-3, 1e-5, 1e-8}) {
          const auto result = kernel.measure(curve.view(), curve.from, curve.to, tolerance);
          const bool one_panel = kernel.info->id == Simpson38::info.id;
          const double allowed = result.converged ? tolerance + 1e-14 : one_panel ? 0.5 : 0.05;
          EXPECT_LE(std::abs(result.length - curve.length), allowed * curve.length)
              << kernel.info->id << " " << curve.name << " trial " << trial << " tolerance " << tolerance;
        }
  }
}

/// Parts next to a cusp, where the roundings of cutting the curve are large compared with the length.
TEST(ArcLength, KeepsItsToleranceNextToACusp) {
  const CurveView<double> curve{Form::bernstein, 2, 3, cusp};
  for (int width = 1; width < 50; width += 4)
    for (const double beside : {0.0, 0.3, 1.0}) {
      const double from = 0.5 - std::ldexp(beside, -width);
      const double to = 0.5 + std::ldexp(1.0, -width);
      const reference::TrueLength truth(curve, from, to);
      const auto length = truth.value().convert_to<double>();
      for (const auto& kernel : methods_of_polynomials(2))
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
          const auto result = kernel.measure(curve, from, to, tolerance);
          EXPECT_TRUE(!result.converged || truth.error_of(result.length) <= tolerance * length)
              << kernel.info->id << " " << from << " " << to << " tolerance " << tolerance;
        }
    }
}

TEST(ArcLength, AdaptiveMethodsConvergeWhereTheyCan) {
  for (const auto& curve : known_curves())
    for (const auto& kernel : methods_of_polynomials(curve.dimension)) {
      const bool simpson = kernel.info->id == AdaptiveSimpson38::info.id;
      const bool gauss = kernel.info->id == GaussLegendreAdaptive::info.id;
      const double tolerance = simpson ? 1e-9 : gauss ? 1e-12 : 1e-4;
      const auto result = kernel.measure(curve.view(), curve.from, curve.to, tolerance);
      EXPECT_EQ(result.converged, promises_something(kernel))
          << kernel.info->id << " " << curve.name << ": estimate " << result.error_estimate << " of " << result.length;
      if (simpson || gauss) {
        EXPECT_LT(result.evaluations, 60000) << kernel.info->id << " " << curve.name;
      }
    }
}

TEST(ArcLength, ADifferenceBelowRoundingEndsAndIsNotPromised) {
  for (const auto& kernel : methods_of_polynomials(2)) {
    const auto result = kernel.measure({Form::bernstein, 2, 3, cusp}, 0, 1, 1e-18);
    EXPECT_FALSE(result.converged) << kernel.info->id;
    const bool adaptive = kernel.info->id.starts_with("adaptive") || kernel.info->id.ends_with("adaptive");
    if (adaptive) {
      EXPECT_NEAR(result.length, 2 * from_cusp(1), 1e-12) << kernel.info->id;
    }
  }
}

TEST(ArcLength, OfAPointIsZero) {
  const std::vector<double> point{0.1, 0.2, 0.1, 0.2, 0.1, 0.2};
  for (const auto& kernel : methods_of_polynomials(2))
    for (const int degree : {0, 2}) {
      const auto count = static_cast<std::size_t>(2 * (degree + 1));
      const auto result = kernel.measure({Form::bernstein, 2, degree, std::span(point).first(count)}, 0, 1, 1e-9);
      EXPECT_TRUE(result.converged && result.length == 0 && result.error_estimate == 0) << kernel.info->id;
      EXPECT_EQ(kernel.measure({Form::bernstein, 2, 3, cusp}, 0.3, 0.3, 1e-9).length, 0);
    }
}

/// Two rules agree by accident on few curves, so many curves are tried, of low degree, where bends are sharp.
TEST(ArcLength, AdaptiveMethodsAreNotFooledByChance) {
  Inputs inputs(8);
  for (int trial = 0; trial < 20000; ++trial) {
    const int n = 2 + trial % 3;
    const auto points = inputs.coefficients(n, 2);
    const CurveView<double> curve{Form::bernstein, 2, n, points};
    double reference = 0;
    for (const auto& kernel : methods_of_polynomials(2))
      if (kernel.info->id == GaussLegendreAdaptive::info.id) reference = kernel.measure(curve, 0, 1, 1e-11).length;
    for (const auto& kernel : methods_of_polynomials(2)) {
      if (kernel.info->id == ChordSum::info.id) continue;  // its tolerance is proved
      for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6}) {
        const auto result = kernel.measure(curve, 0, 1, tolerance);
        if (result.converged) {
          EXPECT_NEAR(result.length, reference, (tolerance + 1e-11) * reference)
              << kernel.info->id << " " << trial << " " << tolerance;
        }
      }
    }
  }
}

/// Checks every method on a curve against the true length, with tolerances from 1e-2 to 1e-15.
void expect_promises_kept(const std::vector<double>& points, int dimension) {
  const CurveView<double> curve{Form::bernstein, dimension, static_cast<int>(points.size()) / dimension - 1, points};
  const reference::TrueLength truth(curve, 0, 1);
  const auto length = truth.value().convert_to<double>();
  for (const auto& kernel : methods_of_polynomials(dimension))
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-12, 1e-15}) {
      const auto result = kernel.measure(curve, 0, 1, tolerance);
      EXPECT_TRUE(!result.converged || truth.error_of(result.length) <= tolerance * length)
          << kernel.info->id << " tolerance " << tolerance << ": " << result.length << " for " << truth.decimal(20);
      if (std::isnan(result.error_estimate)) continue;
      EXPECT_LE(truth.error_of(result.length), result.error_estimate) << kernel.info->id << " tolerance " << tolerance;
    }
}

/// A curve that turns between two abscissae of the sums that Simpson's rule compares. C' = 3 (72 t^2 - 70 t + 17) is
/// negative between 17/36 and 1/2 only, where its integral is -3 * 72/6 * (1/36)^3 = -1/1296, so that the length is 18
/// + 2/1296 = 11665/648.
TEST(ArcLength, SeesATurnBetweenTheAbscissae) {
  const std::vector<double> turn{1, 18, 0, 19};
  const CurveView<double> line{Form::bernstein, 1, 3, turn};
  const double known = 11665.0 / 648;
  for (const auto& kernel : methods_of_polynomials(1)) {
    const auto result = kernel.measure(line, 0, 1, 1e-9);
    EXPECT_TRUE(!result.converged || std::abs(result.length - known) <= 1e-9 * known) << kernel.info->id;
  }
  expect_promises_kept(turn, 1);
  expect_promises_kept({-7, .005, 12, -.001, -8, .005, 13, -.001}, 2);
  expect_promises_kept({1, 0, 0, 18, 1e-4, 0, 0, 1e-4, 1e-3, 19, 0, 0}, 3);
}

/// The same for all neighbours of that curve in whole numbers, on a line and as thin curves.
TEST(ArcLength, SeesTurnsOfSmallWholeNumbers) {
  Inputs inputs(9);
  for (int neighbour = 0; neighbour < 81; ++neighbour) {
    const std::vector<double> line{neighbour % 3 + 0.0, neighbour / 3 % 3 + 17.0, neighbour / 9 % 3 - 1.0,
                                   neighbour / 27 + 18.0};
    expect_promises_kept(line, 1);
    std::vector<double> thin;
    for (const double x : line) thin.insert(thin.end(), {x, std::floor(inputs.symmetric() * 20) * 1e-4});
    expect_promises_kept(thin, 2);
  }
}

/// All points have the same coordinate on one axis. It is up to 1e338 times their differences on the other axis.
TEST(ArcLength, IsThatOfTheDifferences) {
  const double length = 3e-30;
  for (const double far : {1e300, 1.7e308, -1e300, 1.0, 0.0})
    for (const auto& points : {std::vector<double>{far, 0, far, 1e-30, far, 3e-30}, {0, far, 1e-30, far, 3e-30, far}})
      for (const auto& kernel : methods_of_polynomials(2)) {
        const auto result = kernel.measure({Form::bernstein, 2, 2, points}, 0, 1, 1e-9);
        EXPECT_NEAR(result.length, length, 1e-9 * length) << kernel.info->id << " " << far;
        EXPECT_EQ(result.converged, !std::isnan(result.error_estimate)) << kernel.info->id << " " << far;
      }
}

/// A length that is not a double, or whose rounding exceeds the tolerance, is not promised.
TEST(ArcLength, AtTheEndsOfTheRangeIsNotPromisedUnlessItIsRight) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const double unit : {1.7e308, 8e307, 1e-307, least, 7 * least, 71 * least, 0x1p30 * least, 0x1p50 * least})
    for (const auto& shape : {std::vector<double>{-1, -1, 0.5, 1, 1, -1}, {0, 0, 0.3, 0.4, 0.4, 0}, {0, 0, 1, 1}}) {
      std::vector<double> points = shape;
      for (double& value : points) value *= unit;
      const CurveView<double> curve{Form::bernstein, 2, static_cast<int>(points.size()) / 2 - 1, points};
      const reference::TrueLength truth(curve, 0, 1);
      for (const auto& kernel : methods_of_polynomials(2))
        for (const double tolerance : {1e-2, 1e-6, 1e-9}) {
          const auto result = kernel.measure(curve, 0, 1, tolerance);
          const auto error = abs(reference::LongReal(result.length) - truth.value());
          EXPECT_TRUE(!result.converged || (std::isfinite(result.length) && error <= tolerance * truth.value()))
              << kernel.info->id << " " << unit << " " << tolerance << ": " << result.length;
          if (std::isfinite(result.error_estimate)) {
            EXPECT_LE(error, result.error_estimate) << kernel.info->id << " " << unit;
          }
        }
    }
}

/// A part of width 2^width of a straight line of length 3 2^size has the length 3 2^(size + width). An error that is
/// not 0 is at least the least double, so a length that is smaller than that over the tolerance is not promised.
TEST(ArcLength, OfANarrowPartIsAccurate) {
  constexpr double tolerance = 1e-9;
  for (const int size : {0, 500, 1000})
    for (const int width : {-900, -1040, -1060, -1074}) {
      const std::vector<double> line{0, 0, std::ldexp(3, size), 0};
      const double length = std::ldexp(3, size + width);
      for (const auto& kernel : methods_of_polynomials(2)) {
        const auto result = kernel.measure({Form::bernstein, 2, 1, line}, 0, std::ldexp(1, width), tolerance);
        EXPECT_NEAR(result.length, length, tolerance * length) << kernel.info->id << " " << size << " " << width;
        const bool promised = tolerance * length >= std::numeric_limits<double>::denorm_min();
        EXPECT_EQ(result.converged, promised && !std::isnan(result.error_estimate))
            << kernel.info->id << " " << size << " " << width;
      }
    }
}

/// Beyond the looser of two tolerances, the error at the tighter one is not the larger one.
TEST(ArcLength, IsNotWorseAtATighterTolerance) {
  Inputs inputs(10);
  // The first: y = 469 - 3t + 15t^2 - 9t^3, a public report.
  std::vector<double> points{377, 469, 377, 468, 377, 472, 377, 472};
  for (int trial = 0; trial < 60; ++trial) {
    const int n = static_cast<int>(points.size()) / 2 - 1;
    const CurveView<double> curve{Form::bernstein, 2, n, points};
    const reference::TrueLength truth(curve, 0, 1);
    for (const auto& kernel : methods_of_polynomials(2)) {
      if (kernel.info->id == Seed000Simpson38::info.id) continue;  // its errors at a turn are accidents
      double looser = std::numeric_limits<double>::infinity();
      for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        const double error = truth.error_of(kernel.measure(curve, 0, 1, tolerance).length);
        EXPECT_LE(error, looser) << kernel.info->id << " degree " << n << " trial " << trial << " " << tolerance;
        looser = std::max(error, tolerance * truth.value().convert_to<double>());
      }
    }
    points = inputs.coefficients(2 + trial % 5, 2);
  }
}

/// A part that becomes 0 when it is cut still has a length, below the roundings, and is not promised.
TEST(ArcLength, OfAPartThatIsLostIsNotPromised) {
  const std::vector<double> rests{0, 0, 0, 1};  // t^3
  for (const auto& kernel : methods_of_polynomials(1))
    EXPECT_FALSE(kernel.measure({Form::bernstein, 1, 3, rests}, 0, 1e-200, 1e-2).converged) << kernel.info->id;
}

double length_by(const MethodInfo& method, const Known& curve, double tolerance) {
  for (const auto& kernel : methods_of_polynomials(curve.dimension))
    if (kernel.info == &method) return kernel.measure(curve.view(), curve.from, curve.to, tolerance).length;
  throw std::invalid_argument(std::string(method.id));
}

/// Four speeds by hand: 4, 2/3, 8/3, 6 of 4 - 10 t, and 1, sqrt(13)/3, 5/3, sqrt(5) of the parabola.
TEST(Simpson38, OfOnePanel) {
  EXPECT_NEAR(length_by(Simpson38::info, {"there and farther back", 1, {0, 2, -1}, 2.6}, 1e-9), 2.5, 1e-15);
  EXPECT_NEAR(length_by(Simpson38::info, {"parabola", 2, {0, 0, 0.5, 0, 1, 1}, 1.4789}, 1e-9),
              (6 + std::sqrt(13) + std::sqrt(5)) / 8, 1e-15);
}

/// The factor 15 of [Document 000] is right: on t^4 the errors of one panel and of its halves are 1/270 and 1/4320, and
/// what is extrapolated is exact.
TEST(Simpson38, OfAPowerOfFourIsExactAfterExtrapolation) {
  const auto power = [](double t) { return t * t * t * t; };
  const double whole = simpson38_panel(power, 0, 1);
  const double halves = simpson38_panel(power, 0, 0.5) + simpson38_panel(power, 0.5, 1);
  EXPECT_NEAR(whole - 0.2, 1.0 / 270, 1e-16);
  EXPECT_NEAR(halves - 0.2, 1.0 / 4320, 1e-16);
  EXPECT_NEAR(Seed000Simpson38::integral(power, 0, 1, 1, 0), 0.2, 1e-16);
}

/// The printed test |S_left + S_right - S| <= 15 eps accepts lengths that are off by more than eps: of random cubics
/// one in seven at the document's eps of 1e-4, and a turn between two abscissae at any eps.
TEST(SourceDocument, PrintedSimpsonTestBreaksItsPromise) {
  const Known turn{"turn", 1, {1, 18, 0, 19}, 11665.0 / 648};
  for (const double tolerance : {1e-4, 1e-6, 1e-9, 1e-12})
    EXPECT_NEAR(turn.length - length_by(Seed000Simpson38::info, turn, tolerance), 1.0 / 648, 1e-13);
  Inputs inputs(11);
  constexpr int trials = 2000;
  constexpr double tolerance = 1e-4;
  int broken = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Known cubic{"cubic", 2, inputs.coefficients(3, 2), 0};
    cubic.length = length_by(GaussLegendreAdaptive::info, cubic, 1e-11);
    const auto off = [&](const MethodInfo& method) {
      return std::abs(length_by(method, cubic, tolerance) - cubic.length) / cubic.length;
    };
    broken += off(Seed000Simpson38::info) > 2 * tolerance ? 1 : 0;
    EXPECT_LE(off(AdaptiveSimpson38::info), tolerance);
  }
  EXPECT_GT(broken, trials / 20);
}

/// [Document 000], section 3.1, takes a chord for the step times the speed at some t between. A closed curve has a
/// chord of 0, and the speed of this one, 9 |((1-t)^2 - 2t(1-t), 2t(1-t) - t^2)|, is nowhere 0.
TEST(SourceDocument, AChordIsNotASpeedTimesAStep) {
  const std::vector<double> closed{0, 0, 3, 0, 0, 3, 0, 0};
  double least = 9;
  for (int k = 0; k <= 64; ++k) {
    const double t = k / 64.0;
    least = std::min(least, 9 * std::hypot((1 - t) * (1 - t) - 2 * t * (1 - t), 2 * t * (1 - t) - t * t));
  }
  EXPECT_GT(least, 2);
  for (const auto& kernel : methods_of_polynomials(2))
    EXPECT_GT(kernel.measure({Form::bernstein, 2, 3, closed}, 0, 1, 1e-6).length, 2);
}

/// The example of [Document 000], section 3.2: (R cos t^2, R sin t^2), whose speed is 2 R t and whose length is R t^2,
/// eq. (16). Equal steps of t cover 1 and 39 of 400 parts of the circle; those at t = sqrt(s/R) are even.
TEST(SourceDocument, CircleBySquareOfT) {
  constexpr double R = 200;
  constexpr int steps = 20;
  const double pi = std::acos(-1);
  const double end = std::sqrt(2 * pi);
  const auto speed = [](double t) {  // |C'|, from the derivatives of both coordinates
    return std::hypot(-2 * R * t * std::sin(t * t), 2 * R * t * std::cos(t * t));
  };
  const auto share = [&](double from, double to) { return simpson38_panel(speed, from, to) / (2 * pi * R); };
  EXPECT_NEAR(share(0, end), 1, 1e-14);
  EXPECT_NEAR(share(0, end / steps), 1.0 / 400, 1e-15);
  EXPECT_NEAR(share(end - end / steps, end), 39.0 / 400, 1e-14);
  const auto at = [&](int k) { return std::sqrt(2 * pi * k / steps); };  // sqrt(s/R)
  for (int k = 0; k < steps; ++k) EXPECT_NEAR(share(at(k), at(k + 1)), 1.0 / steps, 1e-14);
}

TEST(GaussLegendre, IntegratesPolynomialsExactly) {
  const auto check = []<int Points>(std::integral_constant<int, Points>) {
    for (int power = 0; power < 2 * Points; ++power)
      EXPECT_NEAR(gauss_integral<Points>([power](double t) { return std::pow(t, power); }), 1.0 / (power + 1), 4e-16)
          << Points << " points, power " << power;
    EXPECT_GT(std::abs(gauss_integral<Points>([](double t) { return std::pow(2 * t - 1, 2 * Points); }) -
                       1.0 / (2 * Points + 1)),
              1e-16);
  };
  check(std::integral_constant<int, 8>{});
  check(std::integral_constant<int, 16>{});
  check(std::integral_constant<int, 24>{});
}

}  // namespace
}  // namespace bezierbench
