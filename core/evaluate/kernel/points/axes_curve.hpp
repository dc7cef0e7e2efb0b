// SPDX-License-Identifier: MIT
// What a method prepared for one curve, seen as coefficients that are points: a coefficient is read as one scalar, with
// all its axes. Nothing is copied. The degree is known at compile time, or not.
#pragma once

#include <algorithm>
#include <tuple>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/kernel/points/axes.hpp"
#include "core/evaluate/methods/de_casteljau_fixed_point.hpp"

namespace bezierbench {

/// A view of one curve; coefficient i is at first[i * stride].
template <Form F, class S, int DimensionT, int DegreeT>
class Curve<F, Axes<S, DimensionT>, 1, DegreeT> {
 public:
  using Scalar = Axes<S, DimensionT>;
  static constexpr Form form = F;
  static constexpr int dimension = 1;
  static constexpr int fixed_degree = DegreeT;

  Curve(const S* first, int degree) : first_(first), degree_(degree) {}

  [[nodiscard]] int degree() const { return DegreeT == dynamic ? degree_ : DegreeT; }
  [[nodiscard]] Scalar operator()(int /*axis*/, int i) const {
    return Scalar::load(first_ + static_cast<std::ptrdiff_t>(i) * DimensionT);
  }
  [[nodiscard]] const S* data() const { return first_; }

 private:
  const S* first_;
  int degree_;
};

/// Values that belong to the coefficients and are the same for all axes.
template <class S, int DimensionT>
class AxesRow {
 public:
  explicit AxesRow(const S* first) : first_(first) {}
  [[nodiscard]] Axes<S, DimensionT> operator[](int i) const { return Axes<S, DimensionT>(first_[i]); }
  [[nodiscard]] const S* data() const { return first_; }

 private:
  const S* first_;
};

template <class S, int DimensionT, int DegreeT>
struct PreparedRowType<Axes<S, DimensionT>, DegreeT> {
  using Type = AxesRow<S, DimensionT>;
};

template <class S, int DimensionT, int DegreeT>
class Curve<Form::power_double_double, Axes<S, DimensionT>, 1, DegreeT> {
 public:
  using Scalar = Axes<S, DimensionT>;
  using Part = Curve<Form::power, Scalar, 1, DegreeT>;

  [[nodiscard]] int degree() const { return high.degree(); }

  Part high;
  Part low;
};

template <class S, int DimensionT, int DegreeT>
class Curve<Form::rational, Axes<S, DimensionT>, 1, DegreeT> {
 public:
  using Scalar = Axes<S, DimensionT>;

  [[nodiscard]] int degree() const { return points.degree(); }

  Curve<Form::bernstein, Scalar, 1, DegreeT> points;
  AxesRow<S, DimensionT> weights;
};

template <class S, int DimensionT>
class FixedPointFrame<Axes<S, DimensionT>, 1> {
 public:
  explicit FixedPointFrame(const S* first) : first_(first) {}
  [[nodiscard]] Axes<S, DimensionT> operator()(int /*axis*/, FixedPointValue value) const {
    return Axes<S, DimensionT>::load_all(first_ + static_cast<int>(value) * FixedPointFrame<S, DimensionT>::stride);
  }

