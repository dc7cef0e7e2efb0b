// SPDX-License-Identifier: MIT
// True lengths along one curve, both ways: from a parameter to the length up to it, and back. In 70 digits they are
// right to at least 30 digits of the whole length, in pairs to `uncertainty`.
//
// The curve is integrated once, panel by panel (length_panels.hpp). A length up to t is the sum of the panels before t
// and one quadrature over the rest; a parameter is found in its panel by Newton's method in a bracket.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/length/length_panels.hpp"

namespace bezierbench::reference {

template <class Real>
class LengthAlong {
 public:
  /// Of `curve` (Bernstein form or rational without a pole, finite, dimension at most 3). In 70 digits it throws
  /// NotCertain should the length of the curve not be certain to 30 digits.
  explicit LengthAlong(const CurveView<double>& curve);

  /// 0 where all control points are equal.
  [[nodiscard]] const Real& whole() const { return cumulative_.back(); }

  /// Lengths are right to this.
  [[nodiscard]] const Real& uncertainty() const { return uncertainty_; }

  /// s(t), the length from the beginning to t, negative for t < 0. Beyond its ends the curve is continued.
  [[nodiscard]] Real length_to(const Real& t) const;

  /// |s(t) - length|; 0 where it is within what is uncertain of the whole length.
  [[nodiscard]] Real distance(const Real& t, const Real& length) const;

  /// The t in [0, 1] with s(t) = length; beyond an end that of the end. 0 where the whole length is 0.
  [[nodiscard]] Real parameter_at(const Real& length) const;

  /// The same; empty where lengths within the uncertainty of `length` have parameters that round to different doubles.
  [[nodiscard]] std::optional<Real> known_parameter_at(const Real& length) const;

  /// The speed |p'| at t in [0, 1].
  [[nodiscard]] Real speed_at(const Real& t) const;

 private:
  struct Excess {
    Real length = 0;
    Real uncertainty = 0;
  };
  /// The length between t outside [0, 1] and the nearer end, of the curve continued; 0 for t in [0, 1].
  [[nodiscard]] Excess excess(const Real& t) const;
  [[nodiscard]] std::size_t panel_at(const Real& t) const;

  Hodograph<Real> hodograph_;
  std::vector<LengthPanel<Real>> panels_;
  Real uncertainty_ = 0;
  std::vector<Real> cumulative_{0};  ///< length before each panel, and that of all
};

}  // namespace bezierbench::reference
