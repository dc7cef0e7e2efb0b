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
#include "reference/length_panels.hpp"

namespace bezierbench::reference {

class LengthAlong {
 public:
  /// Measures `curve` (Bernstein form, finite, dimension at most 3). Throws std::runtime_error if 30 digits of its
  /// length are not certain.
  explicit LengthAlong(const CurveView<double>& curve);

  /// 0 where all control points are equal.
  [[nodiscard]] const LongReal& whole() const { return cumulative_.back(); }

  /// s(t), the length from the beginning to t; t beyond an end counts as this end.
  [[nodiscard]] LongReal length_to(const LongReal& t) const;

  /// The t in [0, 1] with s(t) = length; a length beyond an end gives this end. 0 where the whole length is 0.
  [[nodiscard]] LongReal parameter_at(const LongReal& length) const;

 private:
  std::vector<LengthPanel> panels_;
  std::vector<LongReal> cumulative_{0};  ///< length before each panel, and the whole length
};

}  // namespace bezierbench::reference
