// SPDX-License-Identifier: MIT
// Formula: the speed of the rational curve C = A / W, A = sum w_i b_i B_i, is |U| / W^2 with U = A' W - A W', of degree
//   2n - 2: B_i B_j' - B_i' B_j = (j - i) C(n,i) C(n,j) t^(i+j-1) (1-t)^(2n-i-j-1), so that
//     U_k = sum_(i<j, i+j=k+1) (j - i) C(n,i) C(n,j) / C(2n-2,k) w_i w_j (b_j - b_i).
//   Only differences of control points occur: it does not matter where the curve is.
// Source: derived here, from the quotient rule ([Piegl and Tiller 1997], eq. (4.8)).
// Cost: n^2 (2d + 4) / 2 flops once; a speed costs that of a polynomial curve of degree 2n - 1 and n(4) + 2 more.
// Bound: with U~ and W~, the sums above of the magnitudes of their terms, computed values are off by at most gamma U~
//   and gamma W~, and the length by at most gamma times the integral of U~/W^2 + 2 U~ W~ / |W|^3 and terms of gamma^2.
//   `sensitivity` encloses that integral from above, part by part.
// Fails: where W has a root in the interval the length is infinite. Where W is that small by cancellation, no bound
//   of the roundings is found, and `sensitivity` is infinite.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/arc_length/adaptive_simpson38.hpp"
#include "core/arc_length/chebyshev_series.hpp"
#include "core/arc_length/gauss_legendre_adaptive.hpp"
#include "core/arc_length/part.hpp"
#include "core/arc_length/scale.hpp"
#include "core/arc_length/speed.hpp"
#include "core/arc_length/squared_speeds.hpp"
#include "core/binomial.hpp"

namespace bezierbench {

/// The largest degree n of a curve for which 2n - 2 is one.
inline constexpr int rational_degree_limit = max_degree / 2 + 1;

/// U and W over a part of the parameters.
template <int Dimension>
struct RationalPanel {
  explicit RationalPanel(int degree) : h(std::max(2 * degree - 2, 0)), w(degree) {}

  [[nodiscard]] int degree() const { return h.degree(); }

  Curve<Form::bernstein, double, Dimension> h;  ///< U
  Curve<Form::bernstein, double, 1> w;          ///< W
  double sensitivity = 0;                       ///< of the length of a whole part
};

/// The same with U~ and W~, which roundings are measured by.
template <int Dimension>
struct RationalHodograph : RationalPanel<Dimension> {
  explicit RationalHodograph(int degree) : RationalPanel<Dimension>(degree), sizes(degree) {}

