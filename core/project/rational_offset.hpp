// SPDX-License-Identifier: MIT
// A rational curve C = A / W relative to the point P.
//
// Formula: C - P = V / W with V = sum w_i (b_i - P) B_i. Its derivative is C' = U / W^2 with U = V'W - VW', which is
//   A'W - AW' of core/arc_length/rational_hodograph.hpp, since V = A - P W. So (C - P).C' = V.U / W^3. The roots of V.U
//   are the feet of P; its degree is 3n - 2.
// Source: derived here, from the quotient rule ([Piegl and Tiller 1997], eq. (4.8)).
// Cost: n^2 (2d + 4) / 2 flops once; a distance costs a point of degree n on d + 1 axes.
// Bound: V is off by (3n + 2) u of sum |w_i| |b_i - P| B_i: a distance by some n u of the largest |b_i - P|, times
//   sum |w_i| B_i / |W|.
// Fails: where W has a root in [0, 1], or a weight is more than 2^900 times another one.
#pragma once

#include "core/arc_length/rational_hodograph.hpp"
#include "core/homogeneous_coordinates.hpp"
#include "core/project/kernel.hpp"
#include "core/project/offset_curve.hpp"

namespace bezierbench {

/// As OffsetCurve; of a degree from 1 to rational_degree_limit.
template <int Dimension>
class RationalOffset {
 public:
  using Vector = Point<double, Dimension>;

  RationalOffset(const Curve<Form::rational, double, Dimension>& curve, const Vector& point) {
    const auto hodograph = scaled_hodograph(curve);
    const int n = curve.degree();
    double largest = largest_coordinate<Dimension>(point);
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(curve.points(axis, i)));
    constexpr int min_exponent = -1000;
    if (largest != 0) exponent_ = std::max(binary_exponent(largest) + 1, min_exponent);
    lifted_.resize(Dimension + 1, n + 1);
    // Their sign does not matter to the curve, but to that of V.U / W^3.
    const double sign = hodograph.h.w(0, 0) < 0 ? -1 : 1;
    for (int i = 0; i <= n; ++i) {
      const double w = sign * hodograph.h.w(0, i);
      positive_ = positive_ && w > 0;
      lifted_(Dimension, i) = w;
      for (int axis = 0; axis < Dimension; ++axis) {
        const double offset =
            times_power_of_two(curve.points(axis, i), -exponent_) - times_power_of_two(point[axis], -exponent_);
        largest_offset_ = std::max(largest_offset_, std::abs(offset));
        lifted_(axis, i) = w * offset;
      }
    }
    steps_ = differences<Dimension + 1>(lifted_);
    u_.resize(Dimension, hodograph.h.degree() + 1);
    for (int i = 0; i <= hodograph.h.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis) u_(axis, i) = hodograph.h.h(axis, i);
    u_steps_ = differences<Dimension>(u_);
  }

  [[nodiscard]] int degree() const { return degree_of<Dimension + 1>(lifted_); }
  /// Control points of V / m and W, scaled.
  [[nodiscard]] const Polygon<Dimension + 1>& offsets() const { return lifted_; }
  /// Whether all weights have one sign.
  [[nodiscard]] bool is_positive() const { return positive_; }
  /// The largest |coordinate| of b_i - P, over m.
  [[nodiscard]] double largest_offset() const { return largest_offset_; }

  /// (C(t) - P) / m.
  [[nodiscard]] Vector at(double t) const {
    const auto v = point_at<Dimension + 1>(lifted_, t);
    Vector offset;
    for (int axis = 0; axis < Dimension; ++axis) offset[axis] = v[axis] / v[Dimension];
    return offset;
  }
  [[nodiscard]] double scaled_distance(double t) const { return length<Dimension>(at(t)); }
  [[nodiscard]] double distance(double t) const { return unscaled(scaled_distance(t)); }
  [[nodiscard]] double unscaled(double length) const { return times_power_of_two(length, exponent_); }

  /// V.U and its derivative, up to a positive factor.
  struct Slope {
    double value;
    double derivative;
  };
  [[nodiscard]] Slope slope(double t) const {
    const auto v = point_at<Dimension + 1>(lifted_, t);
    const auto step = point_at<Dimension + 1>(steps_, t);
    const auto u = point_at<Dimension>(u_, t);
    const auto bend = point_at<Dimension>(u_steps_, t);
    Slope slope{0, 0};
    for (int axis = 0; axis < Dimension; ++axis) {
      slope.value += v[axis] * u[axis];
      slope.derivative += degree() * step[axis] * u[axis] + (2 * degree() - 2) * v[axis] * bend[axis];
    }
    return slope;
  }

  /// sum |w_i| B_i / |W|, by which errors are larger than those of weights of one sign.
  [[nodiscard]] double cancellation(double t) const {
    if (positive_) return 1;
    Polygon<1> sizes(1, lifted_.cols());
    for (int i = 0; i <= degree(); ++i) sizes(0, i) = std::abs(lifted_(Dimension, i));
    return point_at<1>(sizes, t)[0] / std::abs(point_at<Dimension + 1>(lifted_, t)[Dimension]);
  }

  /// None is known of the second derivative, so that no step of Newton's method is the last one by it.
  [[nodiscard]] static double largest_bend() { return std::numeric_limits<double>::infinity(); }

 private:
  Polygon<Dimension + 1> lifted_;
  Polygon<Dimension + 1> steps_;
  Polygon<Dimension> u_;
  Polygon<Dimension> u_steps_;
  int exponent_ = 0;  ///< m = 2^exponent
  bool positive_ = true;
  double largest_offset_ = 0;
};

template <int Dimension>
OffsetCurve<Dimension> offset_of(const Curve<Form::bernstein, double, Dimension>& curve,
                                 const Point<double, Dimension>& point) {
  return OffsetCurve<Dimension>(curve, point);
}
template <int Dimension>
RationalOffset<Dimension> offset_of(const Curve<Form::rational, double, Dimension>& curve,
                                    const Point<double, Dimension>& point) {
  return RationalOffset<Dimension>(curve, point);
}

/// A method for polynomial curves that requires no more than distances, V and W. It states no bound of the residual,
/// and has not converged where weights are too far apart.
template <class Method>
struct ProjectionOfRational {
  static constexpr MethodInfo info = [] {
    MethodInfo composed = Method::info;
    composed.form = Form::rational;
    composed.max_degree = rational_degree_limit;
    composed.prepare_exponent = 2;
    return composed;
  }();

  template <int Dimension>
  static FootPoint project(const Curve<Form::rational, double, Dimension>& curve,
                           const Point<double, Dimension>& point) {
    FootPoint foot = Method::project(curve, point);
    foot.converged = foot.converged && weights_are_in_range(curve);
    return foot;
  }
};

}  // namespace bezierbench
