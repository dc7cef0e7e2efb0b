// SPDX-License-Identifier: MIT
// The integral of the speed of a Bezier curve in 70 digits, panel by panel, for true lengths.
//
// A panel is taken where a Gauss-Legendre rule with 44 points is proved to be right (speed_series.hpp), or where the
// difference of chord and largest speed is negligible; else it is halved. At a cusp the second condition ends the
// halving, because the length of the panels next to it falls like the square of their width; its parameter need not be
// known. The uncertainties of all panels, of roundings and of terms that are left out are summed and returned.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/length/speed_series.hpp"

namespace bezierbench::reference {

/// Of `curve` (Bernstein form, finite, dimension at most 3), over the parameters 0 <= from <= to <= 1: differences of
/// the control points, exact but for 70 digits.
LongHodograph long_hodograph(const CurveView<double>& curve, double from, double to);

/// A part of the parameters, and its length.
struct LengthPanel {
  LongReal begin;  ///< begin and width are parameters of the hodograph over [0, 1]
  LongReal width;
  SpeedSeries series;
  LongReal length;
};

/// The panels of [0, 1], in order, and their length.
class LengthPanels {
 public:
  explicit LengthPanels(const LongHodograph& hodograph);

  [[nodiscard]] const std::vector<LengthPanel>& panels() const { return panels_; }
  [[nodiscard]] const LongReal& length() const { return length_; }
  /// The length is right to this.
  [[nodiscard]] const LongReal& uncertainty() const { return uncertainty_; }

 private:
  void add(SpeedSeries series, const LongReal& begin, const LongReal& width, const LongReal& cut, int depth);

  SpeedSeries::Halving halving_;
  std::vector<LengthPanel> panels_;
  LongReal negligible_ = 0;  ///< to be off, in each panel
  LongReal length_ = 0;
  LongReal uncertainty_ = 0;
  double work_ = 0;  ///< products so far
};

/// Thrown where a length is not certain to 30 digits. Its message is one line with the number of certain digits.
class NotCertain : public std::runtime_error {
 public:
  NotCertain(LongReal length, const LongReal& uncertainty);
  /// The computed length.
  [[nodiscard]] const LongReal& length() const { return length_; }

 private:
  LongReal length_;
};

/// Throws NotCertain for a length that is not known to 30 digits.
void require_certain(const LongReal& length, const LongReal& uncertainty);

}  // namespace bezierbench::reference
