// SPDX-License-Identifier: MIT
// Every stated bound against the exact halves, for random and difficult curves of degrees up to 40.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/subdivide/roster.hpp"
#include "core/subdivide/split_test.hpp"

namespace bezierbench {
namespace {

/// Kinds of curves, most of which have made splitting lose digits or range.
enum class Kind { drawn, sizes_far_apart, close_together, doubling_back, integers, subnormal, tiny, huge };
constexpr int kinds = 8;

double coordinate(Kind kind, int i, Inputs& inputs) {
  const double drawn = inputs.symmetric();
  switch (kind) {
    case Kind::drawn: return drawn;
    case Kind::sizes_far_apart: return std::ldexp(drawn, static_cast<int>(inputs.unit() * 80) - 40);
    case Kind::close_together: return 1 + 0x1p-45 * drawn;
    case Kind::doubling_back: return i % 2 == 0 ? 0.1 : -0.1;
    case Kind::integers: return std::floor(9 * drawn);
    case Kind::subnormal: return 0x1p-1066 * drawn;
    case Kind::tiny: return 0x1p-1010 * drawn;
    case Kind::huge: return 0x1p+1000 * drawn;
  }
  return 0;
}

std::vector<double> coordinates(Kind kind, int degree, int dimension, Inputs& inputs) {
  std::vector<double> c;
  for (int i = 0; i <= degree; ++i)
    for (int axis = 0; axis < dimension; ++axis) c.push_back(coordinate(kind, i, inputs));
  return c;
}

std::vector<double> weights(int degree, int binades, Inputs& inputs) {
  std::vector<double> w;
  for (int i = 0; i <= degree; ++i)
    w.push_back(std::ldexp(1 + inputs.unit(), static_cast<int>(binades * (inputs.unit() - 0.5))));
  return w;
}

/// The largest error / bound of a method, underflow left aside, and the number of judged values.
struct Record {
  double closest = 0;
  int judged = 0;
};
using Records = std::map<const MethodInfo*, Record>;

void judge(const SplitKernel& kernel, const CurveView<double>& curve, double t, const SplitTruth& truth,
           Records& records) {
  const int columns = split_columns(curve.form, curve.dimension);
  const auto halves = split(kernel, curve, t);
  auto& record = records[kernel.info];
  for (const bool left : {true, false})
    for (int i = 0; i <= curve.degree; ++i)
      for (int column = 0; column < columns; ++column) {
        const double value = (left ? halves.left : halves.right)[static_cast<std::size_t>(i * columns + column)];
        const auto [error, bound] = truth.judge(*kernel.bound, split_double, left, i, column, value);
        if (!std::isfinite(bound)) continue;
        ++record.judged;
        ASSERT_LE(error, bound * (1 + 0x1p-20))
            << kernel.info->id << " " << name(curve.form) << " degree " << curve.degree << " t " << t
            << (left ? " left " : " right ") << i << " column " << column;
        if (bound > 0x1p-1000) record.closest = std::max(record.closest, error / bound);
      }
}

void judge_all(const CurveView<double>& curve, double t, Records& records) {
  const SplitTruth truth(curve, t);
  for (const auto& kernel : split_kernels(curve.dimension))
    if (kernel.info->form == curve.form && kernel.bound != nullptr) judge(kernel, curve, t, truth, records);
}

/// No bound is much too wide: at low degrees the errors of each method come near to its bound.
void expect_sharp(const Records& records, std::size_t methods, int judged, double closest) {
  EXPECT_EQ(records.size(), methods);
  for (const auto& [info, record] : records) {
    EXPECT_GT(record.judged, judged) << info->id;
    EXPECT_GT(record.closest, closest) << info->id;
    EXPECT_LE(record.closest, 1) << info->id;
  }
}

TEST(SplitBound, HoldsForBernsteinCurves) {
  Inputs inputs(1);
  Records records;
  for (int kind = 0; kind < kinds; ++kind)
    for (const int degree : {0, 1, 2, 3, 5, 8, 20, 40})
      for (std::size_t k = 0; k < split_parameters.size() + 4; ++k) {
        const int dimension = degree < 8 ? 1 + kind % 3 : 1;
        const auto c = coordinates(static_cast<Kind>(kind), degree, dimension, inputs);
        const double t = k < split_parameters.size() ? split_parameters[k] : inputs.unit();
        judge_all({Form::bernstein, dimension, degree, c}, t, records);
      }
  expect_sharp(records, 5, 20000, 0.4);
}

TEST(SplitBound, HoldsForRationalCurves) {
  Inputs inputs(2);
  Records records;
  for (int kind = 0; kind < kinds; ++kind)
    for (const int degree : {0, 1, 2, 3, 5, 8, 20, 40})
      for (std::size_t k = 0; k < split_parameters.size() + 4; ++k) {
        const int dimension = degree < 8 ? 1 + kind % 3 : 1;
        const auto c = coordinates(static_cast<Kind>(kind), degree, dimension, inputs);
        const auto w = weights(degree, k % 2 == 0 ? 2 : 30, inputs);
        const double t = k < split_parameters.size() ? split_parameters[k] : inputs.unit();
        judge_all({Form::rational, dimension, degree, c, w}, t, records);
      }
  expect_sharp(records, 5, 40000, 0.2);
}

/// Products w_i b_i and sums of weights near the smallest numbers, and weights of 0 between others.
TEST(SplitBound, HoldsForTinyAndVanishingWeights) {
  Inputs inputs(3);
  Records records;
  for (const int of_points : {0, -500, -1060})
    for (const int of_weights : {0, -500, -1000})
      for (const int degree : {2, 3, 8})
        for (const double t : {0x1p-30, 0.3, 0.5, 1 - 0x1p-53}) {
          auto c = coordinates(Kind::drawn, degree, 1, inputs);
          auto w = weights(degree, 4, inputs);
          for (double& value : c) value = std::ldexp(value, of_points);
          for (double& value : w) value = std::ldexp(value, of_weights);
          w[1] = 0;
          judge_all({Form::rational, 1, degree, c, w}, t, records);
        }
  expect_sharp(records, 5, 2000, 0.1);
}

}  // namespace
}  // namespace bezierbench
