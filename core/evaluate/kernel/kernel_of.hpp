// SPDX-License-Identifier: MIT
// Turns one method into a kernel: the step from the compile-time concept to function pointers.
#pragma once

#include <algorithm>
#include <memory>
#include <new>
#include <type_traits>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/evaluate/kernel/points/axes_conversion.hpp"
#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench::instantiate {

/// Copies the coefficients of a view, whose degree the curve has.
template <Form F, class Scalar, int Dimension>
void fill(const CurveView<Scalar>& view, Curve<F, Scalar, Dimension>& curve) {
  if constexpr (F == Form::rational) {
    fill(view, curve.points);
    for (int i = 0; i <= view.degree; ++i) curve.weights[i] = view.weights[static_cast<std::size_t>(i)];
  } else {
    // Whole points, as they are read afterwards: partial stores defeat store-to-load forwarding.
    using Coefficient = Axes<Scalar, Dimension>;
    const Scalar* from = view.coefficients.data();
    Scalar* to = &curve(0, 0);
    for (int i = 0; i <= view.degree; ++i) Coefficient::read(from + i * Dimension).store(to + i * Dimension);
  }
}

template <Form F, int Dimension, class Scalar>
Curve<F, Scalar, Dimension> load(const CurveView<Scalar>& view) {
  Curve<F, Scalar, Dimension> curve(view.degree);
  fill(view, curve);
  return curve;
}

template <Form F, class Scalar, int Dimension>
void append(const Curve<F, Scalar, Dimension>& curve, std::vector<Scalar>& coefficients) {
  if constexpr (F == Form::power_double_double) {
    append(curve.high, coefficients);
    append(curve.low, coefficients);
  } else {
    for (int i = 0; i <= curve.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis) coefficients.push_back(curve(axis, i));
  }
}

/// A converted path names its conversion.
template <class E>
concept Path = requires {
  typename E::First;
};

/// A path by way of a curve as it can be given.
template <class E>
concept PathOfGiven = Path<E> && is_given(E::First::target);

/// One whose evaluator takes that curve as it is.
template <class E>
concept ConversionOnly = PathOfGiven<E> && PreparesNothing<typename E::Second>;

/// True where what a method does once per curve can be done for all axes at once.
template <class E>
constexpr bool prepares_all_axes() {
  if constexpr (Path<E>)
    return IsSameForEveryAxis<typename E::First> &&
           (PreparesNothing<typename E::Second> || IsSameForEveryAxis<typename E::Second>);
  else
    return IsSameForEveryAxis<E>;
}

/// Writes the coefficients in the other form, point by point. Degrees up to cubics have code of their own: loops over
/// so few coefficients take longer than the arithmetic in them.
template <class C, int Dimension, class Scalar>
void convert_into(const CurveView<Scalar>& view, Scalar* coefficients) {
  const auto write = [coefficients](const auto& converted) {
    for (int i = 0; i <= converted.degree(); ++i) converted(0, i).store(coefficients + i * Dimension);
  };
  if constexpr (IsSameForEveryAxis<C>) {
    switch (view.degree) {
      case 1: return write(C::convert(axes_of_degree<C::info.form, Dimension, 1>(view)));
      case 2: return write(C::convert(axes_of_degree<C::info.form, Dimension, 2>(view)));
      case 3: return write(C::convert(axes_of_degree<C::info.form, Dimension, 3>(view)));
      default: return write(C::convert(axes_of<C::info.form, Dimension>(view)));
    }
  } else {
    const auto converted = C::convert(load<C::info.form, Dimension>(view));
    std::copy_n(converted.data(), (view.degree + 1) * Dimension, coefficients);
  }
}

/// The curve in the other form.
template <class C, int Dimension, class Scalar>
Curve<C::target, Scalar, Dimension> convert(const CurveView<Scalar>& view) {
  if constexpr (is_given(C::target)) {
    Curve<C::target, Scalar, Dimension> curve(view.degree);
    convert_into<C, Dimension>(view, &curve(0, 0));
    return curve;
  } else if constexpr (IsSameForEveryAxis<C>) {
    return as_points<Dimension>(C::convert(axes_of<C::info.form, Dimension>(view)));
  } else {
    return C::convert(load<C::info.form, Dimension>(view));
  }
}

