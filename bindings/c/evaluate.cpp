// SPDX-License-Identifier: MIT
// Points by a method.
#include <limits>

#include "bindings/c/curve.hpp"
#include "bindings/c/evaluation.hpp"
#include "bindings/c/more_axes.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"

using namespace bezierbench;

namespace bezierbench::c {

/// A curve as a method prepared it, and how it is evaluated.
template <class Scalar>
struct Prepared {
  PreparedState<Scalar> state;
  Evaluation<Scalar> evaluation;

  Prepared(const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve, std::size_t most)
      : state(kernel, curve), evaluation(kernel, curve.degree, most) {}

  void evaluate(const Scalar* t, std::size_t count, Scalar* out) const {
    const auto& kernel = state.kernel();
    const auto at = parameters(*kernel.info, t, count);
    if (at.empty()) return;
    require_pointers(out);
    evaluation(state.get(), at.data(), 1, count, out, {0, kernel.dimension, 1});
  }
};

}  // namespace bezierbench::c

namespace {

template <class Scalar>
void evaluate(const char* method, const CurveView<Scalar>& curve, const Scalar* t, std::size_t count, Scalar* out) {
  c::Prepared<Scalar>(c::evaluator(method, curve), curve, count).evaluate(t, count, out);
}

}  // namespace

struct bb_prepared {
  c::Prepared<double> curve;
};

int bb_evaluate(const char* method, int dimension, int degree, const double* points, const double* t, std::size_t count,
                double* out) {
  const bb_curve curve{BB_BERNSTEIN, dimension, degree, points, nullptr};
  return bb_curve_evaluate(method, &curve, t, count, out);
}

int bb_evaluate_float(const char* method, int dimension, int degree, const float* points, const float* t,
                      std::size_t count, float* out) {
  return c::guarded([&] { evaluate(method, c::bezier_curve(dimension, degree, points), t, count, out); });
}

int bb_curve_evaluate(const char* method, const bb_curve* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    if (c::has_more_axes(curve))
      return c::by_axes(*curve, count, out, [&](const bb_curve& part, double* of_part) {
        return bb_curve_evaluate(method, &part, t, count, of_part);
      });
    evaluate(method, c::curve_of(curve), t, count, out);
  });
}

int bb_prepare(const char* method, const bb_curve* curve, bb_prepared** result) {
  return c::guarded([&] {
    c::require_pointers(result);
    const auto view = c::curve_of(curve);
    *result = new bb_prepared{{c::evaluator(method, view), view, std::numeric_limits<std::size_t>::max()}};
  });
}

int bb_prepared_evaluate(const bb_prepared* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    c::require_pointers(curve);
    curve->curve.evaluate(t, count, out);
  });
}

void bb_prepared_free(bb_prepared* curve) { delete curve; }

const char* bb_recommended(int form, int degree, int is_float) {
  if (form < BB_BERNSTEIN || form > BB_RATIONAL || degree < 0 || degree > max_degree) return nullptr;
  const Form of = form == BB_POWER ? Form::power : form == BB_RATIONAL ? Form::rational : Form::bernstein;
  return is_float != 0 ? c::recommended_id<float>(of, degree) : c::recommended_id<double>(of, degree);
}
