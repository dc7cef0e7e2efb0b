// SPDX-License-Identifier: MIT
// A curve in Bernstein form with its control points counted from the end that t is nearer to: from b_0 for t <= 1/2,
// else from b_n, where 1-t is the parameter. `select` makes the choices, so that a scalar that is a vector chooses in
// each of its lanes.
#pragma once

#include <concepts>
#include <type_traits>

#include "core/evaluate/evaluator.hpp"
#include "core/vector/lane_choice.hpp"
#include "core/vector/vectors.hpp"
#include "core/vector/view.hpp"

namespace bezierbench {

/// A view of a curve with its coefficients counted from the start where `from_start` holds, else from the other end.
template <class Choice, class CurveT>
class FromNearerEnd {
 public:
  using Scalar = typename CurveT::Scalar;
  static constexpr int dimension = CurveT::dimension;
  static constexpr int fixed_degree = CurveT::fixed_degree;

  [[gnu::always_inline]] FromNearerEnd(const Choice& from_start, const CurveT& curve)
      : from_start_(from_start), curve_(curve) {}

  [[nodiscard, gnu::always_inline]] int degree() const { return curve_.degree(); }
  [[nodiscard, gnu::always_inline]] Scalar operator()(int axis, int i) const {
    if constexpr (std::same_as<Choice, bool>)
      return curve_(axis, from_start_ ? i : curve_.degree() - i);
    else
      return select(from_start_, curve_(axis, i), curve_(axis, curve_.degree() - i));
  }
  /// The same for calls with i = degree(), degree() - 1, ..., 0 in turn, all axes of each.
  [[nodiscard, gnu::always_inline]] Scalar counted_down(int axis, int i) const { return (*this)(axis, i); }

 private:
  // A mask of lanes is not copied: compilers do so in pieces of a few bytes.
  std::conditional_t<std::same_as<Choice, bool>, bool, const Choice&> from_start_;
  const CurveT& curve_;
};

/// For a view of all axes: the sign of a step says from which end to read. Above degree 4 GCC 12 compiles a choice of
/// each place to a branch at some degrees, which processors mispredict for half of all random t; below, it is faster.
template <Form F, ReadsCurves V, int Degree>
requires(Degree == dynamic || Degree > 4) class FromNearerEnd<bool, Curve<F, V, 1, Degree>> {
 public:
  using Scalar = V;
  static constexpr int dimension = 1;
  static constexpr int fixed_degree = Degree;

  [[gnu::always_inline]] FromNearerEnd(bool from_start, const Curve<F, V, 1, Degree>& curve)
      : first_(from_start ? curve.data() : curve.data() + static_cast<std::ptrdiff_t>(curve.degree()) * V::axes),
        step_(from_start ? V::axes : -V::axes),
        after_((curve.degree() + 1) * step_),
        degree_(curve.degree()) {}

  [[nodiscard, gnu::always_inline]] int degree() const { return degree_; }
  [[nodiscard, gnu::always_inline]] V operator()(int /*axis*/, int i) const { return V::read(first_ + i * step_); }
  [[nodiscard, gnu::always_inline]] V counted_down(int /*axis*/, int /*i*/) {
    return V::read(first_ + (after_ -= step_));
  }

 private:
  const typename V::Scalar* first_;
  std::ptrdiff_t step_;
  std::ptrdiff_t after_;  ///< the place of what `counted_down` read last
  int degree_;
};

/// The curve with its control points in reverse order.
template <class Scalar, int Dimension, int Degree>
Curve<Form::bernstein, Scalar, Dimension, Degree> reversed(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
  Curve<Form::bernstein, Scalar, Dimension, Degree> backwards(curve.degree());
  for (int i = 0; i <= curve.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) backwards(axis, i) = curve(axis, curve.degree() - i);
  return backwards;
}

/// The template argument `Degree` of a curve that is, in each lane, one of two, of a degree that is known at run time.
inline constexpr int one_of_two = -3;

template <Form F, class V, int DimensionT>
class Curve<F, V, DimensionT, one_of_two> {
 public:
  using Scalar = V;
  using Either = Curve<F, V, DimensionT>;
  static constexpr Form form = F;
  static constexpr int dimension = DimensionT;
  static constexpr int fixed_degree = dynamic;

  [[gnu::always_inline]] Curve(const typename V::Mask& is_first, const Either& first, const Either& second)
      : is_first_(is_first), first_(first), second_(second) {}

  [[nodiscard, gnu::always_inline]] int degree() const { return first_.degree(); }
  [[nodiscard, gnu::always_inline]] V operator()(int axis, int i) const {
    return select(is_first_, first_(axis, i), second_(axis, i));
  }
  [[nodiscard, gnu::always_inline]] V from_end(int axis, int k) const { return (*this)(axis, degree() - k); }

 private:
  const typename V::Mask& is_first_;  // compilers copy it in pieces of a few bytes
  const Either& first_;
  const Either& second_;
};

/// Of two curves of the same degree the first, or the second.
template <Form F, class Scalar, int Dimension, int Degree>
const Curve<F, Scalar, Dimension, Degree>& chosen(bool is_first, const Curve<F, Scalar, Dimension, Degree>& first,
                                                  const Curve<F, Scalar, Dimension, Degree>& second) {
  return is_first ? first : second;
}
/// Of two views without a branch: which it is, no processor can guess for t at random.
template <Form F, ReadsCurves V, int Dimension, int Degree>
Curve<F, V, Dimension, Degree> chosen(bool is_first, const Curve<F, V, Dimension, Degree>& first,
                                      const Curve<F, V, Dimension, Degree>& second) {
  const typename V::Scalar* const places[] = {second.data(), first.data()};
  return {places[is_first ? 1 : 0], first.degree()};
}
template <Form F, class Kind, Held held, int Dimension, int Degree>
[[gnu::always_inline]] inline Curve<F, Vectors<Kind, held>, Dimension, one_of_two> chosen(
    const typename Vectors<Kind, held>::Mask& is_first, const Curve<F, Vectors<Kind, held>, Dimension, Degree>& first,
    const Curve<F, Vectors<Kind, held>, Dimension, Degree>& second) {
  return {is_first, first, second};
}

}  // namespace bezierbench
