// SPDX-License-Identifier: MIT
// The part of a curve in Bernstein form over an interval of its parameter.
#pragma once

#include "core/curve.hpp"

namespace bezierbench {

/// The control points of h over [from, to] by de Casteljau's algorithm, twice: cut at `to`, then at from / to. Exact
/// but for rounding; beyond [0, 1] it continues the polynomial, and roundings grow. `to` is not 0 unless `from` is.
template <int Dimension>
void restrict_to(Curve<Form::bernstein, double, Dimension>& h, double from, double to) {
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
  if (to != 1) cut(to, true);
  if (from != 0) cut(from / to, false);
}

}  // namespace bezierbench
