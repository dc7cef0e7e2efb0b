// SPDX-License-Identifier: MIT
// Piecewise cubics near points, and through points.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "bindings/c/curve.hpp"
#include "core/fit/kernel.hpp"
#include "core/interpolate/spline.hpp"
#include "reference/companion/polyline_departure.hpp"

using namespace bezierbench;

struct bb_fitted {
  int dimension;
  std::vector<double> data;
  Fit fit;
};

namespace {

std::size_t values_of(int dimension, std::size_t count) {
  const auto d = static_cast<std::size_t>(dimension);
  c::require(count <= std::numeric_limits<std::size_t>::max() / d / sizeof(double), BB_ERROR_MEMORY);
  return count * d;
}

const FittingKernel& chosen(const char* method, int dimension) {
  c::require_pointers(method);
  for (const auto& kernel : fitting_kernels(dimension))
    if (kernel.info->id == method) return kernel;
  throw c::Refused{BB_ERROR_METHOD};
}

/// The direction at `values`, none for null. Throws Refused for the zero vector.
std::span<const double> direction_of(const double* values, int dimension) {
  if (values == nullptr) return {};
  const auto direction = c::finite_values(values, static_cast<std::size_t>(dimension));
  c::require(std::ranges::any_of(direction, [](double x) { return x != 0; }), BB_ERROR_PARAMETER);
  return direction;
}

}  // namespace

int bb_fit(const char* method, int dimension, const double* points, std::size_t count, double tolerance,
           bb_fitted** fitted) {
  return bb_fit_directed(method, dimension, points, count, tolerance, nullptr, nullptr, fitted);
}

int bb_fit_directed(const char* method, int dimension, const double* points, std::size_t count, double tolerance,
                    const double* start, const double* end, bb_fitted** fitted) {
  return c::guarded([&] {
    c::require(dimension >= 1 && dimension <= c::max_dimension, BB_ERROR_DIMENSION);
    const auto& kernel = chosen(method, dimension);
    c::require(count >= 2, BB_ERROR_COUNT);
    const auto data = c::finite_values(points, values_of(dimension, count));
    c::require(std::isfinite(tolerance) && tolerance >= 0, BB_ERROR_TOLERANCE);
    c::require_pointers(fitted);
    auto fit = kernel.fit(data, tolerance, {direction_of(start, dimension), direction_of(end, dimension)});
    c::require(fit.converged, BB_ERROR_OVERFLOW);
    *fitted = new bb_fitted{dimension, {data.begin(), data.end()}, std::move(fit)};
  });
}

std::size_t bb_fitted_segments(const bb_fitted* fitted) {
  return fitted == nullptr ? 0 : static_cast<std::size_t>(fitted->fit.segments(fitted->dimension));
}

const double* bb_fitted_points(const bb_fitted* fitted) {
  return fitted == nullptr ? nullptr : fitted->fit.control_points.data();
}

double bb_fitted_max_error(const bb_fitted* fitted) {
  return fitted == nullptr ? std::numeric_limits<double>::quiet_NaN() : fitted->fit.max_error;
}

int bb_fitted_exact_error(const bb_fitted* fitted, double* error) {
  return c::guarded([&] {
    c::require_pointers(fitted, error);
    std::vector<reference::NearPlace> places;
    for (std::size_t i = 0; i < fitted->fit.t.size(); ++i) places.push_back({fitted->fit.segment[i], fitted->fit.t[i]});
    const auto squared =
        reference::largest_squared_distance(fitted->dimension, fitted->data, fitted->fit.control_points, places);
    *error = reference::square_root(reference::binary64, squared);
  });
}

void bb_fitted_free(bb_fitted* fitted) { delete fitted; }

// Splines through points.

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
