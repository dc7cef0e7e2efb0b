// SPDX-License-Identifier: MIT
// Points by a method.
#include "bindings/c/chosen.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"

using namespace bezierbench;

struct bb_prepared {
  PreparedState<double> state;
};

namespace {

template <class Scalar>
PreparedState<Scalar> prepared(const char* method, const CurveView<Scalar>& curve) {
  return {c::evaluator(method, curve), curve};
}

template <class Scalar>
void evaluate(const PreparedState<Scalar>& curve, const Scalar* t, std::size_t count, Scalar* out) {
  const auto at = c::parameters(*curve.kernel().info, t, count);
  if (at.empty()) return;
  c::require_pointers(out);
  curve.evaluate(at, out);
}

}  // namespace

int bb_evaluate(const char* method, int dimension, int degree, const double* points, const double* t, std::size_t count,
                double* out) {
  return c::guarded([&] { evaluate(prepared(method, c::bezier_curve(dimension, degree, points)), t, count, out); });
}

int bb_evaluate_float(const char* method, int dimension, int degree, const float* points, const float* t,
                      std::size_t count, float* out) {
  return c::guarded([&] { evaluate(prepared(method, c::bezier_curve(dimension, degree, points)), t, count, out); });
}

int bb_curve_evaluate(const char* method, const bb_curve* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] { evaluate(prepared(method, c::curve_of(curve)), t, count, out); });
}

int bb_prepare(const char* method, const bb_curve* curve, bb_prepared** result) {
  return c::guarded([&] {
    c::require_pointers(result);
    *result = new bb_prepared{prepared(method, c::curve_of(curve))};
  });
}

int bb_prepared_evaluate(const bb_prepared* curve, const double* t, std::size_t count, double* out) {
  return c::guarded([&] {
    c::require_pointers(curve);
    evaluate(curve->state, t, count, out);
  });
}

void bb_prepared_free(bb_prepared* curve) { delete curve; }

const char* bb_recommended(int form, int degree, int is_float) {
  if (form < BB_BERNSTEIN || form > BB_RATIONAL || degree < 0 || degree > max_degree) return nullptr;
  const Form of = form == BB_POWER ? Form::power : form == BB_RATIONAL ? Form::rational : Form::bernstein;
  return is_float != 0 ? c::recommended_id<float>(of, degree) : c::recommended_id<double>(of, degree);
}
