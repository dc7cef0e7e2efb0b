// SPDX-License-Identifier: MIT
// Splines through points.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "bindings/c/curve.hpp"
#include "core/interpolate/knot_steps.hpp"
#include "core/interpolate/spline.hpp"

using namespace bezierbench;

namespace {

static_assert(static_cast<int>(Parameters::centripetal) == BB_CENTRIPETAL);
static_assert(static_cast<int>(Parameters::uniform) == BB_UNIFORM);
static_assert(static_cast<int>(Parameters::chord) == BB_CHORD);

/// What `spline` says of the ends of points of this dimension. Throws Refused for what it cannot say.
SplineConditions conditions_of(const bb_spline& spline, int dimension) {
  SplineConditions conditions;
  conditions.monotone = spline.monotone != 0;
  switch (spline.ends) {
    case BB_NATURAL: return conditions;
    case BB_NOT_A_KNOT: conditions.ends = SplineEnds::not_a_knot; return conditions;
    case BB_CLOSED: conditions.closed = true; return conditions;
    case BB_CLAMPED: {
      const auto d = static_cast<std::size_t>(dimension);
      conditions.ends = SplineEnds::clamped;
      conditions.start_derivative = c::finite_values(spline.start_derivative, d);
      conditions.end_derivative = c::finite_values(spline.end_derivative, d);
      return conditions;
    }
    default: throw c::Refused{BB_ERROR_PARAMETER};
  }
}

}  // namespace

int bb_interpolate(const bb_spline* spline, int dimension, const double* points, std::size_t count, double* segments) {
  return c::guarded([&] {
    c::require(dimension >= 1 && dimension <= c::max_dimension, BB_ERROR_DIMENSION);
    const bb_spline given = spline == nullptr ? bb_spline{} : *spline;
    c::require(given.parameters >= 0 && given.parameters < static_cast<int>(parameters_names.size()),
               BB_ERROR_PARAMETER);
    const auto conditions = conditions_of(given, dimension);
    c::require(count >= 2, BB_ERROR_COUNT);
    const auto d = static_cast<std::size_t>(dimension);
    c::require(count <= std::numeric_limits<std::size_t>::max() / d / (4 * sizeof(double)), BB_ERROR_MEMORY);
    const auto values = c::finite_values(points, count * d);
    c::require_pointers(segments);
    const auto steps = knot_steps(values, dimension, static_cast<Parameters>(given.parameters), conditions.closed);
    c::require(std::ranges::find(steps, 0.0) == steps.end(), BB_ERROR_REPEATED);
    const auto found = spline_segments(values, dimension, steps, conditions);
    c::require(std::ranges::all_of(found, [](double x) { return std::isfinite(x); }), BB_ERROR_OVERFLOW);
    std::ranges::copy(found, segments);
  });
}
