// SPDX-License-Identifier: MIT
#include "core/bspline/kernel.hpp"

#include <cassert>

#include "core/bspline/roster.hpp"
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

template <class P>
double* write(const P& point, int dimension, double* coordinates) {
  for (int axis = 0; axis < dimension; ++axis) *coordinates++ = point[axis];
  return coordinates;
}

struct MakeKernel {
  template <class M, int Dimension>
  static constexpr BsplineKernel of() {
    static_assert(BsplineEvaluator<M> || BsplineConversion<M>);
    return {&M::info, bound_of<M>(), Dimension, BsplineConversion<M>, solve<M, Dimension>};
  }

 private:
  template <class M, int Dimension>
  static void solve(const BsplineSpanView& view, double t, double* coordinates) {
    assert(are_span_knots(view.knots));
    BsplineSpan<double, Dimension> span(view.knots);
    instantiate::fill(CurveView<double>{Form::bernstein, Dimension, view.degree, view.control_points},
                      span.control_points);
    if constexpr (BsplineConversion<M>) {
      const auto bernstein = M::convert(span);
      coordinates = write(point_of_span(bernstein, span.begin(), span.end(), t), Dimension, coordinates);
      for (int i = 0; i <= view.degree; ++i)
        for (int axis = 0; axis < Dimension; ++axis) *coordinates++ = bernstein(axis, i);
    } else {
      write(M::evaluate(span, t), Dimension, coordinates);
    }
  }
};

}  // namespace

std::span<const BsplineKernel> bspline_kernels(int dimension) {
  return kernels_of<BsplineKernel, MakeKernel>(BsplineMethods{}, dimension);
}

}  // namespace bezierbench
