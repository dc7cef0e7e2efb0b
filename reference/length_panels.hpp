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

  /// Halves or cuts: the part on [0, t] stays here, that on [t, 1] is returned.
  LongHodograph split(const LongReal& t);

  [[nodiscard]] LongReal speed(const LongReal& t) const;

  /// Mean size of the vectors, and the size of their mean: polygon and chord, for a parameter of width 1.
  [[nodiscard]] LongReal polygon() const;
  [[nodiscard]] LongReal chord() const;

  /// True where no vector points away from their mean: then the speed is nowhere 0 inside, and the curve does not turn.
  [[nodiscard]] bool points_forward() const;

  /// The integral of the speed over [0, 1] by the Gauss-Legendre rule with 44 points.
  [[nodiscard]] LongReal fine_sum() const;
};

/// Of `curve` (Bernstein form, finite, dimension at most 3), over the parameters 0 <= from <= to <= 1: differences of
/// the control points, exact but for 70 digits.
LongHodograph long_hodograph(const CurveView<double>& curve, double from, double to);

/// A part of a hodograph that the rule with 44 points integrates to the precision that was asked for.
struct LengthPanel {
  LongReal begin;  ///< both for the hodograph over [0, 1]
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
  /// How far the two rules are apart, or polygon and chord: the length is right to about this.
  [[nodiscard]] const LongReal& uncertainty() const { return uncertainty_; }

 private:
  void add(LongHodograph h, const LongReal& begin, const LongReal& width, int depth);

  LongReal negligible_;
  std::vector<LengthPanel> panels_;
  LongReal length_ = 0;
  LongReal uncertainty_ = 0;
};

}  // namespace bezierbench::reference