/// What the method prepares for a curve.
template <class E, int Dimension, class Scalar>
PreparedOf<E, Scalar, Dimension> prepare(const CurveView<Scalar>& view) {
  if constexpr (ConversionOnly<E>) {
    return convert<typename E::First, Dimension>(view);
  } else if constexpr (PathOfGiven<E>) {
    const auto converted = convert<typename E::First, Dimension>(view);
    const CurveView<Scalar> there{E::First::target,
                                  Dimension,
                                  view.degree,
                                  {converted.data(), static_cast<std::size_t>((view.degree + 1) * Dimension)}};
    return prepare<typename E::Second, Dimension>(there);
  } else if constexpr (Path<E> && prepares_all_axes<E>()) {
    return as_points<Dimension>(E::prepare(axes_of<E::info.form, Dimension>(view)));
  } else if constexpr (prepares_all_axes<E>()) {
    return E::prepare(Curve<E::info.form, Scalar, Dimension, viewed>(view.coefficients.data(), view.degree));
  } else {
    return E::prepare(load<E::info.form, Dimension>(view));
  }
}

template <class E>
constexpr const MethodInfo* evaluator() {
  if constexpr (Path<E>)
    return &E::Second::info;
  else
    return &E::info;
}

template <class E>
constexpr const MethodInfo* conversion() {
  if constexpr (Path<E>)
    return &E::First::info;
  else
    return nullptr;
}

template <class E>
constexpr Form evaluated_form() {
  if constexpr (Path<E>)
    return E::First::target;
  else
    return E::info.form;
}

template <class E, class Scalar, int Dimension>
constexpr auto converted() -> void (*)(const CurveView<Scalar>&, std::vector<Scalar>&) {
  if constexpr (Path<E>)
    return [](const CurveView<Scalar>& view, std::vector<Scalar>& coefficients) {
      coefficients.clear();
      append(convert<typename E::First, Dimension>(view), coefficients);
    };
  else
    return nullptr;
}

template <class Prepared>
constexpr auto destroy() -> void (*)(void*) {
  if constexpr (std::is_trivially_destructible_v<Prepared>)
    return nullptr;
  else
    return [](void* prepared) { std::destroy_at(static_cast<Prepared*>(prepared)); };
}

/// One point after the other, one axis after the other.
template <class E, class Scalar, int Dimension>
void evaluate_one_by_one(const void* prepared, std::span<const Scalar> t, Scalar* points) {
  const auto& state = *static_cast<const PreparedOf<E, Scalar, Dimension>*>(prepared);
  for (const Scalar at : t) {
    const Point<Scalar, Dimension> point = E::evaluate(state, at);
    for (int axis = 0; axis < Dimension; ++axis) *points++ = point[axis];
  }
}

/// The kernel of one method whose points the functions of `evaluate_for` compute.
template <Evaluator E, class Scalar, int Dimension>
constexpr Kernel<Scalar> kernel(EvaluatePoints<Scalar> (*evaluate_for)(int degree)) {
  using Prepared = PreparedOf<E, Scalar, Dimension>;
  return {&E::info,
          Dimension,
          sizeof(Prepared),
          alignof(Prepared),
          [](const CurveView<Scalar>& view, void* prepared) {
            if constexpr (PreparesNothing<E>)
              fill(view, *::new (prepared) Prepared(view.degree));
            else
              ::new (prepared) Prepared(prepare<E, Dimension>(view));
          },
          evaluate_for,
          evaluator<E>(),
          conversion<E>(),
          evaluated_form<E>(),
          converted<E, Scalar, Dimension>(),
          destroy<Prepared>()};
}

/// The same, one axis after the other.
template <Evaluator E, class Scalar, int Dimension>
constexpr Kernel<Scalar> kernel() {
  return kernel<E, Scalar, Dimension>(for_every_degree<Scalar, evaluate_one_by_one<E, Scalar, Dimension>>);
}

}  // namespace bezierbench::instantiate
