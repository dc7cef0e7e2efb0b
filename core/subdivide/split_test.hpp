// SPDX-License-Identifier: MIT
// What the tests of methods for subdivision share: results of methods, the true control points, and their bounds.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "core/subdivide/kernel.hpp"
#include "reference/companion/exact_split.hpp"

namespace bezierbench {

inline constexpr SplitArithmetic split_double{0x1p-53, 0x1p-1074};
inline constexpr SplitArithmetic split_float{0x1p-24, 0x1p-149};

/// The control points of both halves, point by point.
struct SplitNumbers {
  std::vector<double> left;
  std::vector<double> right;
  bool operator==(const SplitNumbers&) const = default;
};

inline SplitNumbers split(const SplitKernel& kernel, const CurveView<double>& curve, double t) {
  const auto size = static_cast<std::size_t>((curve.degree + 1) * split_columns(curve.form, curve.dimension));
  SplitNumbers halves{std::vector<double>(size), std::vector<double>(size)};
  kernel.split(curve, t, halves.left.data(), halves.right.data());
  return halves;
}

/// The control points of a curve in the layout of the halves.
inline std::vector<double> numbers(const CurveView<double>& curve) {
  std::vector<double> all;
  for (int i = 0; i <= curve.degree; ++i) {
    for (int axis = 0; axis < curve.dimension; ++axis) all.push_back(curve(axis, i));
    if (curve.form == Form::rational) all.push_back(curve.weights[static_cast<std::size_t>(i)]);
  }
  return all;
}

/// Control point `i` of such numbers.
inline std::vector<double> point(const std::vector<double>& numbers, int columns, int i) {
  const auto from = numbers.begin() + i * columns;
  return {from, from + columns};
}

/// Such control points in the opposite order.
inline std::vector<double> backwards(const std::vector<double>& numbers, int columns) {
  std::vector<double> result;
  for (auto from = static_cast<int>(numbers.size()) - columns; from >= 0; from -= columns)
    for (int k = 0; k < columns; ++k) result.push_back(numbers[static_cast<std::size_t>(from + k)]);
  return result;
}

/// A curve that owns its weights and can be reversed; the weights of `view` cannot.
struct Drawn {
  Drawn(Form its_form, int degree, Inputs& inputs) : Drawn(its_form, inputs.coefficients(degree, 1), {}) {
    if (form == Form::rational)
      for (int i = 0; i <= degree; ++i) w.push_back(0.75 + 0.5 * inputs.unit());
  }
  Drawn(Form its_form, std::vector<double> coordinates, std::vector<double> weights)
      : form(its_form), c(std::move(coordinates)), w(std::move(weights)) {}
  [[nodiscard]] CurveView<double> curve() const { return {form, 1, static_cast<int>(c.size()) - 1, c, w}; }
  [[nodiscard]] Drawn reversed() const { return {form, backwards(c, 1), backwards(w, 1)}; }

  Form form;
  std::vector<double> c;
  std::vector<double> w;
};

/// The halves of a curve as those of the reversed curve.
inline SplitNumbers reversed(const SplitNumbers& halves, int columns) {
  return {backwards(halves.right, columns), backwards(halves.left, columns)};
}

/// Whether the numbers have the same bits; 0 and -0 differ.
inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

/// The true halves of one curve, and the bounds of the errors of methods.
class SplitTruth {
 public:
  SplitTruth(const CurveView<double>& curve, double t)
      : curve_(curve), exact_(reference::exact_split(curve, t)), p_tilde_(reference::split_p_tilde(curve, t)) {}

  /// The error and the bound of number `column` of a control point.
  struct Judged {
    double error;
    double bound;
  };
  [[nodiscard]] Judged judge(const SplitBound& bound, const SplitArithmetic& arithmetic, bool left, int i, int column,
                             double value) const {
    const auto& exact = left ? exact_.left : exact_.right;
    const auto& p_tilde = left ? p_tilde_.left : p_tilde_.right;
    const auto k = static_cast<std::size_t>(i);
    const bool of_weight = column == curve_.dimension;
    const auto& truth = of_weight ? exact.weights[k] : exact.points[k].coordinate(column);
    const double error = reference::error_of(value, truth, reference::binary64);
    const int levels = left ? i : curve_.degree - i;
    const auto scale = [&](const reference::Rational& amplified, double largest) {
      return SplitScale{levels, reference::round_to(reference::binary64, amplified), largest};
    };
    const SplitScale weight = curve_.form == Form::rational ? scale(p_tilde.weights[k], largest_of(left, i, -1, true))
                                                            : SplitScale{levels, 1, 1};
    if (of_weight) return {error, split_bound(bound, weight, arithmetic)};
    const auto amplified = p_tilde.points[k].coordinate(column);
    if (curve_.form != Form::rational)
      return {error, split_bound(bound, scale(amplified, largest_of(left, i, column, false)), arithmetic)};
    return {error,
            split_quotient_bound(bound, scale(amplified, largest_of(left, i, column, true)), weight, arithmetic)};
  }

 private:
  /// max |b_j| or, if weighted, max |w_j b_j| over the control points that determine point i of a half; for column -1
  /// max |w_j|.
  [[nodiscard]] double largest_of(bool left, int i, int column, bool weighted) const {
    double largest = 0;
    for (int j = left ? 0 : i; j <= (left ? i : curve_.degree); ++j) {
      const double size = column < 0 ? 1 : std::abs(curve_(column, j));
      largest = std::max(largest, weighted ? size * std::abs(curve_.weights[static_cast<std::size_t>(j)]) : size);
    }
    return largest;
  }

  CurveView<double> curve_;
  reference::ExactHalves exact_;
  reference::ExactHalves p_tilde_;
};

/// Parameters to test methods at: both ends, next to them, and near 1/2, where two_sided_split changes sides.
inline const std::vector<double> split_parameters{0,   1,   0x1p-53, 1 - 0x1p-53, 0.5, 0.5 - 0x1p-54, 0.5 + 0x1p-53,
                                                  0.3, 0.9, 0x1p-30, 0x1p-1074};

}  // namespace bezierbench
