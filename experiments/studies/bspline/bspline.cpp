// SPDX-License-Identifier: MIT
// Studies of kind `bspline`: random B-spline curves in one knot span, over every kind of knots in sample::knot_kinds();
// the point at a random t of the span is judged against the exact one and, of methods that make the Bernstein form of
// the span, every control point and weight of it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/studies/bspline/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "reference/companion/bspline_control_points.hpp"
#include "reference/error/norm.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::studies {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The parameter at the part `v` of the span from a to c, within it.
double parameter_in(double a, double c, double v) { return v < 1 ? std::clamp(a + v * (c - a), a, c) : c; }

/// Weights for every point that is judged.
std::vector<reference::ExactBsplineWeights> exact_weights(const BsplineProblem::Drawn& drawn) {
  std::vector<reference::ExactBsplineWeights> all{reference::ExactBsplineWeights::at(drawn.knots, drawn.t)};
  for (int k = 0; k <= drawn.span.degree; ++k)
    all.push_back(reference::ExactBsplineWeights::of_control_point(drawn.knots, k));
  return all;
}

/// The bound of number or point `k` of an answer, with Euclidean norms as magnitudes; infinite where none is proved.
double bound_of(const BsplineKernel& method, const BsplineProblem::Drawn& drawn, std::size_t k) {
  if (method.bound == nullptr) return infinite;
  const auto& part = k == 0 ? method.bound->point : *method.bound->control;
  const auto& arithmetic = reference::double_arithmetic;
  const metric::BsplineSizes sizes{drawn.span.degree, drawn.span.dimension, drawn.p_tilde[k], drawn.largest};
  if (drawn.weight_sizes.empty()) return metric::bound_at(part, sizes, arithmetic);
  if (k < drawn.weight_sizes.size()) return metric::bound_at(part, sizes, drawn.weight_sizes[k], arithmetic);
  return metric::bound_at(part, {drawn.span.degree, 1, drawn.p_tilde[k], drawn.weight_sizes.front().largest},
                          arithmetic);
}

double in_bound_units(double error, double p_tilde) {
  return error == 0 ? 0 : error / p_tilde / reference::double_arithmetic.unit_roundoff;
}

/// The points and weights in an answer.
std::size_t count_in(const BsplineProblem::Drawn& drawn, const BsplineProblem::Answer& answer) {
  return answer.size() == static_cast<std::size_t>(drawn.span.dimension) ? 1 : drawn.truth.size();
}

double error_of(const BsplineProblem::Drawn& drawn, const BsplineProblem::Answer& answer, std::size_t k) {
  const auto d = static_cast<std::size_t>(drawn.span.dimension);
  const auto points = static_cast<std::size_t>(drawn.span.degree) + 2;
  const auto all = std::span(answer);
  return drawn.distances[k].to(k < points ? all.subspan(k * d, d) : all.subspan(points * d + k - points, 1));
}

}  // namespace

BsplineProblem::BsplineProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
    : cell_(part.cell),
      sampler_(seed, study.id, part.cell),
      knots_(part.values.knots.empty()
                 ? sample::knot_kinds().front()
                 : *std::ranges::find(sample::knot_kinds(), part.values.knots, &sample::KnotKind::id)),
      seed_(seed),
      knots_key_(sample::key(study.id + " knots")) {}

