// SPDX-License-Identifier: MIT
// The easing curves among cubics.
#pragma once

#include <optional>

#include "core/curve_view.hpp"
#include "core/easing/kernel.hpp"

namespace bezierbench::studies {

/// The curve, if it is a plane cubic from (0, 0) to (1, 1) with inner x in [0, 1].
inline std::optional<EasingCurve<double>> easing_curve_of(const CurveView<double>& curve) {
  if (curve.form != Form::bernstein || curve.dimension != 2 || curve.degree != 3) return std::nullopt;
  const EasingCurve<double> easing{curve(0, 1), curve(1, 1), curve(0, 2), curve(1, 2)};
  const bool has_ends = curve(0, 0) == 0 && curve(1, 0) == 0 && curve(0, 3) == 1 && curve(1, 3) == 1;
  if (!has_ends || !is_easing(easing)) return std::nullopt;
  return easing;
}

}  // namespace bezierbench::studies
