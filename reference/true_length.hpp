// SPDX-License-Identifier: MIT
// The true arc length of a Bezier curve, to at least 30 digits.
//
// Gauss-Legendre rules of 30 and of 44 points integrate the speed in 70 digits, panel by panel. A panel is accepted
// where both rules agree and no control vector of the hodograph points backwards. It is also accepted where its control
// polygon, never shorter than the arc, exceeds its chord, never longer, by next to nothing. Else it is halved. At a
// cusp, whose parameter need not be known, the second condition ends the halving: the length of the panels next to it
// falls like the square of their width. The uncertainties of all panels are summed and stated.
#pragma once

#include <string>

#include "core/curve_view.hpp"
#include "reference/length_panels.hpp"

namespace bezierbench::reference {

class TrueLength {
 public:
  /// Measures the part of `curve` (Bernstein form, finite, dimension at most 3) between parameters
  /// 0 <= from <= to <= 1. Throws std::runtime_error if the two rules do not agree to 30 digits.
  TrueLength(const CurveView<double>& curve, double from, double to);

  [[nodiscard]] const LongReal& value() const { return value_; }
  /// The difference of the two rules, or of polygon and chord: about the error of the value.
  [[nodiscard]] const LongReal& uncertainty() const { return uncertainty_; }

  /// The length in decimal with this many significant digits.
  [[nodiscard]] std::string decimal(int digits) const;
  /// |length - value|, rounded once; infinite for a length that is not finite.
  [[nodiscard]] double error_of(double length) const;

 private:
  LongReal value_ = 0;
  LongReal uncertainty_ = 0;
};

}  // namespace bezierbench::reference
