// SPDX-License-Identifier: MIT
// The true arc length of a Bezier curve, to at least 30 digits.
//
// The text above Hodograph says how it is integrated and what is proved.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/length/speed_series.hpp"

namespace bezierbench::reference {

// The integral of the speed of a Bezier curve, panel by panel, for true lengths: in 70 digits, or in pairs of doubles.
//
// A panel is taken where a Gauss-Legendre rule is proved to be right (speed_series.hpp), or where the
// difference of chord and largest speed is negligible; else it is halved. At a cusp the second condition ends the
// halving, because the length of the panels next to it falls like the square of their width; its parameter need not be
// known. The uncertainties of all panels, of roundings and of terms that are left out are summed and returned.

/// Of `curve` (Bernstein or rational form, finite, dimension at most 3), over the parameters 0 <= from <= to <= 1:
/// differences of the control points, exact except for roundings. Of a rational curve U = A'W - AW' and W, whose
/// control points are
///   U_k = sum_(i<j, i+j=k+1) (j - i) C(n,i) C(n,j) / C(2n-2,k) w_i w_j (b_j - b_i).
template <class Real>
Hodograph<Real> hodograph(const CurveView<double>& curve, double from, double to);

/// A part of the parameters, and its length.
template <class Real>
struct LengthPanel {
  Real begin;  ///< begin and width are parameters of the hodograph over [0, 1]
  Real width;
  SpeedSeries<Real> series;
  Real length;
};

/// The panels of [0, 1], in order, and their length.
template <class Real>
class LengthPanels {
 public:
  explicit LengthPanels(const Hodograph<Real>& hodograph);

  [[nodiscard]] const std::vector<LengthPanel<Real>>& panels() const { return panels_; }
  [[nodiscard]] const Real& length() const { return length_; }
  /// The length is right to this.
  [[nodiscard]] const Real& uncertainty() const { return uncertainty_; }

 private:
  using Off = typename SpeedSeries<Real>::Off;
  void add(SpeedSeries<Real> series, const Real& begin, const Real& width, const Off& off, int depth);

  typename SpeedSeries<Real>::Halving halving_;
  std::vector<LengthPanel<Real>> panels_;
  Real negligible_ = 0;  ///< to be off, in each panel
  Real length_ = 0;
  Real uncertainty_ = 0;
  double work_ = 0;  ///< products so far
};

/// Thrown where a length is not certain to 30 digits. Its message is one line with the number of certain digits.
class NotCertain : public std::runtime_error {
 public:
  NotCertain(LongReal length, const LongReal& uncertainty);
  /// The computed length.
  [[nodiscard]] const LongReal& length() const { return length_; }
  /// Whether any digit of it is certain.
  [[nodiscard]] bool has_digits() const { return has_digits_; }

 private:
  LongReal length_;
  bool has_digits_;
};

/// Throws NotCertain for a length that is not known to 30 digits.
void require_certain(const LongReal& length, const LongReal& uncertainty);

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
