// SPDX-License-Identifier: MIT
// Lengths of rational curves: known ones, and the promises of all methods against the true length.
#include "core/arc_length/rational_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/length/true_length.hpp"

namespace bezierbench {
namespace {

struct RationalCurve {
  int dimension;
  std::vector<double> points;
  std::vector<double> weights;
  [[nodiscard]] CurveView<double> view() const {
    return {Form::rational, dimension, static_cast<int>(weights.size()) - 1, points, weights};
  }
};

std::vector<ArcLengthKernel> rational_methods(int dimension) {
  std::vector<ArcLengthKernel> methods;
  for (const auto& kernel : arc_length_kernels(dimension))
    if (kernel.info->form == Form::rational) methods.push_back(kernel);
  EXPECT_GE(methods.size(), 4U);
  return methods;
}

bool is_proved(const ArcLengthKernel& kernel) { return kernel.info->promise.find("none") == std::string_view::npos; }

const RationalCurve quarter{2, {1, 0, 1, 1, 0, 1}, {1, 1, 2}};

TEST(RationalLength, OfTheQuarterCircleIsHalfOfPi) {
  constexpr double half_pi = std::numbers::pi / 2;
  for (const auto& kernel : rational_methods(2)) {
    const auto found = kernel.measure(quarter.view(), 0, 1, 1e-10);
    EXPECT_EQ(found.converged, is_proved(kernel)) << kernel.info->id;
    EXPECT_NEAR(found.length, half_pi, kernel.info->id == "simpson38" ? 2e-2 : 1e-10) << kernel.info->id;
    // The angle at t is 2 atan(t).
    const auto part = kernel.measure(quarter.view(), 0.25, 0.75, 1e-10);
    EXPECT_NEAR(part.length, 2 * (std::atan(0.75) - std::atan(0.25)), kernel.info->id == "simpson38" ? 1e-3 : 1e-10);
  }
}

/// Where a rational curve is, how large it is and by what all its weights are multiplied does not matter.
TEST(RationalLength, IsThatOfTheScaledCurve) {
  for (const auto& kernel : rational_methods(2)) {
    const auto found = kernel.measure(quarter.view(), 0, 0.875, 1e-9);
    for (const double size : {0x1p-1000, 1.0, 0x1p+1020})
      for (const double weight : {0x1p-700, 1.0, -0x1p+900}) {
        RationalCurve scaled = quarter;
        for (double& x : scaled.points) x = (size == 1 ? x + 0x1p+50 : x) * size;
        for (double& w : scaled.weights) w *= weight;
        const auto other = kernel.measure(scaled.view(), 0, 0.875, 1e-9);
        EXPECT_EQ(other.length, found.length * size) << kernel.info->id;
        EXPECT_EQ(other.evaluations, found.evaluations);
        EXPECT_EQ(other.converged, found.converged);
      }
  }
}

double between(Inputs& inputs, double low, double high) { return low + (high - low) * inputs.unit(); }

enum class Weights { mild, wild, of_both_signs };

RationalCurve drawn(Weights kind, int dimension, int degree, Inputs& inputs) {
  RationalCurve curve{dimension, {}, {}};
  for (int i = 0; i <= degree; ++i) {
    for (int axis = 0; axis < dimension; ++axis) curve.points.push_back(between(inputs, -1, 1));
    double w = between(inputs, 0.5, 2);
    if (kind == Weights::wild) w = std::ldexp(w, static_cast<int>(between(inputs, -20, 20)));
    if (kind == Weights::of_both_signs && i > 0 && i < degree) w = between(inputs, -1, 1);
    curve.weights.push_back(w);
  }
  return curve;
}

/// The estimate of a proved method is never below its error, and a method that says that it converged did.
TEST(RationalLength, KeepsItsPromise) {
  Inputs inputs(1);
  int converged = 0;
  int trials = 0;
  for (int k = 0; k < 3; ++k)
    for (const int dimension : {1, 2, 3})
      for (const int degree : {1, 2, 3, 5, 9})
        for (int trial = 0; trial < 6; ++trial) {
          const auto curve = drawn(static_cast<Weights>(k), dimension, degree, inputs);
          if (reference::pole(curve.view())) continue;
          const double from = trial % 2 == 0 ? 0 : between(inputs, 0, 0.5);
          const double to = trial % 3 == 0 ? 1 : between(inputs, 0.5, 1);
          const reference::TrueLength truth(curve.view(), from, to);
          for (const double tolerance : {1e-3, 1e-9, 1e-13})
            for (const auto& kernel : rational_methods(dimension)) {
              const auto found = kernel.measure(curve.view(), from, to, tolerance);
              const double error = truth.error_of(found.length);
              ++trials;
              converged += found.converged ? 1 : 0;
              const auto what =
                  std::string(kernel.info->id) + " " + std::to_string(k) + " degree " + std::to_string(degree);
              EXPECT_FALSE(is_proved(kernel) && error > found.error_estimate) << what;
              const double allowed = tolerance * truth.value().convert_to<double>() * (1 + 1e-12);
              EXPECT_FALSE(found.converged && error > allowed) << what;
            }
        }
  EXPECT_GT(converged, trials / 4);
}

TEST(RationalLength, IsNotFoundAcrossAPole) {
  for (const std::vector<double>& weights :
       {std::vector{1.0, -1.0, 1.0}, {1.0, -2.0, 1.0}, {1.0, 1.0, -1.0}, {0.0, 1.0, 1.0}})
    for (const auto& kernel : rational_methods(2)) {
      const RationalCurve curve{2, quarter.points, weights};
      EXPECT_FALSE(kernel.measure(curve.view(), 0, 1, 1e-3).converged) << kernel.info->id;
    }
}

/// (0, 0), (0, 0), (1, 0), (1, 1) begins with a cusp, and the numbers 0, 1, 0 turn.
TEST(RationalLength, ComesToAnEndAtCuspsAndTurns) {
  for (const auto& kernel : rational_methods(2)) {
    if (!is_proved(kernel)) continue;
    const RationalCurve cusp{2, {0, 0, 0, 0, 1, 0, 1, 1}, {1, 0.5, 2, 1}};
    const auto found = kernel.measure(cusp.view(), 0, 1, 1e-6);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(found.evaluations, 2000);
    const RationalCurve turn{2, {0, 0, 1, 2, 0, 0}, {1, 0.3, 2}};
    EXPECT_TRUE(kernel.measure(turn.view(), 0, 1, 1e-6).converged);
  }
}

/// The products of binomials stay finite up to the largest degree.
TEST(RationalLength, IsFoundAtTheLargestDegree) {
  RationalCurve line{1, {}, {}};
  for (int i = 0; i <= rational_degree_limit; ++i) {
    line.points.push_back(i);
    line.weights.push_back(1 + i % 3);
  }
  for (const auto& kernel : rational_methods(1)) {
    EXPECT_EQ(kernel.info->max_degree, rational_degree_limit);
    const auto found = kernel.measure(line.view(), 0, 1, 1e-6);
    EXPECT_NEAR(found.length, rational_degree_limit, kernel.info->id == "simpson38" ? 100 : 0.5) << kernel.info->id;
  }
}

}  // namespace
}  // namespace bezierbench
