// SPDX-License-Identifier: MIT
// Studies of kind `projection`: points, placed in every way in sample::placements(), projected onto random curves,
// polynomial or rational, judged against the exact foot point. Writes projection.csv, and projection_unstable.csv for methods
// that are not bit-stable.

#include <algorithm>
#include <cmath>

#include "experiments/judge/methods.hpp"
#include "experiments/studies/projection/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"

namespace bezierbench::studies {
namespace {

/// |t - t*| for the t* closest to t among the foot points whose distance is the least, up to a factor of 1 + 2^-40.
double t_error(double t, const reference::ExactProjection& exact) {
  constexpr double tie = 1 + 0x1p-40;
  const auto distance = [](const reference::CriticalPoint& point) {
    return reference::square_root(reference::binary64, point.distance_squared);
  };
  const double least = distance(exact.foot());
  double error = 1;
  for (const auto& critical : exact.critical)
    if (distance(critical) <= least * tie)
      error = std::min(error, reference::round_to(reference::error_format, abs(reference::exactly(t) - critical.t)));
  return error;
}

CurveView<double> curve_of(const sample::ProjectionCase& placed) {
  return {placed.weights.empty() ? Form::bernstein : Form::rational, placed.dimension, placed.degree, placed.points,
          placed.weights};
}

}  // namespace

ProjectionProblem::ProjectionProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
    : cell_(part.cell),
      placement_(part.values.placement.empty()
                     ? sample::placements().front()
                     : *std::ranges::find(sample::placements(), part.values.placement, &sample::Placement::id)),
      sampler_(seed, study.id, sample::with_point(part.cell)) {}

void ProjectionProblem::draw(std::uint64_t number, Drawn& drawn) const {
  drawn.placed = sample::place(placement_, sampler_, cell_, number);
  drawn.exact = reference::projection(curve_of(drawn.placed), drawn.placed.point);
}

void ProjectionProblem::ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& foot) {
  foot = method.project(curve_of(drawn.placed), drawn.placed.point);
}

void ProjectionProblem::give(const Drawn& drawn, double /*tolerance*/, external::Batch& batch) {
  batch.add(curve_of(drawn.placed), drawn.placed.point);
}

void ProjectionProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& foot,
                              std::uint64_t number, Errors& errors) {
  errors.candidates.add(static_cast<std::uint64_t>(foot.candidates));
  errors.non_converged += foot.converged ? 0 : 1;
  if (!std::isfinite(foot.distance) || !std::isfinite(foot.t)) {
    ++errors.non_finite;
    return;
  }
  const double error = reference::foot_error(reference::error_format, foot.t, foot.distance, drawn.exact);
  const double largest = sample::largest_coordinate(drawn.placed);
  errors.error.add(error);
  errors.error_unit.add(error == 0 ? 0 : metric::to_24_bits(error / largest * 0x1p+52));
  errors.t_error.add(t_error(foot.t, drawn.exact));
  errors.missed += error > missed_tolerance * largest ? 1 : 0;
  if (!drawn.placed.weights.empty()) return;
  const double residual = reference::foot_residual(foot.t, drawn.exact);
  errors.residual.add(residual);
  if (method.residual_bound != nullptr && foot.converged &&
      residual > method.residual_bound(drawn.placed.degree, drawn.placed.dimension))
    errors.broken_promises.add(number);
}

bool ProjectionProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double /*tolerance*/,
                                 const Answer& foot) {
  return reference::foot_error(reference::error_format, foot.t, foot.distance, drawn.exact) <=
         missed_tolerance * sample::largest_coordinate(drawn.placed);
}

extern constexpr StudyKind projection_kind = companion_kind<ProjectionProblem>(
    {.id = "projection",
     .about = "errors of foot points, and feet that are missed",
     .own = {},
     .methods_example = "[\"quintic_isolate\"]",
     .inputs = {.forms = suite::forms_with_control_points,
                .forms_reason = "foot points are sought on curves with control points",
                .double_only = true,
                .independent_points = true}});

}  // namespace bezierbench::studies
