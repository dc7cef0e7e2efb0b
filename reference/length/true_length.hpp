// SPDX-License-Identifier: MIT
// The true arc length of a Bezier curve, to at least 30 digits.
//
// length_panels.hpp says how it is integrated and what is proved.
#pragma once

#include <string>

#include "core/curve_view.hpp"
#include "reference/length/length_panels.hpp"

namespace bezierbench::reference {

class TrueLength {
 public:
  /// Of the part of `curve` (Bernstein form or rational without a pole in it, finite, dimension at most 3) between
  /// parameters 0 <= from <= to <= 1.
  /// Throws NotCertain should its length not be certain to 30 digits: every whole curve to degree 64 has one that is.
  TrueLength(const CurveView<double>& curve, double from, double to);

  [[nodiscard]] const LongReal& value() const { return value_; }
  /// The value is right to this.
  [[nodiscard]] const LongReal& uncertainty() const { return uncertainty_; }

  /// The length in decimal with this many significant digits.
  [[nodiscard]] std::string decimal(int digits) const;
  /// |length - value|, rounded once; 0 where it is within the uncertainty, which cannot tell these two apart; infinite
  /// for a length that is not finite.
  [[nodiscard]] double error_of(double length) const;

 private:
  LongReal value_ = 0;
  LongReal uncertainty_ = 0;
};

}  // namespace bezierbench::reference
