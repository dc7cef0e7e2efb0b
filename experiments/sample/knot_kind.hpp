// SPDX-License-Identifier: MIT
// Kinds of knots for B-spline curves. A curve of degree m depends in one knot span on 2m knots, the span being that
// between the m-th and the next. Each kind makes them by arithmetic without libm, so that no bit depends on the
// machine.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "experiments/sample/words.hpp"

namespace bezierbench::sample {

struct KnotKind {
  /// Where two neighbouring knots lie.
  enum class Place { before_span, span, after_span };

  std::string_view id;
  std::string_view what;
  double (*first)(double drawn);                  ///< the knot with which the span begins
  double (*distance)(Place place, double drawn);  ///< of two neighbours; positive for the span itself
};

/// All kinds.
std::span<const KnotKind> knot_kinds();

/// The 2m knots for degree m >= 1, ascending. Draws one number in [0, 1] for the knot with which the span begins, then
/// one for each distance, in ascending order of the knots. Each takes two words.
std::vector<double> draw_knots(const KnotKind& kind, int degree, Words& words);

}  // namespace bezierbench::sample
