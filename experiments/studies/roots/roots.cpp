// SPDX-License-Identifier: MIT
// Studies of kind `roots`: where the coordinates of curves have a value, judged against all roots, isolated exactly.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/roots/subdivision.hpp"
#include "experiments/studies/roots/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_odd(const reference::Root& root) { return root.multiplicity % 2 != 0; }

/// p~ / |p'| of a simple root. p~ is that of the differences of coefficients and value.
double condition_of(const RootsProblem::Drawn& drawn, int axis, const reference::Root& root) {
  if (root.multiplicity > 1) return infinity;
  std::vector<double> magnitudes;
  for (int i = 0; i <= drawn.curve.degree; ++i)
    magnitudes.push_back(std::abs(drawn.curve(axis, i) - drawn.value[static_cast<std::size_t>(axis)]));
  reference::ExactCurve exact;
  const double slope =
      reference::round_to(reference::binary64, exact.derivative(drawn.curve, 1, root.t).coordinate(axis));
  return bernstein_value(std::move(magnitudes), root.t) / std::abs(slope);
}

}  // namespace

MatchedRoots matched(const std::vector<reference::Root>& roots, const std::vector<double>& answers) {
  MatchedRoots result{std::vector<double>(roots.size(), infinity), {}};
  for (const double t : answers) {
    const auto distance = [&](const reference::Root& root) { return std::abs(root.t - t); };
    const auto nearest = std::ranges::min_element(roots, {}, distance);
    if (nearest == roots.end() || !(distance(*nearest) <= root_within)) {
      result.root_of.push_back(roots.size());
      ++result.spurious;
      continue;
    }
    result.root_of.push_back(static_cast<std::size_t>(nearest - roots.begin()));
    double& error = result.error[result.root_of.back()];
    result.spurious += error < infinity ? 1 : 0;
    error = std::min(error, distance(*nearest));
  }
  return result;
}

bool keeps_enclosures(const std::vector<reference::Root>& roots, const std::vector<RootEnclosure>& enclosures) {
  const auto all_certain = std::ranges::all_of(enclosures, &RootEnclosure::certain);
  if (all_certain && roots.size() != enclosures.size()) return false;
  const bool all_enclosed = std::ranges::all_of(roots, [&](const reference::Root& root) {
    return std::ranges::any_of(enclosures, [&](const auto& one) { return one.low <= root.t && root.t <= one.high; });
  });
  return all_enclosed && std::ranges::all_of(enclosures, [&](const RootEnclosure& one) {
           const auto inside = [&](const auto& root) { return one.low < root.t && root.t < one.high; };
           const auto within = [&](const auto& root) { return one.low <= root.t && root.t <= one.high; };
           return !one.certain ||
                  (std::ranges::count_if(roots, inside) <= 1 && std::ranges::count_if(roots, within) >= 1);
         });
}

void RootsProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  drawn.value.clear();
  for (int axis = 0; axis < drawn.curve.dimension; ++axis) {
    double low = drawn.curve(axis, 0);
    double high = low;
    for (int i = 1; i <= drawn.curve.degree; ++i) {
      low = std::min(low, drawn.curve(axis, i));
      high = std::max(high, drawn.curve(axis, i));
    }
    drawn.value.push_back(of_sets_ ? low / 2 + high / 2 : 0);
  }
  find_truth(drawn);
}

void RootsProblem::find_truth(Drawn& drawn) {
  drawn.truth.clear();
  drawn.condition.clear();
  for (int axis = 0; axis < drawn.curve.dimension; ++axis) {
    const auto& truth = drawn.truth.emplace_back(
        reference::roots_of_value(drawn.curve, axis, drawn.value[static_cast<std::size_t>(axis)]));
    auto& condition = drawn.condition.emplace_back();
    for (const auto& root : truth.roots) condition.push_back(condition_of(drawn, axis, root));
  }
}

void RootsProblem::ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& found) {
  found.clear();
  for (int axis = 0; axis < drawn.curve.dimension; ++axis)
    found.push_back(method.find(drawn.curve, axis, drawn.value[static_cast<std::size_t>(axis)]));
}

std::vector<std::span<double>> RootsProblem::numbers(Answer& found) {
  std::vector<std::span<double>> all;
  for (auto& one : found) all.emplace_back(one.t);
  return all;
}

void RootsProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& found,
                         std::uint64_t number, Errors& errors) {
  bool broken = false;
  for (std::size_t axis = 0; axis < found.size(); ++axis) {
    if (drawn.truth[axis].everywhere) continue;
    const auto& roots = drawn.truth[axis].roots;
    const auto& answer = found[axis];
    const auto match = matched(roots, answer.t);
    const auto& error = match.error;
    ++errors.polynomials;
    errors.roots += roots.size();
    errors.spurious += match.spurious;
    errors.right_count += answer.t.size() == roots.size() ? 1 : 0;
    errors.right_odd_count += std::ranges::count_if(roots, is_odd) == std::ssize(answer.t) ? 1 : 0;
    errors.evaluations += static_cast<std::uint64_t>(answer.evaluations);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      if (error[k] == infinity) {
        ++errors.missed;
        errors.missed_odd += is_odd(roots[k]) ? 1 : 0;
        continue;
      }
      constexpr double u = 0x1p-53;
      errors.error.add(error[k]);
      if (roots[k].multiplicity > 1) continue;
      errors.simple_error.add(error[k]);
      errors.error_condition.add(metric::to_24_bits(error[k] / u / std::max(1.0, drawn.condition[axis][k])));
    }
    errors.uncertain +=
        static_cast<std::uint64_t>(std::ranges::count(answer.enclosures, false, &RootEnclosure::certain));
    broken = broken || (!method.info->promise.empty() && !keeps_enclosures(roots, answer.enclosures));
  }
  if (broken) errors.broken.add(number);
}

bool RootsProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double /*tolerance*/, const Answer& found) {
  for (std::size_t axis = 0; axis < found.size(); ++axis) {
    const auto& roots = drawn.truth[axis].roots;
    const auto error = matched(roots, found[axis].t).error;
    for (std::size_t k = 0; k < roots.size(); ++k)
      if (is_odd(roots[k]) && error[k] == infinity) return false;
  }
  return true;
}

extern constexpr StudyKind roots_kind =
    companion_kind<RootsProblem>({.id = "roots",
                                  .about = "roots of the coordinates of curves: missed, spurious, and their errors",
                                  .own = {},
                                  .methods_example = "[\"lane_riesenfeld\"]",
                                  .inputs = {.forms = suite::bernstein_form,
                                             .forms_reason = "the methods start from Bernstein coefficients",
                                             .double_only = true,
                                             .parameters = suite::Parameters::whole,
                                             .parameters_reason = "roots are those in [0, 1]"}});

}  // namespace bezierbench::studies
