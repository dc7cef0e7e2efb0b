// SPDX-License-Identifier: MIT
// The floating-point operations of a method by kind, and the longest chain of them, found by running the method's own
// code over a scalar that counts. Nothing else states these numbers.
//
// Sums and differences are one kind. Changes of sign, comparisons and choices count as none, and so does what depends
// on the degree only (binomials, nodes, weights): a table could hold it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/method.hpp"

namespace bezierbench {

enum class Operation : std::size_t { add, multiply, fused, divide, square_root };
inline constexpr std::size_t operation_kinds = 5;

/// A number for each kind of operation: how many of them, or what one of them takes.
struct ByOperation {
  std::array<double, operation_kinds> values{};

  [[nodiscard]] constexpr double operator[](Operation kind) const { return values[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] constexpr double& operator[](Operation kind) { return values[static_cast<std::size_t>(kind)]; }
  constexpr ByOperation& operator+=(const ByOperation& other) {
    for (std::size_t kind = 0; kind < operation_kinds; ++kind) values[kind] += other.values[kind];
    return *this;
  }
  /// All of them, a fused multiply-add being one.
  [[nodiscard]] constexpr double flops() const {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
  }
};

/// How the work lies in vectors.
enum class Layout {
  axes,   ///< the axes of one point side by side: an operation on all of them is one
  points  ///< each axis by itself, as where the lanes are other points
};

/// The numbers of a point that go side by side in Layout::axes: its coordinates, and the weight of a method on
/// homogeneous coordinates.
int side_by_side(const MethodInfo& evaluator, int dimension);

/// The operations of `evaluate` for one point. Empty where libm does the work, and for evaluators that are not in the
/// roster. Dimension is at least 1.
std::optional<ByOperation> point_operations(const MethodInfo& evaluator, int degree, int dimension, Layout layout);

/// The operations of `prepare` for one curve, those of the conversion before it included if there is one. Empty where
/// they are not floating-point operations alone, and for methods that are not in the roster.
std::optional<ByOperation> curve_operations(const MethodInfo& evaluator, const MethodInfo* conversion, int degree,
                                            int dimension, Layout layout);

/// What the longest chain of operations from t to a coordinate takes, each waiting for the one before. Empty as
/// point_operations().
std::optional<double> point_chain(const MethodInfo& evaluator, int degree, const ByOperation& latency);

}  // namespace bezierbench
