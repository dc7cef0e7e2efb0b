// SPDX-License-Identifier: MIT
// The curve as the point sees it, C - P, and what minimising its length asks for.
//
// With m a power of two at or above all coordinates, b_i and P are divided by m, exactly, and b_i - P = high + low is
// an error-free sum. C - P is evaluated by de Casteljau in two parts (core/evaluate/compensated_triangle.hpp), so that
// it is right to one rounding of itself and c_2 u^2 of the coordinates, also next to the curve, where C and P agree in
// all digits.
#pragma once

#include "core/evaluate/compensated_triangle.hpp"
#include "core/project/polygon.hpp"

namespace bezierbench {

template <int Dimension>
class OffsetCurve {
 public:
  using Vector = Point<double, Dimension>;

  OffsetCurve(const Curve<Form::bernstein, double, Dimension>& curve, const Vector& point) {
    const int n = curve.degree();
    double largest = 0;
    for (int axis = 0; axis < Dimension; ++axis) {
      largest = std::max(largest, std::abs(point[axis]));
      for (int i = 0; i <= n; ++i) largest = std::max(largest, std::abs(curve(axis, i)));
    }
    std::frexp(largest, &exponent_);
    Polygon<Dimension> scaled(Dimension, n + 1);
    high_.resize(Dimension, n + 1);
    low_.resize(Dimension, n + 1);
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) {
        scaled(axis, i) = std::ldexp(curve(axis, i), -exponent_);
        const auto difference = two_sum(scaled(axis, i), -std::ldexp(point[axis], -exponent_));
        high_(axis, i) = difference.value;
        low_(axis, i) = difference.error;
      }
    first_ = differences<Dimension>(scaled);
    second_ = differences<Dimension>(first_);
  }

  [[nodiscard]] int degree() const { return degree_of<Dimension>(high_); }
  /// b_i - P over m, each rounded once.
  [[nodiscard]] const Polygon<Dimension>& offsets() const { return high_; }
  /// b_(i+1) - b_i over m, each rounded once.
  [[nodiscard]] const Polygon<Dimension>& differences_of_points() const { return first_; }

  /// (C(t) - P) / m.
  [[nodiscard]] Vector at(double t) const {
    const auto s = two_sum(1.0, -t);
    auto high = high_;
    auto low = low_;
    for (int last = degree(); last > 0; --last)
      for (int i = 0; i < last; ++i)
        for (int axis = 0; axis < Dimension; ++axis) {
          const auto parts =
              compensated_step<2, double>({high(axis, i), low(axis, i)}, {high(axis, i + 1), low(axis, i + 1)}, s, t);
          high(axis, i) = parts[0];
          low(axis, i) = parts[1];
        }
    Vector sum;
    for (int axis = 0; axis < Dimension; ++axis) sum[axis] = high(axis, 0) + low(axis, 0);
    return sum;
  }

  /// |C(t) - P| / m, and in coordinate units.
  [[nodiscard]] double scaled_distance(double t) const { return length<Dimension>(at(t)); }
  [[nodiscard]] double distance(double t) const { return std::ldexp(scaled_distance(t), exponent_); }

  /// f = (C - P).C' and its derivative |C'|^2 + (C - P).C'', both over n m^2; and |C'|^2 over the same.
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

 private:
  Polygon<Dimension> high_;
  Polygon<Dimension> low_;
  Polygon<Dimension> first_;
  Polygon<Dimension> second_;
  int exponent_ = 0;  ///< m = 2^exponent
};

}  // namespace bezierbench