 private:
  const S* first_;
};

/// What is prepared for one curve, of a degree that is known here or `dynamic`.
template <int Degree, Form F, class S, int Dimension>
Curve<F, Axes<S, Dimension>, 1, Degree> as_axes(const Curve<F, S, Dimension>& curve) {
  return {curve.data(), curve.degree()};
}
template <int Degree, class S, int Dimension>
Curve<Form::power_double_double, Axes<S, Dimension>, 1, Degree> as_axes(
    const Curve<Form::power_double_double, S, Dimension>& curve) {
  return {as_axes<Degree>(curve.high), as_axes<Degree>(curve.low)};
}
template <int Degree, class S, int Dimension>
Curve<Form::rational, Axes<S, Dimension>, 1, Degree> as_axes(const Curve<Form::rational, S, Dimension>& curve) {
  return {as_axes<Degree>(curve.points), AxesRow<S, Dimension>(curve.weights.data())};
}

namespace detail {

template <int Degree, int Dimension, class S>
AxesRow<S, Dimension> part_as_axes(const PerCoefficient<S, dynamic>& row) {
  return AxesRow<S, Dimension>(row.data());
}
template <int Degree, int Dimension, Form F, class S>
Curve<F, Axes<S, Dimension>, 1, Degree> part_as_axes(const Curve<F, S, Dimension>& curve) {
  return as_axes<Degree>(curve);
}
template <int Degree, int Dimension, class S>
FixedPointFrame<Axes<S, Dimension>, 1> part_as_axes(const FixedPointFrame<S, Dimension>& frame) {
  return FixedPointFrame<Axes<S, Dimension>, 1>(frame.data());
}

}  // namespace detail

/// For a state of several members, which its function `parts` lists.
template <int Degree, template <class, int, int> class State, class S, int Dimension>
requires requires(const State<S, Dimension, dynamic>& state) { state.parts(); }
State<Axes<S, Dimension>, 1, Degree> as_axes(const State<S, Dimension, dynamic>& state) {
  return std::apply(
      [](const auto&... part) {
        return State<Axes<S, Dimension>, 1, Degree>{detail::part_as_axes<Degree, Dimension>(part)...};
      },
      state.parts());
}

/// The scalar of the view that `as_axes` returns.
template <class View>
struct AxesOf {
  using Type = typename View::Scalar;
};
template <template <class, int, int> class State, class A, int Degree>
requires requires(const State<A, 1, Degree>& state) { state.parts(); }
struct AxesOf<State<A, 1, Degree>> {
  using Type = A;
};

/// Of two curves the first, or the second, without a branch: which it is, no processor can guess for t at random.
template <Form F, class S, int Dimension, int Degree>
Curve<F, Axes<S, Dimension>, 1, Degree> chosen(bool is_first, const Curve<F, Axes<S, Dimension>, 1, Degree>& first,
                                               const Curve<F, Axes<S, Dimension>, 1, Degree>& second) {
  const S* const places[] = {second.data(), first.data()};
  return {places[is_first ? 1 : 0], first.degree()};
}

/// Room for the coefficients of a curve.
template <class A, int Degree>
class AxesArray {
 public:
  [[nodiscard]] A& operator()(int /*axis*/, int i) { return values_[i]; }
  [[nodiscard]] A& operator[](int i) { return values_[i]; }

 private:
  A values_[(Degree == dynamic ? max_degree : Degree) + 1];
};

template <Form F, class S, int Dimension, int Degree>
AxesArray<Axes<S, Dimension>, Degree> working_copy(const Curve<F, Axes<S, Dimension>, 1, Degree>& curve) {
  AxesArray<Axes<S, Dimension>, Degree> copy;
  for (int i = 0; i <= curve.degree(); ++i) copy(0, i) = curve(0, i);
  return copy;
}
template <int Degree, class S, int Dimension>
AxesArray<Axes<S, Dimension>, Degree> working_copy(const AxesRow<S, Dimension>& row, int degree) {
  AxesArray<Axes<S, Dimension>, Degree> copy;
  for (int i = 0; i <= degree; ++i) copy[i] = row[i];
  return copy;
}

/// True at a node of the barycentric form, which all axes share.
template <class S, int Dimension>
bool at_node(const Axes<S, Dimension>& distance) {
  return at_node(distance.lane(0));
}

/// The point with these homogeneous coordinates, whose last lane is left over.
template <class S, int Lifted>
Point<Axes<S, Lifted>, 1> over_last(const Point<Axes<S, Lifted>, 1>& lifted) {
  return Point<Axes<S, Lifted>, 1>(lifted[0] / Axes<S, Lifted>(lifted[0].lane(Lifted - 1)));
}

/// The degree of the curve that a state was prepared for.
template <class State>
int degree_of(const State& state) {
  if constexpr (requires { state.degree(); })
    return state.degree();
  else if constexpr (requires { state.parts(); })
    return std::apply([](const auto&... part) { return std::max({degree_of(part)...}); }, state.parts());
  else
    return 0;
}

}  // namespace bezierbench
