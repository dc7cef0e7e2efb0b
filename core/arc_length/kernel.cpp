// SPDX-License-Identifier: MIT
#include "core/arc_length/kernel.hpp"

#include <algorithm>
#include <cmath>

#include "core/arc_length/roster.hpp"
#include "core/derivative/hodograph.hpp"
#include "core/evaluate/kernel_of.hpp"
#include "core/kernel_tables.hpp"

namespace bezierbench {
namespace {

template <int Dimension>
using Hodograph = Curve<Form::bernstein, double, Dimension>;

/// The control points of h over [from, to] by de Casteljau's algorithm, twice: cut at `to`, then at from / to.
template <int Dimension>
void restrict_to(Hodograph<Dimension>& h, double from, double to) {
  const int m = h.degree();
  const auto cut = [&](double t, bool keep_left) {
    auto kept = h;
    for (int level = 0; level <= m; ++level) {
      for (int axis = 0; axis < Dimension; ++axis) {
        const int i = keep_left ? level : m - level;
        kept(axis, i) = h(axis, keep_left ? 0 : i);
      }
      for (int i = 0; i < m - level; ++i)
        for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (1 - t) * h(axis, i) + t * h(axis, i + 1);
    }
    h = kept;
  };
  if (to < 1) cut(to, true);
  if (from > 0) cut(from / to, false);
}

/// Scales h by a power of two such that its largest coordinate is in [1/2, 1); returns the exponent that was taken out.
/// 0 stays 0.
template <int Dimension>
int normalise(Hodograph<Dimension>& h) {
  double largest = 0;
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) largest = std::max(largest, std::abs(h(axis, i)));
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = std::ldexp(h(axis, i), -exponent);
  return exponent;
}

/// True where all control vectors are 0: a point has no length, and that is known without a method.
template <int Dimension>
bool is_zero(const Hodograph<Dimension>& h) {
  for (int i = 0; i <= h.degree(); ++i)
    for (int axis = 0; axis < Dimension; ++axis)
      if (h(axis, i) != 0) return false;
  return true;
}

template <ArcLengthMethod M, int Dimension>
ArcLength measure(const CurveView<double>& view, double from, double to, double tolerance) {
  auto curve = instantiate::load<Form::bernstein, Dimension>(view);
  int exponent = normalise(curve);  // or else differences may overflow
  auto h = hodograph(curve, 1);
  restrict_to(h, from, to);
  exponent += normalise(h);
  if (is_zero(h) || from == to) return {.length = 0, .error_estimate = 0, .evaluations = 0, .converged = true};
  ArcLength result = M::measure(h, tolerance);
  result.length = std::ldexp(result.length * (to - from), exponent);
  result.error_estimate = std::ldexp(result.error_estimate * (to - from), exponent);
  return result;
}

struct Entry {
  template <ArcLengthMethod M, int Dimension>
  static constexpr ArcLengthKernel of() {
    return {&M::info, Dimension, measure<M, Dimension>};
  }
};

}  // namespace

std::span<const ArcLengthKernel> arc_length_kernels(int dimension) {
  return kernels_of<ArcLengthKernel, Entry>(ArcLengthMethods{}, dimension);
}

std::span<const MethodInfo* const> arc_length_infos() { return infos_of(ArcLengthMethods{}); }

}  // namespace bezierbench
