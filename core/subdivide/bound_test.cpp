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

/// The same functions in float, which has another unit roundoff and range.
template <SplitMethod M>
void judge_in_float(Inputs& inputs, int& judged) {
  constexpr int dimension = 2;
  for (const int degree : {0, 1, 2, 3, 8, 20, 40})
    for (int repeat = 0; repeat < 8; ++repeat) {
      Curve<M::info.form, float, dimension> curve(degree);
      std::vector<double> c;
      std::vector<double> w;
      auto& points = [&]() -> auto& {
        if constexpr (M::info.form == Form::rational)
          return curve.points;
        else
          return curve;
      }
      ();
      for (int i = 0; i <= degree; ++i) {
        for (int axis = 0; axis < dimension; ++axis) {
          points(axis, i) = static_cast<float>(std::ldexp(inputs.symmetric(), repeat % 4 == 3 ? -130 : 0));
          c.push_back(points(axis, i));
        }
        if constexpr (M::info.form == Form::rational) {
          curve.weights[i] = static_cast<float>(1 + inputs.unit());
          w.push_back(curve.weights[i]);
        }
      }
      const auto t = repeat == 0 ? 1 - 0x1p-24F : static_cast<float>(inputs.unit());
      const auto halves = M::split(curve, t);
      const SplitTruth truth({M::info.form, dimension, degree, c, w}, t);
      for (const bool left : {true, false})
        for (int i = 0; i <= degree; ++i)
          for (int column = 0; column < split_columns(M::info.form, dimension); ++column) {
            const auto& half = left ? halves.left : halves.right;
            float value = 0;
            if constexpr (M::info.form == Form::rational)
              value = column == dimension ? half.weights[i] : half.points(column, i);
            else
              value = half(column, i);
            const auto [error, bound] = truth.judge(M::bound, split_float, left, i, column, value);
            if (!std::isfinite(bound)) continue;
            ++judged;
            ASSERT_LE(error, bound * (1 + 0x1p-20)) << M::info.id << " degree " << degree << " t " << t;
          }
    }
}

template <class... Ms>
void judge_all_in_float(TypeList<Ms...> /*roster*/) {
  Inputs inputs(4);
  int judged = 0;
  (judge_in_float<Ms>(inputs, judged), ...);
  EXPECT_GT(judged, 1000 * static_cast<int>(sizeof...(Ms)));
}

TEST(SplitBound, HoldsInFloat) { judge_all_in_float(SplitMethods{}); }

/// The control points of a half as a curve.
struct Half {
  Half(Form its_form, const std::vector<double>& numbers) : form(its_form) {
    const std::size_t columns = form == Form::rational ? 2 : 1;
    for (std::size_t k = 0; k < numbers.size(); k += columns) {
      c.push_back(numbers[k]);
      if (form == Form::rational) w.push_back(numbers[k + 1]);
    }
  }
  [[nodiscard]] CurveView<double> curve() const { return {form, 1, static_cast<int>(c.size()) - 1, c, w}; }

  Form form;
  std::vector<double> c;
  std::vector<double> w;
};

/// The bound of the junction, with the amplifications of `whole` at t. Coordinates of `whole` are at most 1 and weights
/// at most 2.
double bound_at(const SplitBound& bound, const CurveView<double>& whole, double t) {
  reference::ExactCurve exact;
  const auto value = [&](const reference::ExactPoint& point) {
    return reference::round_to(reference::binary64, point.coordinate(0));
  };
  const double p_tilde = value(exact.p_tilde(whole, t));
  if (whole.form != Form::rational) return split_bound(bound, {whole.degree, p_tilde, 1}, split_double);
  const double weight = value(exact.point({Form::bernstein, 1, whole.degree, whole.weights}, t));
  return split_quotient_bound(bound, {whole.degree, p_tilde, 2}, {whole.degree, weight, 2}, split_double);
}

/// The error of a point of a computed half is within the bound of the junction. For s in [0,1] the errors of the
/// control points, each at most factor u p~_i, sum to at most factor u sum p~_i B_i(s), where the sum is p~ of the
/// whole curve at that parameter. For a rational curve the same holds for numerator and denominator; the rounding of
/// each control point is then one of the numerator, not of the quotient.
TEST(SplitBound, CarriesOverToThePointsOfAHalf) {
  Inputs inputs(5);
  reference::ExactCurve exact;
  reference::ExactCurve exact_half;
  int judged = 0;
  for (const Form form : {Form::bernstein, Form::rational})
    for (const int degree : {1, 2, 3, 8, 20, 40})
      for (int repeat = 0; repeat < 8; ++repeat) {
        const auto c = inputs.coefficients(degree, 1);
        const auto w = form == Form::rational ? weights(degree, 0, inputs) : std::vector<double>();
        const CurveView<double> whole{form, 1, degree, c, w};
        const double t = (1 + std::floor(inputs.unit() * 1022)) * 0x1p-10;
        const double s = std::floor(inputs.unit() * 1025) * 0x1p-10;
        for (const auto& kernel : split_kernels(1)) {
          if (kernel.info->form != form) continue;
          const auto halves = split(kernel, whole, t);
          for (const bool left : {true, false}) {
            const double there = left ? s * t : t + s * (1 - t);  // exact: multiples of 2^-20
            const Half half(form, left ? halves.left : halves.right);
            const double error = reference::distance(exact_half.point(half.curve(), s), exact.point(whole, there));
            EXPECT_LE(error, bound_at(*kernel.bound, whole, there) * (1 + 0x1p-20)) << kernel.info->id << " " << degree;
            ++judged;
          }
        }
      }
  EXPECT_EQ(judged, 2 * 6 * 8 * 5 * 2);
}

}  // namespace
}  // namespace bezierbench
