// SPDX-License-Identifier: MIT
// Studies of kind `grid`: random curves at all k/m, k = 0..m; every point is judged against the exact one.

#include "core/grid/grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "experiments/metric/derivative_scale.hpp"
#include "experiments/studies/grid/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::studies {
namespace {

/// Calls judge(k, error, bound, scale) for every point, with the bound infinite where none is proved, until one returns
/// false.
template <class Judge>
bool each_point(const GridKernel& method, const GridProblem::Drawn& drawn, const GridProblem::Answer& answer,
                Judge judge) {
  const auto d = static_cast<std::size_t>(drawn.curve.dimension);
  const int steps = static_cast<int>(drawn.truth.size()) - 1;
  reference::TrialScale scale;
  for (int k = 0; k <= steps; ++k) {
    const auto place = static_cast<std::size_t>(k);
    const double error = drawn.distances[place].to(std::span(answer).subspan(place * d, d));
    scale.set(drawn.curve, static_cast<double>(k) / steps);
    const double bound =
        scale.bound(metric::bound_at(*method.bound, drawn.curve.degree, k, steps, reference::double_arithmetic),
                    reference::double_arithmetic);
    if (!judge(k, error, bound, scale)) return false;
  }
  return true;
}

}  // namespace

std::size_t GridProblem::timed_trials(const judge::TrialPart& part) {
  return static_cast<std::size_t>(std::clamp(16384 / *part.values.points, 1, 256));
}

GridProblem::GridProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
    : curves_(study, seed, part.cell), steps_(*part.values.points - 1) {
  if (!is_grid(steps_)) suite::refuse(study, {"points", 0, {}, "points of a grid must be a power of two and one"});
}

void GridProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.truth.clear();
  drawn.distances.clear();
  for (int k = 0; k <= steps_; ++k)
    drawn.truth.push_back(drawn.exact.point(drawn.curve, static_cast<double>(k) / steps_));
  for (const auto& point : drawn.truth) drawn.distances.emplace_back(point);
}

void GridProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                        std::uint64_t number, Errors& errors) {
  if (!reference::all_finite(answer)) {
    ++errors.non_finite;
    const auto unproved = [](int /*k*/, double error, double bound, reference::TrialScale& /*scale*/) {
      return std::isfinite(error) || !std::isfinite(bound);
    };
    if (!each_point(method, drawn, answer, unproved)) errors.violations.add(number);
    return;
  }
  bool violated = false;
  const int steps = static_cast<int>(drawn.truth.size()) - 1;
  each_point(method, drawn, answer, [&](int k, double error, double bound, reference::TrialScale& scale) {
    errors.error.add(error);
    const double error_u = scale.in_bound_units(error, reference::double_arithmetic);
    metric::add_rounded(error_u, errors.error_u);
    if (k == steps) metric::add_rounded(error_u, errors.last_error_u);
    if (!std::isfinite(bound)) return true;
    ++errors.bounded;
    const double bound_u = scale.in_bound_units(bound, reference::double_arithmetic);
    if (std::isfinite(bound_u)) errors.bound_u.add(bound_u);
    violated = violated || reference::TrialScale::violates(error, bound);
    return true;
  });
  if (violated) errors.violations.add(number);
}

bool GridProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
  return each_point(method, drawn, answer, [](int /*k*/, double error, double bound, reference::TrialScale& /*scale*/) {
    return std::isfinite(error) && !reference::TrialScale::violates(error, bound);
  });
}

namespace {

/// The largest power of two and one that is no more than suites take.
constexpr int most_grid_points = static_cast<int>(std::bit_floor(static_cast<unsigned>(suite::most_points - 1))) + 1;

constexpr suite::Field grid_points_key{
    .key = "points",
    .meaning = "numbers of points of the grid, each a power of two and one, 2 to 524289",
    .example = "[17, 257]",
    .required = true,
    .axis = suite::Axis::of_cases};

static_assert(most_grid_points == 524289, "the meaning of points states it");

constexpr std::array grid_fields{suite::field<&suite::Study::points>(grid_points_key)};

suite::Finding check_grid(const suite::Study& study) {
  return suite::each("points", study.points, [](int value) {
    const bool right = value >= 2 && value <= most_grid_points && std::has_single_bit(static_cast<unsigned>(value - 1));
    return right ? "" : fmt::format("points of a grid must be a power of two and one, 2 to {}", most_grid_points);
  });
}

}  // namespace

extern constexpr StudyKind grid_kind =
    companion_kind<GridProblem>({.id = "grid",
                                 .about = "errors of the points on a uniform grid",
                                 .own = grid_fields,
                                 .methods_example = "[\"forward_differencing\"]",
                                 .inputs = {.double_only = true,
                                            .parameters = suite::Parameters::whole,
                                            .parameters_reason = "grids reach from 0 to 1"},
                                 .check = check_grid});

}  // namespace bezierbench::studies
