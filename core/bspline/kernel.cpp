// SPDX-License-Identifier: MIT
#include "core/bspline/kernel.hpp"

#include <cassert>
#include <concepts>
#include <functional>

#include "core/bspline/roster.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <class M>
constexpr const BsplineBound* bound_of() {
  if constexpr (requires { M::bound; })
    return &M::bound;
  else
    return nullptr;
}

/// Writes a point at `next`, which moves behind it.
template <class Scalar, int Dimension>
void write(const Point<Scalar, Dimension>& point, double*& next) {
  for (int axis = 0; axis < Dimension; ++axis) *next++ = point[axis];
}

/// Writes what the method finds; `point_from` makes a point of the curve from one that the method has.
template <class M, int Dimension, class PointFrom>
void write_solved(const BsplineSpan<double, Dimension>& span, double t, const PointFrom& point_from, double* next) {
  if constexpr (BsplineConversion<M>) {
    const auto bernstein = M::convert(span);
    write(point_from(point_of_span(bernstein, span.begin(), span.end(), t)), next);
    for (int i = 0; i <= span.degree(); ++i) {
      Point<double, Dimension> point;
      for (int axis = 0; axis < Dimension; ++axis) point[axis] = bernstein(axis, i);
      write(point_from(point), next);
    }
    constexpr bool homogeneous = !std::same_as<PointFrom, std::identity>;
    for (int i = 0; homogeneous && i <= span.degree(); ++i) *next++ = bernstein(Dimension - 1, i);
  } else {
    write(point_from(M::evaluate(span, t)), next);
  }
}

struct MakeKernel {
  template <class M, int Dimension>
  static constexpr BsplineKernel of() {
    if constexpr (M::info.form == Form::rational)
      return kernel_of<typename M::Polynomial, Dimension>(M::info, solve_rational<typename M::Polynomial, Dimension>);
    else
      return kernel_of<M, Dimension>(M::info, solve<M, Dimension>);
  }

 private:
  template <class M, int Dimension>
  static constexpr BsplineKernel kernel_of(const MethodInfo& info, decltype(BsplineKernel::solve) solve) {
    static_assert(BsplineEvaluator<M> || BsplineConversion<M>);
    return {&info, bound_of<M>(), Dimension, BsplineConversion<M>, solve};
  }
  template <class M, int Dimension>
  static void solve(const BsplineSpanView& view, double t, double* coordinates) {
    assert(are_span_knots(view.knots));
    BsplineSpan<double, Dimension> span(view.knots);
    instantiate::fill(CurveView<double>{Form::bernstein, Dimension, view.degree, view.control_points},
                      span.control_points);
    write_solved<M>(span, t, std::identity(), coordinates);
  }
  template <class M, int Dimension>
  static void solve_rational(const BsplineSpanView& view, double t, double* coordinates) {
    assert(are_span_knots(view.knots));
    BsplineSpan<double, Dimension + 1> span(view.knots);
    for (int i = 0, k = 0; i <= view.degree; ++i) {
      const double weight = view.weights[static_cast<std::size_t>(i)];
      for (int axis = 0; axis < Dimension; ++axis)
        span.control_points(axis, i) = weight * view.control_points[static_cast<std::size_t>(k++)];
      span.control_points(Dimension, i) = weight;
    }
    write_solved<M>(span, t, over_last<double, Dimension + 1>, coordinates);
  }
};

}  // namespace

std::span<const BsplineKernel> bspline_kernels(int dimension) {
  return kernels_of<BsplineKernel, MakeKernel>(BsplineMethods{}, dimension);
}

}  // namespace bezierbench
