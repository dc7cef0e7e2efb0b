// SPDX-License-Identifier: MIT
// GNU Scientific Library: the B-spline basis on one span. The sum with the control points is the user's, and so is
// ours.
//
// Computes: the Cox-de Boor recursion for all basis functions, then one scalar product per axis.
// Fails: t outside [0, 1] gives no point.
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>

#include <limits>
#include <memory>

#include "experiments/peers/adapter.hpp"
#include "experiments/peers/peers.hpp"

namespace bezierbench::peers {
namespace {

/// By default the library ends the program at its first error.
void return_from_errors() { [[maybe_unused]] static auto* const handler_before = gsl_set_error_handler_off(); }

struct Gsl {
  static constexpr MethodInfo info{.id = "peer_gsl",
                                   .label = "GSL B-spline basis",
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .bit_stable = false,
                                   .flops = "that of the library, O(n^2), + d(2n+1)",
                                   .cost_exponent = 2,
                                   .citation = "GSL, gsl_bspline_eval"};

  struct Free {
    void operator()(gsl_bspline_workspace* workspace) const { gsl_bspline_free(workspace); }
    void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
  };
  template <int Dimension>
  struct Prepared {
    Curve<Form::bernstein, double, Dimension> curve;
    std::unique_ptr<gsl_bspline_workspace, Free> workspace;
    std::unique_ptr<gsl_vector, Free> basis;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve) {
    return_from_errors();
    const auto order = static_cast<std::size_t>(curve.degree()) + 1;
    Prepared<Dimension> prepared{curve, std::unique_ptr<gsl_bspline_workspace, Free>(gsl_bspline_alloc(order, 2)),
                                 std::unique_ptr<gsl_vector, Free>(gsl_vector_alloc(order))};
    gsl_bspline_knots_uniform(0, 1, prepared.workspace.get());
    return prepared;
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& prepared, double t) {
    if (gsl_bspline_eval(t, prepared.basis.get(), prepared.workspace.get()) != GSL_SUCCESS)
      return Point<double, Dimension>::Constant(std::numeric_limits<double>::quiet_NaN());
    Point<double, Dimension> point = Point<double, Dimension>::Zero();
    for (int i = 0; i <= prepared.curve.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis)
        point[axis] += gsl_vector_get(prepared.basis.get(), static_cast<std::size_t>(i)) * prepared.curve(axis, i);
    return point;
  }
};

}  // namespace

std::span<const Kernel<double>> peer_gsl(int dimension) { return kernels_of<Gsl>(dimension); }

}  // namespace bezierbench::peers
