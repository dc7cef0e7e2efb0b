// SPDX-License-Identifier: MIT
// True lengths along one curve, both ways: from a parameter to the length up to it, and back, to at least 30 digits of
// the whole length.
//
// The curve is integrated once, panel by panel (length_panels.hpp). A length up to t is the sum of the panels before t
// and one quadrature over the rest; a parameter is found in its panel by Newton's method in a bracket.
#pragma once

#include <string>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/length/length_panels.hpp"

namespace bezierbench::reference {

class LengthAlong {
 public:
  /// Of `curve` (Bernstein form, finite, dimension at most 3). Throws NotCertain should the length of the curve not be
  /// certain to 30 digits.
  explicit LengthAlong(const CurveView<double>& curve);

  /// 0 where all control points are equal.
  [[nodiscard]] const LongReal& whole() const { return cumulative_.back(); }

  /// s(t), the length from the beginning to t; t beyond an end counts as this end.
  [[nodiscard]] LongReal length_to(const LongReal& t) const;

  /// |s(t) - length|; 0 where it is within what is uncertain of the whole length.
  [[nodiscard]] LongReal distance(const LongReal& t, const LongReal& length) const;

  /// The t in [0, 1] with s(t) = length; beyond an end that of the end. 0 where the whole length is 0.
  [[nodiscard]] LongReal parameter_at(const LongReal& length) const;

 private:
  std::vector<LengthPanel> panels_;
  LongReal uncertainty_ = 0;
  std::vector<LongReal> cumulative_{0};  ///< length before each panel, and that of all
};

}  // namespace bezierbench::reference
