// SPDX-License-Identifier: MIT
// The easing curves of curve sets.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "core/curve_view.hpp"
#include "core/easing/kernel.hpp"
#include "experiments/suite/fault.hpp"

namespace bezierbench::studies {

/// The curve `id` of a set of the study. Throws Failure(usage) unless it is a plane cubic from (0, 0) to (1, 1) with inner
/// x in [0, 1].
inline EasingCurve<double> easing_curve_of(const suite::Study& study, std::string_view id,
                                           const CurveView<double>& curve) {
  if (curve.form == Form::bernstein && curve.dimension == 2 && curve.degree == 3) {
    const EasingCurve<double> easing{curve(0, 1), curve(1, 1), curve(0, 2), curve(1, 2)};
    const bool has_ends = curve(0, 0) == 0 && curve(1, 0) == 0 && curve(0, 3) == 1 && curve(1, 3) == 1;
    if (has_ends && is_easing(easing)) return easing;
  }
  suite::refuse(study,
                {"curves", 0, "kind",
                 fmt::format("{} is not a cubic from (0, 0) to (1, 1) with x1 and x2 in [0, 1]; leave it out", id)});
}

}  // namespace bezierbench::studies
