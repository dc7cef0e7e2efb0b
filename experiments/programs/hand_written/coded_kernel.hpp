// SPDX-License-Identifier: MIT
// A hand-written coding behind the interface of the methods. What is prepared for a curve comes from the method: its
// work per point is what is written by hand.
#pragma once

#include <algorithm>
#include <array>
#include <new>
#include <span>
#include <tuple>
#include <type_traits>

#include "core/evaluate/de_casteljau_fixed_point.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/kernel.hpp"
#include "core/evaluate/prepared_state.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace bezierbench::programs {

/// The evaluator's kernel: its own, or that of a path which ends in it, where its form is none that curves have.
template <class Evaluator, class Scalar>
const Kernel<Scalar>& own_kernel(int dimension) {
  if (const auto* own = find_kernel<Scalar>(Evaluator::info.id, Evaluator::info.form, dimension)) return *own;
  return *std::ranges::find_if(kernels<Scalar>(dimension), [](const Kernel<Scalar>& kernel) {
    return kernel.evaluator->id == Evaluator::info.id && kernel.evaluated_form == Evaluator::info.form;
  });
}

namespace detail {

template <int Degree, Form F, class S, int Dimension>
auto plain(const Curve<F, S, Dimension>& curve) {
  hand_written::Points<S, Dimension, Degree> points;
  std::copy_n(curve.data(), points.values.size(), points.values.data());
  return points;
}
template <int Degree, class S>
auto plain(const PerCoefficient<S, dynamic>& numbers) {
  hand_written::Row<S, Degree> row;
  std::copy_n(numbers.data(), row.values.size(), row.values.data());
  return row;
}
template <int /*Degree*/, class S, int Dimension>
auto plain(const FixedPointFrame<S, Dimension>& frame) {
  hand_written::Points<S, Dimension, fixed_point_values - 1> points;
  for (int k = 0; k < fixed_point_values; ++k)
    for (int axis = 0; axis < Dimension; ++axis)
      points.values[static_cast<std::size_t>(k * Dimension + axis)] = frame(axis, static_cast<FixedPointValue>(k));
  return points;
}

/// What a method prepared for a curve of this degree, as plain arrays.
template <int Degree, class State>
auto plain_parts(const State& state) {
  if constexpr (requires { state.parts(); })
    return std::apply([](const auto&... part) { return std::tuple(plain<Degree>(part)...); }, state.parts());
  else if constexpr (State::form == Form::rational)
    return std::tuple(plain<Degree>(state.points), plain<Degree>(state.weights));
  else if constexpr (State::form == Form::power_double_double)
    return std::tuple(plain<Degree>(state.high), plain<Degree>(state.low));
  else
    return std::tuple(plain<Degree>(state));
}

}  // namespace detail

template <class Evaluator, class Scalar, int Dimension, int Degree>
Kernel<Scalar> coded_kernel() {
  using Prepared = PreparedOf<Evaluator, Scalar, Dimension>;
  using Parts = decltype(detail::plain_parts<Degree>(std::declval<const Prepared&>()));
  Kernel<Scalar> kernel = own_kernel<Evaluator, Scalar>(Dimension);
  kernel.prepared_size = sizeof(Parts);
  kernel.prepared_alignment = alignof(Parts);
  kernel.prepare = [](const CurveView<Scalar>& curve, void* prepared) {
    const PreparedState<Scalar> state(own_kernel<Evaluator, Scalar>(Dimension), curve);
    new (prepared) Parts(detail::plain_parts<Degree>(*static_cast<const Prepared*>(state.get())));
  };
  kernel.evaluate_for = [](int /*degree*/) -> EvaluatePoints<Scalar> {
    return [](const void* prepared, std::span<const Scalar> t, Scalar* points) {
      const auto& parts = *static_cast<const Parts*>(prepared);
      for (const Scalar at : t) {
        const auto point = std::apply(
            [at](const auto&... part) { return hand_written::ByHand<Evaluator>::evaluate(at, part...); }, parts);
        hand_written::store<Dimension>(point, points);
        points += Dimension;
      }
    };
  };
  return kernel;
}

}  // namespace bezierbench::programs