void BsplineProblem::draw(std::uint64_t number, Drawn& drawn) const {
  sampler_.draw(number, drawn.trial);
  sample::Words words(seed_, knots_key_, sample::key(cell_), number);
  drawn.knots = sample::draw_knots(knots_, cell_.degree, words);
  drawn.span = {cell_.dimension, cell_.degree, drawn.knots, drawn.trial.coefficients, drawn.trial.weights};
  const auto n = static_cast<std::size_t>(cell_.degree);
  drawn.t = parameter_in(drawn.knots[n - 1], drawn.knots[n], drawn.trial.t);

  std::vector<double> norms;
  const auto d = static_cast<std::size_t>(cell_.dimension);
  for (std::size_t i = 0; i <= n; ++i)
    norms.push_back(reference::norm<double>(
        cell_.dimension, [&](int axis) { return drawn.trial.coefficients[i * d + static_cast<std::size_t>(axis)]; }));
  drawn.largest = std::ranges::max(norms);
  drawn.truth.clear();
  drawn.distances.clear();
  drawn.p_tilde.clear();
  drawn.weight_sizes.clear();
  const auto nearest = [](const reference::ExactPoint& value) {
    return reference::round_to(reference::binary64, value.coordinate(0));
  };
  const auto basis = exact_weights(drawn);
  const auto& w = drawn.span.weights;
  for (const auto& at : basis) {
    const auto rational = w.empty() ? at : at.with(w);
    drawn.truth.push_back(rational.sum(cell_.dimension, drawn.trial.coefficients));
    drawn.p_tilde.push_back(nearest(rational.sum(1, norms)));
  }
  if (!w.empty()) {
    double largest_product = 0;
    for (std::size_t i = 0; i <= n; ++i) largest_product = std::max(largest_product, w[i] * norms[i]);
    for (const auto& at : basis)
      drawn.weight_sizes.push_back({nearest(at.sum(1, w)), std::ranges::max(w), largest_product});
    for (std::size_t k = 1; k < basis.size(); ++k) {
      drawn.truth.push_back(basis[k].sum(1, w));
      drawn.p_tilde.push_back(drawn.weight_sizes[k].sum);
    }
  }
  for (const auto& point : drawn.truth) drawn.distances.emplace_back(point);
}

void BsplineProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer,
                           std::uint64_t number, Errors& errors) {
  if (!reference::all_finite(answer)) {
    ++errors.non_finite;
    if (std::isfinite(bound_of(method, drawn, 0))) errors.violations.add(number);
    return;
  }
  bool violated = false;
  for (std::size_t k = 0; k < count_in(drawn, answer); ++k) {
    const double error = error_of(drawn, answer, k);
    const double bound = bound_of(method, drawn, k);
    if (k == 0) errors.error.add(error);
    metric::add_rounded(in_bound_units(error, drawn.p_tilde[k]), k == 0 ? errors.error_u : errors.control_error_u);
    const double bound_u = in_bound_units(bound, drawn.p_tilde[k]);
    if (std::isfinite(bound_u)) (k == 0 ? errors.bound_u : errors.control_bound_u).add(bound_u);
    violated = violated || reference::TrialScale::violates(error, bound);
  }
  if (std::isfinite(bound_of(method, drawn, 0))) ++errors.bounded;
  if (violated) errors.violations.add(number);
}

bool BsplineProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
  for (std::size_t k = 0; k < count_in(drawn, answer); ++k) {
    const double error = error_of(drawn, answer, k);
    const bool near_enough = method.bound != nullptr
                                 ? !reference::TrialScale::violates(error, bound_of(method, drawn, k))
                                 : in_bound_units(error, drawn.p_tilde[k]) <= judge::half_of_the_digits;
    if (!std::isfinite(error) || !near_enough) return false;
  }
  return true;
}

extern constexpr StudyKind bspline_kind = companion_kind<BsplineProblem>(
    {.id = "bspline",
     .about = "errors of points and Bernstein control points of a knot span of a B-spline curve",
     .own = {},
     .methods_example = "[\"de_boor\"]",
     .inputs = {.forms = suite::forms_with_control_points,
                .forms_reason = "B-spline curves have control points",
                .double_only = true,
                .least_degree = 1,
                .least_degree_reason = "B-spline curves of degree 0 are not continuous",
                .parameters = suite::Parameters::from_0_to_1,
                .parameters_reason = "the part of the knot span in which parameters lie",
                .sets = suite::SetUse::none,
                .sets_reason = "knots are drawn with the control points",
                .independent_points = true}});

}  // namespace bezierbench::studies