  RationalPanel<1> sizes;
};

/// The range of |W| over the panel by its control points; `least` is 0 where they have two signs.
struct WeightRange {
  double least;
  double largest;
};

inline WeightRange weight_range(const Curve<Form::bernstein, double, 1>& w) {
  double low = w(0, 0);
  double high = low;
  for (int i = 1; i <= w.degree(); ++i) {
    low = std::min(low, w(0, i));
    high = std::max(high, w(0, i));
  }
  return {std::max({low, -high, 0.0}), std::max(-low, high)};
}

/// Bounds of the mean speed from below and from above, as of polynomial curves.
template <int Dimension>
double chord_length(const RationalPanel<Dimension>& panel) {
  const double largest = weight_range(panel.w).largest;
  return chord_length(panel.h) / (largest * largest);
}
template <int Dimension>
double polygon_length(const RationalPanel<Dimension>& panel) {
  const double least = weight_range(panel.w).least;
  return polygon_length(panel.h) / (least * least);
}

template <int Dimension>
RationalPanel<Dimension> cut_left_half(RationalPanel<Dimension>& panel) {
  RationalPanel<Dimension> left(panel.w.degree());
  left.h = cut_left_half(panel.h);
  left.w = cut_left_half(panel.w);
  return left;
}

template <int Dimension>
void restrict_to(RationalHodograph<Dimension>& r, double from, double to) {
  restrict_to(r.h, from, to);
  restrict_to(r.w, from, to);
  restrict_to(r.sizes.h, from, to);
  restrict_to(r.sizes.w, from, to);
}

/// What moves the beginning of the part: u times the speed there. The roundings of restrict_to are counted in
/// rounding_of_length.
template <int Dimension>
double rounding_of_part(const RationalHodograph<Dimension>& /*whole*/, const RationalHodograph<Dimension>& part,
                        double from, double /*to*/, int exponent = 0) {
  constexpr double u = 0x1p-53;
  if (from == 0) return 0;
  double first = 0;
  for (int axis = 0; axis < Dimension; ++axis) first += std::abs(part.h(axis, 0));
  return times_power_of_two(2 * u * first / (part.w(0, 0) * part.w(0, 0)), -exponent);
}

template <int Dimension>
bool is_zero(const RationalHodograph<Dimension>& r) {
  return is_zero(r.h);
}

/// Divides U and W by powers of two, so that the largest coordinate of each is in [1/2, 1). Returns the e with which
/// the speed |U| / W^2 is 2^e times that of the result.
template <int Dimension>
int normalise(RationalHodograph<Dimension>& r) {
  const int exponent = normalise(r.h);
  const int of_weights = normalise(r.w);
  for (int i = 0; i <= r.sizes.h.degree(); ++i) r.sizes.h(0, i) = times_power_of_two(r.sizes.h(0, i), -exponent);
  for (int i = 0; i <= r.sizes.w.degree(); ++i) r.sizes.w(0, i) = times_power_of_two(r.sizes.w(0, i), -of_weights);
  return exponent - 2 * of_weights;
}

/// U and W of a curve of a degree up to rational_degree_limit, scaled so. The weights are scaled before their products
/// are taken, and differences after they are, as for polynomial curves.
template <int Dimension>
ScaledHodograph<RationalHodograph<Dimension>> scaled_hodograph(Curve<Form::rational, double, Dimension> curve) {
  const int n = curve.degree();
  RationalHodograph<Dimension> r(n);
  for (int i = 0; i <= n; ++i) r.w(0, i) = curve.weights[i];
  normalise(r.w);
  for (int i = 0; i <= n; ++i) r.sizes.w(0, i) = std::abs(r.w(0, i));
  // Differences of the largest numbers would overflow.
  constexpr double huge = std::numeric_limits<double>::max() / 4;
  constexpr int room = 2;
  int exponent = 0;
  for (int axis = 0; axis < Dimension; ++axis)
    for (int i = 0; i <= n; ++i)
      if (std::abs(curve.points(axis, i)) > huge) exponent = room;
  double largest = 0;
  for (int axis = 0; axis < Dimension; ++axis)
    for (int i = 0; i <= n; ++i) {
      curve.points(axis, i) = times_power_of_two(curve.points(axis, i), -exponent);
      largest = std::max(largest, std::abs(curve.points(axis, i) - curve.points(axis, 0)));
    }
  const int of_differences = largest > 0 ? binary_exponent(largest) + 1 : 0;
  exponent += of_differences;
  const BinomialRow<double, dynamic> row(n);
  const BinomialRow<double, dynamic> row_of_result(r.degree());
  constexpr double underflow = 0x1p-1000;  // of a product of two weights in any term, over u
  for (int k = 0; k <= r.degree(); ++k) {
    r.sizes.h(0, k) = 0;
    for (int axis = 0; axis < Dimension; ++axis) {
      r.h(axis, k) = 0;
      for (int i = std::max(0, k + 1 - n); 2 * i < k + 1 && n > 0; ++i) {
        const int j = k + 1 - i;
        const double difference = curve.points(axis, j) - curve.points(axis, i);
        const double factor = (j - i) * (row[i] * row[j] / row_of_result[k]);
        const double term = r.w(0, i) * r.w(0, j) * times_power_of_two(difference, -of_differences) * factor;
        r.h(axis, k) += term;
        r.sizes.h(0, k) += std::abs(term) + underflow;
      }
    }
  }
  ScaledHodograph<RationalHodograph<Dimension>> result(r);
  result.exponent = exponent + normalise(result.h);
  return result;
}

/// A bound of the change of the mean speed by relative changes of all terms of U and W, divided by the largest of
/// these, which is at most 2^-38. Infinite where |W| is not known to stay above the change of W.
template <int Dimension>
double sensitivity(const RationalHodograph<Dimension>& r) {
  constexpr double unsure = 0x1p-38;
  constexpr double up = 1 + 0x1p-20;      // for the roundings of the bound itself
  constexpr double underflow = 0x1p-458;  // of the squares of coordinates: at most 2^-511, over u
  constexpr int depth_limit = 80;
  struct Part {
    RationalPanel<1> sizes;
    Curve<Form::bernstein, double, 1> w;
    int depth;
  };
  std::vector<Part> parts{{r.sizes, r.w, 0}};
  double sum = 0;
  while (!parts.empty()) {
    auto part = std::move(parts.back());
    parts.pop_back();
    const auto range = weight_range(part.w);
    const double size = weight_range(part.sizes.w).largest;
    const double least = range.least - unsure * size;
    if (least > 0 && range.largest <= 2 * range.least) {
      const double of_vectors = (polygon_length(part.sizes.h) + underflow) / least / least;
      sum += std::ldexp(up * of_vectors * (1 + 2 * size / least), -part.depth);
    } else if (part.depth == depth_limit) {
      return std::numeric_limits<double>::infinity();
    } else {
      Part left{cut_left_half(part.sizes), cut_left_half(part.w), ++part.depth};
      parts.push_back(std::move(part));
      parts.push_back(std::move(left));
    }
  }
  return sum;
}

/// As with polynomial hodographs, for any degree.
template <int Dimension, class Measure>
auto with_fixed_degree(const RationalHodograph<Dimension>& r, const Measure& measure) {
  RationalPanel<Dimension> panel = r;
  panel.sensitivity = sensitivity(r);
  return measure(panel);
}

/// The same for a length by `roundings` relative errors u in each value of U and W and in the sums of a quadrature,
/// with those of U_k, at most 5n + 16, and of restrict_to, six for each degree.
template <int Dimension>
double rounding_of_length(const RationalPanel<Dimension>& panel, int roundings) {
  constexpr double u = 0x1p-53;
  const int earlier = 5 * panel.w.degree() + 6 * (panel.degree() + 2) + 16;
  return u * gamma_over_u(roundings + earlier, u) * panel.sensitivity;
}

/// |U| / W^2, as Speed.
template <int Dimension>
class RationalSpeed {
 public:
  explicit RationalSpeed(const RationalPanel<Dimension>& panel) : h_(panel.h), w_(panel.w) {}

