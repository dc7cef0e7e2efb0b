// SPDX-License-Identifier: MIT
#include "bindings/c/evaluation.hpp"

#include <array>
#include <span>

#include "bindings/c/curve.hpp"

namespace bezierbench::c {
namespace {

constexpr std::size_t fewest_side_by_side = 16;  // fewer points are faster one by one
constexpr std::size_t points_at_once = 512;      // stay in the first cache until the caller has them

/// From axis by axis to point by point.
template <std::size_t dimension, class Scalar>
void interleave(const Scalar* by_axis, std::size_t count, Scalar* out) {
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t axis = 0; axis < dimension; ++axis) out[k * dimension + axis] = by_axis[axis * count + k];
}

/// From axis by axis to the places that the strides name.
template <class Scalar>
void write_points(const Scalar* by_axis, std::ptrdiff_t dimension, std::size_t count, Scalar* out,
                  const bb_strides& steps) {
  const bool point_by_point = steps.axis == 1 && steps.point == dimension;
  if (point_by_point && dimension == 2) return interleave<2>(by_axis, count, out);
  if (point_by_point && dimension == 3) return interleave<3>(by_axis, count, out);
  for (std::ptrdiff_t axis = 0; axis < dimension; ++axis, by_axis += count)
    copy_strided(by_axis, 1, count, out + axis * steps.axis, steps.point);
}

}  // namespace

template <class Scalar>
Evaluation<Scalar>::Evaluation(const Kernel<Scalar>& kernel, int degree, std::size_t most)
    : dimension_(kernel.dimension), one_by_one_(kernel.evaluate_for(degree)) {
  if (most >= fewest_side_by_side)
    side_by_side_ = on_best_target([&](const batch::Target& target) { return batch::find(target, kernel); });
}

template <class Scalar>
void Evaluation<Scalar>::operator()(const void* prepared, const Scalar* t, std::ptrdiff_t t_step, std::size_t count,
                                    Scalar* out, const bb_strides& steps) const {
  const bool side_by_side = side_by_side_ && count >= fewest_side_by_side;
  const auto all = static_cast<std::ptrdiff_t>(count);
  const bb_strides as_computed = side_by_side ? bb_strides{0, 1, all} : bb_strides{0, dimension_, 1};
  const bool in_place = steps.point == as_computed.point && (dimension_ == 1 || steps.axis == as_computed.axis);
  const auto evaluate = [&](std::span<const Scalar> at, Scalar* points) {
    side_by_side ? side_by_side_(prepared, at, points) : one_by_one_(prepared, at, points);
  };
  if (t_step == 1 && in_place) return evaluate({t, count}, out);
  std::array<Scalar, points_at_once> ts;
  std::array<Scalar, points_at_once * max_dimension> points;
  while (count > 0) {
    const std::size_t part = std::min(points_at_once, count);
    if (t_step != 1) copy_strided(t, t_step, part, ts.data(), 1);
    evaluate({t_step == 1 ? t : ts.data(), part}, points.data());
    if (side_by_side)
      write_points(points.data(), dimension_, part, out, steps);
    else
      for (std::ptrdiff_t axis = 0; axis < dimension_; ++axis)
        copy_strided(points.data() + axis, dimension_, part, out + axis * steps.axis, steps.point);
    count -= part;
    t += static_cast<std::ptrdiff_t>(part) * t_step;
    out += static_cast<std::ptrdiff_t>(part) * steps.point;
  }
}

template class Evaluation<float>;
template class Evaluation<double>;

}  // namespace bezierbench::c
