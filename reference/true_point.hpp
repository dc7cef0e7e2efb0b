// SPDX-License-Identifier: MIT
// The true point of one trial, computed on demand: from a certificate where that proves the result, else from big
// integers. Both give the same bits.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/curve_view.hpp"
#include "reference/certified_points.hpp"
#include "reference/exact_curve.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// How the truth is computed. No result depends on it.
enum class Tier {
  exact,     ///< big integers, always
  certified  ///< double-double with a proved error, integers where that is not enough
};

constexpr std::string_view name(Tier tier) { return tier == Tier::exact ? "exact" : "certified"; }

class TruePoint {
 public:
  /// `exact` computes the integers. `exact` and the coefficients of `curve` must outlive this object.
  TruePoint(ExactCurve& exact, const CurveView<double>& curve, double t, std::optional<CertifiedPoint> certified)
      : exact_(&exact), curve_(curve), t_(t), certified_(certified) {}

  /// False where the weights of a rational curve sum to zero; then no member below may be called.
  [[nodiscard]] bool exists();

  /// The distance of a point, as Distance::to.
  [[nodiscard]] double distance(std::span<const double> point);

  /// |point|, rounded to 24 bits.
  [[nodiscard]] double length();

  /// The spacing of doubles at that length, as ulp_of_length.
  [[nodiscard]] double ulp(double length, const Format& format);

  /// The number of the format, binary32 or binary64, that is nearest to coordinate `axis`, ties to even.
  [[nodiscard]] double nearest(int axis, const Format& format);

  /// The point as integers.
  [[nodiscard]] const ExactPoint& exact();

  /// True where there is no certificate, or the integers had to decide.
  [[nodiscard]] bool needed_integers() const { return !certified_ || escalated_; }

 private:
  const Distance& exact_distance();

  ExactCurve* exact_;
  CurveView<double> curve_;
  double t_;
  std::optional<CertifiedPoint> certified_;
  const ExactPoint* point_ = nullptr;
  std::optional<Distance> distance_;
  bool escalated_ = false;
};

// A cheap tier: the same sums in long double. No result depends on it; every accuracy study audits its error against
// the exact point. The audit also shows on which platforms long double is the same as double.

/// The point in long double, on each axis.
using LongDoublePoint = std::array<long double, max_dimension>;

/// Horner's nested sum in the form of `curve`, all in long double.
LongDoublePoint long_double_point(const CurveView<double>& curve, double t);

/// |value - true| in units of the ulp of double at the true coordinate, the largest over the axes, rounded once.
double audit_ulp(const LongDoublePoint& value, const ExactPoint& exact);

}  // namespace bezierbench::reference
