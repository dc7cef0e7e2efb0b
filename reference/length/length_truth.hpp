// SPDX-License-Identifier: MIT
// The errors of lengths and of parameters at lengths, decided in pairs of doubles where their uncertainty allows it,
// and in 70 digits where it does not. Both give the same bits.
//
// A length in pairs comes with a proved uncertainty (length_panels.hpp), some 1e-27 of it. The one in 70 digits lies
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

#include <optional>

#include "core/curve_view.hpp"
#include "reference/length/length_along.hpp"
#include "reference/length/true_length.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::reference {

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
