// SPDX-License-Identifier: MIT
// The scales of one trial's error: p~ and the proved bound, with the Euclidean norm of each coefficient.
//
// A bound that holds on each axis holds for the Euclidean norm: by the triangle inequality the norm of the
// amplifications is at most the amplification of the norms, and d axes add at most d underflow terms.
//
// Of a rational curve the coefficients are w_i b_i, and every amplification is divided by |sum w_i B_i(t)|.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/exact_curve.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

/// Rounding properties of the scalar type that the methods compute in.
struct Arithmetic {
  double unit_roundoff;       ///< u = 2^-53, or 2^-24 for float
  double smallest_subnormal;  ///< 2^-1074, or 2^-149
  double range;               ///< a power of two; it and its reciprocal are far from overflow and underflow
};
inline constexpr Arithmetic double_arithmetic{0x1p-53, 0x1p-1074, 0x1p+1000};
inline constexpr Arithmetic float_arithmetic{0x1p-24, 0x1p-149, 0x1p+120};

/// A bound at one degree: the factors that do not depend on the trial.
struct BoundAtDegree {
  BoundAtDegree(const ErrorBound& error_bound, int degree, const Arithmetic& arithmetic)
      : bound(error_bound),
        factor(error_bound.factor(degree, arithmetic.unit_roundoff)),
        underflow(std::ceil(error_bound.underflow(degree))),
        growth(error_bound.growth(degree)) {}

  ErrorBound bound;
  double factor;
  double underflow;  ///< an integer: no fraction of the smallest subnormal is a double
  double growth;
};

/// One error compared with its proved bound.
struct BoundCheck {
  double bound;    ///< finite
  double bound_u;  ///< over u p~; infinite where p~ is 0
  bool violated;   ///< the error is certainly beyond the bound
};

/// error / divisor / unit; 0 for error 0, whatever the divisor. An error over a divisor of 0 is infinite.
inline double in_units(double error, double divisor, double unit = 1) {
  const double quotient = error / divisor / unit;
  return error == 0 ? 0 : quotient;
}

/// The amplifications of a trial that are known.
using Amplifications = std::array<std::optional<double>, amplification_count>;

/// Scales of one (curve, t); amplifications are computed on first use. Reusable.
class TrialScale {
 public:
  /// Sets the trial. Must be called before any other member. The curve, if not rational, must live until the next call.
  void set(const CurveView<double>& curve, double t);
  /// The same with the largest norm of a coefficient and some amplifications that are known, as those of a group of
  /// trials are. The curve, not rational, must live until the next call.
  void set(const CurveView<double>& curve, double t, double largest, const Amplifications& amplified);

  /// p~ of the curve in its own form; infinite where the weights sum to zero.
  double p_tilde();

  /// error / (u p~); where p~ is 0: 0 for error 0, else infinite.
  double in_bound_units(double error, const Arithmetic& arithmetic);

  /// The bound in coordinate units. `length` is |p| to 24 bits where it is known: the bound of a compensated method has
  /// a few roundings of |p|, which may be far smaller than p~.
  double bound(const BoundAtDegree& bound, const Arithmetic& arithmetic, std::optional<double> length = std::nullopt);
  double bound(const ErrorBound& bound, const Arithmetic& arithmetic, std::optional<double> length = std::nullopt) {
    return this->bound(BoundAtDegree(bound, degree(), arithmetic), arithmetic, length);
  }

  /// The least bound that the method has: this one or the other that it names.
  double least_bound(const ErrorBound& bound, const Arithmetic& arithmetic,
                     std::optional<double> length = std::nullopt) {
    const double first = this->bound(bound, arithmetic, length);
    return bound.also == nullptr ? first : std::min(first, this->bound(*bound.also, arithmetic, length));
  }

  /// Empty where nothing is proved at this input.
  std::optional<BoundCheck> check(double error, const BoundAtDegree& bound, const Arithmetic& arithmetic,
                                  std::optional<double> length);

  /// True where `error` is certainly beyond `bound`: both are known to a relative 2^-20 only.
  static bool violates(double error, double bound) { return error > bound * (1 + 0x1p-20); }

 private:
  /// Sums and extremes of the weights of a rational curve.
  struct Weights {
    double smallest = 0;
    double largest = 0;
    double sum = 0;            ///< |sum w_i B_i(t)|
    double largest_point = 0;  ///< max |b_i|
  };

  [[nodiscard]] int degree() const { return curve_.degree; }
  void begin(const CurveView<double>& curve, double t);
  void take_norms();
  /// |b_i - b_anchor|, of a curve that is not rational.
  [[nodiscard]] std::vector<double> norms_from(int anchor) const;
  void weigh(const CurveView<double>& curve);
  /// Sums in big integers, for weights of both signs and magnitudes that leave the range of double; `norms` holds |b_i|
  /// and w_i.
  void weigh_exactly(const CurveView<double>& norms);
  double amplified(Amplification kind);
  /// That of a method whose bound is the same for all curves.
  double bound_of_kind(const BoundAtDegree& bound, const Arithmetic& arithmetic, std::optional<double> length);
  double reach();
  /// False where a result on the way to the point may overflow.
  [[nodiscard]] bool stays_in_range(const BoundAtDegree& bound, const Arithmetic& arithmetic);
  /// The underflow term; `rounding` is the bound without it.
  [[nodiscard]] double polynomial_underflow(const BoundAtDegree& bound, const Arithmetic& arithmetic, double rounding);
  [[nodiscard]] double rational_underflow(const BoundAtDegree& bound, const Arithmetic& arithmetic);

  CurveView<double> curve_;
  Form form_ = Form::bernstein;
  double t_ = 0;
  int dimension_ = 0;
  double largest_ = 0;
  std::vector<double> norms_;  ///< |b_i|, or |w_i b_i|; empty until they are first used
  Weights weights_;
  ExactCurve exact_;
  Amplifications amplified_;
  std::optional<double> reach_;  ///< (|t| + |1 - t|)^n
};

// The error of one computed coordinate, and the bound of a method for it.

/// Errors are infinite where the value is not finite.
struct CoordinateError {
  double exact = 0;      ///< the true value, rounded once
  double error = 0;      ///< |value - true value|, rounded once
  double error_ulp = 0;  ///< over the spacing of doubles at the true value
  double error_u = 0;    ///< over u p~; where p~ is 0: 0 for error 0, else infinite
};

/// Judges `value`; `p_tilde` is that of its axis.
CoordinateError coordinate_error(double value, const Rational& truth, const Rational& p_tilde);

/// The bound of a method for coordinate `axis` of the point at t, in coordinate units; infinite where nothing is
/// proved. `truth` is the true coordinate.
double coordinate_bound(const ErrorBound& bound, const CurveView<double>& curve, int axis, double t,
                        const Rational& truth, const Arithmetic& arithmetic = double_arithmetic);

/// bound / (u p~), rounded once; empty where the bound is infinite or p~ is 0.
std::optional<double> bound_units(double bound, const Rational& p_tilde,
                                  const Arithmetic& arithmetic = double_arithmetic);

}  // namespace bezierbench::reference
