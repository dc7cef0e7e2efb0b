// SPDX-License-Identifier: MIT
// The errors of lengths and of parameters at lengths, decided in pairs of doubles where their uncertainty allows it,
// and in 70 digits where it does not. Both give the same bits.
//
// A length in pairs comes with a proved uncertainty (true_length.hpp), some 1e-27 of it. The one in 70 digits lies
// within that and its own, at most 1e-30 of the length. So every requested number lies in a known interval, and
// where both its ends are rounded to the same, so is the number in 70 digits. An interval that contains 0 decides
// nothing: there the 70 digits say whether a method is exact.
//
// For a part of a curve to t inside a panel the uncertainty is eight times as large: a panel that is taken because
// chord and largest speed differ by little, e, has |a_k| that sum to at most 3/2 e for k > 0, so a rule is within 3 e
// on any part of it, where the panel counts with e/2.
//
// A curve is left to the 70 digits if its degree exceeds 24, beyond which the factors of halving have more than 53 bits
// and are rounded, or if it or its length is far from 1.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/length/true_length.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::reference {

// True lengths along one curve, both ways: from a parameter to the length up to it, and back. In 70 digits they are
// right to at least 30 digits of the whole length, in pairs to `uncertainty`.
//
// The curve is integrated once, panel by panel (true_length.hpp). A length up to t is the sum of the panels before t
// and one quadrature over the rest; a parameter is found in its panel by Newton's method in a bracket.

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

/// Contains a number that is not exactly known. Its ends are numbers in pairs, each rounded to double.
struct Enclosure {
  double low;
  double high;
};

/// The true length of a curve, or of a part. Not for use by several threads at once.
class LengthTruth {
 public:
  /// As TrueLength; the coefficients of `curve` must outlive this object. With Tier::exact the 70 digits decide all. It
  /// throws NotCertain, now or later, where they are required and not certain.
  LengthTruth(const CurveView<double>& curve, double from, double to, Tier tier);

  /// Rounded once.
  [[nodiscard]] double length() const;

  /// TrueLength::error_of, rounded by `round`, which must be monotone.
  template <class Round>
  [[nodiscard]] double error_of(double length, Round round) const {
    if (const auto error = enclosed_error(length); error && round(error->low) == round(error->high))
      return round(error->low);
    return round(exact().error_of(length));
  }

  /// True where the 70 digits were computed.
  [[nodiscard]] bool needed_digits() const { return exact_.has_value(); }

 private:
  [[nodiscard]] std::optional<Enclosure> enclosed_error(double length) const;
  [[nodiscard]] const TrueLength& exact() const;

  CurveView<double> curve_;
  double from_;
  double to_;
  bool certified_ = false;
  PairReal value_ = 0;
  PairReal off_ = 0;  ///< from the length in 70 digits
  mutable std::optional<TrueLength> exact_;
};

/// The true lengths along one curve. Not for use by several threads at once.
class AlongTruth {
 public:
  /// As LengthAlong; else as LengthTruth.
  AlongTruth(const CurveView<double>& curve, Tier tier);

  /// The length of the curve, rounded once.
  [[nodiscard]] double whole() const;

  /// share times the length of the curve, rounded once.
  [[nodiscard]] double length_at_share(double share) const;

  /// LengthAlong::distance of t and `length`, rounded by `round`, which must be monotone.
  template <class Round>
  [[nodiscard]] double error_of_length(double t, double length, Round round) const {
    if (const auto error = enclosed_error(t, length); error && round(error->low) == round(error->high))
      return round(error->low);
    return round(exact().distance(LongReal(t), LongReal(length)).template convert_to<double>());
  }

  /// |t - parameter at `length`|, rounded likewise.
  template <class Round>
  [[nodiscard]] double error_of_parameter(double t, double length, Round round) const {
    if (const auto error = enclosed_parameter_error(t, length); error && round(error->low) == round(error->high))
      return round(error->low);
    return round(LongReal(abs(LongReal(t) - exact_parameter(length))).template convert_to<double>());
  }

  /// True where the 70 digits were computed.
  [[nodiscard]] bool needed_digits() const { return exact_.has_value(); }

 private:
  /// The parameter at a length: it lies between these two.
  struct Bracket {
    double length;
    std::optional<PairReal> low;  ///< empty where none is proved
    std::optional<PairReal> high;
  };

  [[nodiscard]] std::optional<Enclosure> enclosed_error(double t, double length) const;
  [[nodiscard]] std::optional<Enclosure> enclosed_parameter_error(double t, double length) const;
  [[nodiscard]] Bracket bracket(double length) const;
  [[nodiscard]] const LengthAlong<LongReal>& exact() const;
  [[nodiscard]] const LongReal& exact_parameter(double length) const;

  CurveView<double> curve_;
  std::optional<LengthAlong<PairReal>> pairs_;  ///< empty where they decide nothing
  PairReal off_ = 0;                            ///< of a length up to any t, from that in 70 digits
  mutable std::optional<LengthAlong<LongReal>> exact_;
  mutable std::optional<Bracket> bracket_;  ///< of the last length
  mutable std::optional<std::pair<double, LongReal>> exact_parameter_;
};

}  // namespace bezierbench::reference
