// SPDX-License-Identifier: MIT
// The speed of a Bezier curve in 70 digits, and its integral panel by panel. True lengths are computed from both.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::reference {

using LongReal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>>;

/// Control vectors of a hodograph, point by point.
struct LongHodograph {
  std::size_t dimension;
  std::vector<LongReal> vectors;

  [[nodiscard]] std::size_t degree() const { return vectors.size() / dimension - 1; }

  /// Cuts the hodograph at t: this keeps the part on [0, t], the part on [t, 1] is returned.
  LongHodograph split(const LongReal& t);

  [[nodiscard]] LongReal speed(const LongReal& t) const;

  /// The mean size of the vectors and the size of their mean: the lengths of polygon and chord for width 1 of t.
  [[nodiscard]] LongReal polygon() const;
  [[nodiscard]] LongReal chord() const;

  /// True where no vector points away from their mean: then the speed is nowhere 0 inside, and the curve does not turn.
  [[nodiscard]] bool points_forward() const;

  /// The integral of the speed over [0, 1] by the Gauss-Legendre rule with 44 points.
  [[nodiscard]] LongReal fine_sum() const;
};

/// The hodograph of `curve` (Bernstein form, finite, dimension at most 3) over the parameters 0 <= from <= to <= 1,
/// from differences of the control points in 70 digits.
LongHodograph long_hodograph(const CurveView<double>& curve, double from, double to);

/// A part of a hodograph that the rule with 44 points integrates to the wanted precision.
struct LengthPanel {
  LongReal begin;  ///< begin and width are parameters of the hodograph over [0, 1]
  LongReal width;
  LongHodograph hodograph;
  LongReal length;
};

/// The panels of [0, 1], in order, and the sum of their lengths.
class LengthPanels {
 public:
  explicit LengthPanels(const LongHodograph& hodograph);

  [[nodiscard]] const std::vector<LengthPanel>& panels() const { return panels_; }
  [[nodiscard]] const LongReal& length() const { return length_; }
  /// The difference of the two rules, or of polygon and chord: about the error of the length.
  [[nodiscard]] const LongReal& uncertainty() const { return uncertainty_; }

 private:
  void add(LongHodograph h, const LongReal& begin, const LongReal& width, int depth);

  LongReal negligible_;
  std::vector<LengthPanel> panels_;
  LongReal length_ = 0;
  LongReal uncertainty_ = 0;
};

}  // namespace bezierbench::reference
