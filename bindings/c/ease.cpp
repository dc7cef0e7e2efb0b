// SPDX-License-Identifier: MIT
// Easing curves: y for x by a method, and the true y.
#include "bindings/c/curve.hpp"
#include "core/easing/kernel.hpp"
#include "core/easing/roster.hpp"
#include "reference/companion/easing.hpp"

using namespace bezierbench;

namespace {

template <class Scalar>
EasingCurve<Scalar> easing_of(const Scalar* bezier) {
  const auto values = c::finite_values(bezier, 4);
  const EasingCurve<Scalar> curve{values[0], values[1], values[2], values[3]};
  c::require(is_easing(curve), BB_ERROR_PARAMETER);
  return curve;
}

/// The method of this id; for a null id the correctly rounded one.
const EasingKernel& method_of(const char* id) {
  const std::string_view wanted = id != nullptr ? id : EasingCorrectlyRounded::info.id;
  for (const auto& kernel : easing_kernels())
    if (kernel.info->id == wanted) return kernel;
  throw c::Refused{BB_ERROR_METHOD};
}

template <class Scalar>
int ease_each(const char* method, const Scalar* bezier, const Scalar* x, std::size_t count, Scalar* y) {
  return c::guarded([&] {
    const auto curve = easing_of(bezier);
    const auto& kernel = method_of(method);
    const auto at = c::finite_values(x, count);
    if (count == 0) return;
    c::require_pointers(y);
    constexpr std::size_t at_once = 64;
    std::array<Eased<Scalar>, at_once> eased;
    for (std::size_t first = 0; first < count; first += at_once) {
      const auto part = at.subspan(first, std::min(at_once, count - first));
      kernel(curve, part, eased.data());
      for (std::size_t k = 0; k < part.size(); ++k) y[first + k] = eased[k].y;
    }
  });
}

}  // namespace

int bb_ease(const char* method, const double* bezier, const double* x, std::size_t count, double* y) {
  return ease_each(method, bezier, x, count, y);
}

int bb_ease_float(const char* method, const float* bezier, const float* x, std::size_t count, float* y) {
  return ease_each(method, bezier, x, count, y);
}

int bb_exact_ease(const double* bezier, const double* x, std::size_t count, double* y) {
  return c::guarded([&] {
    const auto curve = easing_of(bezier);
    const auto at = c::finite_values(x, count);
    if (count == 0) return;
    c::require_pointers(y);
    for (std::size_t k = 0; k < count; ++k)
      y[k] = reference::ExactEased(curve.x1, curve.y1, curve.x2, curve.y2, at[k]).nearest(reference::binary64);
  });
}
