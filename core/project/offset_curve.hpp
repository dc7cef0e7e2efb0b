// SPDX-License-Identifier: MIT
// The curve relative to the point, C - P, and the derivatives of its squared length.
//
// With m a power of two at or above all coordinates, and at least 2^-1000, b_i and P are divided by m, exactly, and
// b_i - P = high + low is an error-free sum. De Casteljau's triangle in two parts
// (core/evaluate/schemes/compensated_triangle.hpp) evaluates C - P, so that its error is one rounding of itself and
// c_2 u^2 of the coordinates, also next to the curve, where C and P agree in all digits.
#pragma once

#include "core/evaluate/schemes/compensated_triangle.hpp"
#include "core/powers.hpp"
#include "core/project/polygon.hpp"

namespace bezierbench {

/// The degree is known at compile time, or dynamic.
template <int Dimension, int Degree = dynamic>
class OffsetCurve {
 public:
  using Vector = Point<double, Dimension>;
  using Points = Polygon<Dimension, count_of(Degree, 1)>;
  using Differences = Polygon<Dimension, Degree>;

  OffsetCurve(const Curve<Form::bernstein, double, Dimension>& curve, const Vector& point) {
    const int n = Degree == dynamic ? curve.degree() : Degree;
    constexpr int coordinates = Degree == dynamic ? dynamic : Dimension * (Degree + 1);
    const double largest = std::max(largest_coordinate<Dimension>(point),
                                    largest_magnitude<coordinates>(curve.data(), Dimension * (n + 1)));
    if (largest != 0) exponent_ = std::max(binary_exponent(largest), min_exponent);
    const double scale = times_power_of_two(1.0, -exponent_);
    Points scaled;
    scaled.resize(Dimension, n + 1);
    high_.resize(Dimension, n + 1);
    low_.resize(Dimension, n + 1);
    const Coordinates factor(scale);
    const Coordinates from = -(Coordinates::read(point.data()) * factor);
    for (int i = 0; i <= n; ++i) {
      const Coordinates here = Coordinates::read(curve.data() + Dimension * i) * factor;
      set_column<Dimension>(scaled, i, here);
      const auto difference = two_sum(here, from);
      set_column<Dimension>(high_, i, difference.value);
      set_column<Dimension>(low_, i, difference.error);
    }
    first_ = differences<Dimension>(scaled);
    second_ = differences<Dimension>(first_);
    const double largest_offset = largest_coordinate<Dimension>(high_);
    const double largest_first = largest_coordinate<Dimension>(first_);
    const double largest_second = largest_coordinate<Dimension>(second_);
    largest_bend_ = Dimension * (n - 1) * largest_second * (3 * n * largest_first + 2 * (n - 2) * largest_offset);
    largest_slope_ = Dimension * (n * largest_first * largest_first + (n - 1) * largest_second * largest_offset);
    slope_error_ = 0x1p-53 * (3 * n + 6) * Dimension * largest_first;
  }

  [[nodiscard]] int degree() const { return Degree == dynamic ? degree_of<Dimension>(high_) : Degree; }
  /// (b_i - P) / m, each rounded once.
  [[nodiscard]] const Points& offsets() const { return high_; }
  /// (b_(i+1) - b_i) / m, each rounded once.
  [[nodiscard]] const Differences& differences_of_points() const { return first_; }

  /// (C(t) - P) / m. gnu::flatten: otherwise GCC calls each step of the triangle with its operands in memory.
  [[nodiscard, gnu::flatten]] Vector at(double t) const {
    if (t == 0) return high_.col(0);  // same bits as the code below
    if (t == 1) return high_.col(degree());
    const Coordinates next_weight(t);
    const auto s = two_sum(Coordinates(1.0), -next_weight);
    auto high = high_;
    auto low = low_;
    const auto parts_of = [&](int i) { return std::array{column<Dimension>(high, i), column<Dimension>(low, i)}; };
    each_of_triangle<Degree>(degree(), [&](int i) {
      const auto parts = compensated_step<2, Coordinates>(parts_of(i), parts_of(i + 1), s, next_weight);
      set_column<Dimension>(high, i, parts[0]);
      set_column<Dimension>(low, i, parts[1]);
    });
    Vector sum;
    (column<Dimension>(high, 0) + column<Dimension>(low, 0)).store(sum.data());
    return sum;
  }

  /// |C(t) - P|, over m and in coordinate units.
  [[nodiscard]] double scaled_distance(double t) const { return length<Dimension>(at(t)); }
  [[nodiscard]] double distance(double t) const { return unscaled(scaled_distance(t)); }
  /// A length given over m, in coordinate units.
  [[nodiscard]] double unscaled(double length) const { return times_power_of_two(length, exponent_); }

  /// f = (C - P).C' and its derivative |C'|^2 + (C - P).C'', and |C'|^2, all over n m^2.
  struct Slope {
    double value;
    double derivative;
    double speed_squared;
  };
  [[nodiscard]] Slope slope(double t) const {
    const auto offset = at(t);
    const auto velocity = point_at<Dimension>(first_, t);  // C' / n
    const double speed_squared = degree() * dot<Dimension>(velocity, velocity);
    const double bend = (degree() - 1) * dot<Dimension>(offset, point_at<Dimension>(second_, t));
    return {dot<Dimension>(offset, velocity), speed_squared + bend, speed_squared};
  }

  /// A bound of how much |C - P|^2 / m^2 falls on the way from t by `step` or less, within [0, 1], where (C(t) - P) / m
  /// is `offset` and `distance` long: with f and f' as in Slope, at most 2 n |f(t)| step + n |f'| step^2. An end of the
  /// curve has one way only.
  [[nodiscard]] double largest_fall(double t, const Vector& offset, double distance, double step) const {
    const double f = dot<Dimension>(offset, point_at<Dimension>(first_, t));
    const double falling = t == 0 ? std::max(0.0, -f) : t == 1 ? std::max(0.0, f) : std::abs(f);
    return degree() * step * (2 * (falling + slope_error_ * distance) + largest_slope_ * step);
  }

  /// A bound of |f''| = |3 C'.C'' + (C - P).C'''| on [0, 1], over n m^2.
  [[nodiscard]] double largest_bend() const { return largest_bend_; }

 private:
  using Coordinates = Axes<double, Dimension>;
  static constexpr int min_exponent = -1000;  // makes 1/m a double

  Points high_;
  Points low_;
  Differences first_;
  Polygon<Dimension, count_of(Degree, -1)> second_;
  int exponent_ = 0;  ///< m = 2^exponent
  double largest_bend_ = 0;
  double largest_slope_ = 0;  ///< a bound of |f'|
  double slope_error_ = 0;    ///< a bound of the error of a computed f, over |C - P| / m
};

}  // namespace bezierbench