  double operator()(double t) {
    const double w = w_(t);
    return h_(t) / (w * w);
  }
  [[nodiscard]] std::int64_t evaluations() const { return h_.evaluations(); }

 private:
  Speed<Dimension> h_;
  Speed<1> w_;
};

template <int Dimension>
auto speed_of(const RationalPanel<Dimension>& panel) {
  return RationalSpeed<Dimension>(panel);
}

/// |U| / W^2 at eight parameters, as SquaredSpeeds::speeds.
template <int Dimension>
class RationalSpeeds {
 public:
  static constexpr std::size_t count = SquaredSpeeds<Dimension>::count;

  std::array<double, count> speeds(const RationalPanel<Dimension>& panel, std::span<const double, count> parameters) {
    auto result = h_.speeds(panel.h, parameters);
    const auto squares = w_(panel.w, parameters);
    for (std::size_t k = 0; k < count; ++k) result[k] /= squares[k];
    return result;
  }

 private:
  SquaredSpeeds<Dimension> h_;
  SquaredSpeeds<1> w_;
};

template <int Dimension>
RationalSpeeds<Dimension> speeds_for(const RationalPanel<Dimension>& panel);

/// The series of U and W over a panel.
template <int Dimension>
struct RationalSeries {
  ChebyshevSeries<Dimension> h;
  ChebyshevSeries<1> w;

  /// With |W| at least |w_0| / 2, the largest of 1 / W^2; rounded up.
  [[nodiscard]] double gain() const { return 4 * (1 + 0x1p-20) / (w.size(0) * w.size(0)); }
  /// How much more than U a change of W by as much changes U / W^2.
  [[nodiscard]] double share_of_weight() const { return 8 * h.size(0) / w.size(0); }
  /// The largest change of U, in U / W^2 as much as that of both series.
  [[nodiscard]] double cut() const { return h.cut() + share_of_weight() * w.cut(); }

  void shorten(double allowed) {
    const double of_each = allowed / gain() / 2;
    h.shorten(of_each);
    w.shorten(of_each / share_of_weight());
  }
};

template <int Dimension>
RationalSeries<Dimension> series_for(const RationalPanel<Dimension>& panel) {
  return {ChebyshevSeries<Dimension>(panel.h.degree()), ChebyshevSeries<1>(panel.w.degree())};
}

template <int Dimension>
double expand(RationalSeries<Dimension>& series, const RationalPanel<Dimension>& panel) {
  const double of_vectors = expand(series.h, panel.h);
  const double of_weight = expand(series.w, panel.w);
  return series.gain() * (of_vectors + series.share_of_weight() * of_weight);
}

template <int Dimension>
bool may_be_proved(const RationalPanel<Dimension>& panel) {
  return weight_range(panel.w).least > 0 && may_be_proved(panel.h);
}

/// The rule for |U| / W^2 (docs/proofs/proved_rule.md).
template <int Dimension>
ProvedRule proved_rule(const RationalSeries<Dimension>& series, double allowed) {
  const double gain = series.gain();
  auto rule = proved_rule(series.h, series.cut(), allowed / gain, &series.w);
  rule.missed *= gain;
  return rule;
}

/// The fourth derivative of |U| / W^2 by Leibniz's rule, with 0 = (1/W W)^(k) for those of 1 / W.
template <int Dimension>
FourthDerivative fourth_derivative(const RationalPanel<Dimension>& panel) {
  constexpr std::array<std::array<double, 5>, 5> binomial{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
  FourthDerivative result;
  const auto product = [&](const DerivativeSizes& a, const DerivativeSizes& b, std::size_t k) {
    double sum = 0;
    for (std::size_t i = 0; i <= k; ++i) sum += binomial[k][i] * a[i] * b[k - i];
    return sum;
  };
  const auto range = weight_range(panel.w);
  double of_weight = 0;
  auto weights = derivative_sizes(panel.w, of_weight);
  const double least = range.least * (1 - 0x1p-50);
  if (!(least > 0)) return result;
  weights[0] = 0;
  DerivativeSizes inverse{1 / least};
  for (std::size_t k = 1; k < 5; ++k) inverse[k] = product(weights, inverse, k) / least;
  DerivativeSizes inverse_square{};
  for (std::size_t k = 0; k < 5; ++k) inverse_square[k] = product(inverse, inverse, k);
  const auto speeds = speed_derivatives(panel.h, result.rounding);
  result.bound = product(speeds, inverse_square, 4);
  result.rounding = inverse_square[0] * (result.rounding + 2 * speeds[0] * of_weight / least);
  return result;
}

}  // namespace bezierbench
