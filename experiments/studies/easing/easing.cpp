// SPDX-License-Identifier: MIT
// Studies of kind `easing`: y for x on easing curves, drawn or of sets, against the exact y. Writes easing.csv, and
// easing_unstable.csv for methods that are not bit-stable.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/studies/easing/easing_curves.hpp"
#include "experiments/studies/easing/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"

namespace bezierbench::studies {
namespace {

template <class Scalar>
void fill_trial(const EasingCurve<double>& curve, double t, std::uint64_t number, EasingTrial<Scalar>& trial) {
  using Bits = std::conditional_t<sizeof(Scalar) == sizeof(float), std::uint32_t, std::uint64_t>;
  constexpr auto parts = EasingTrial<Scalar>::parts;
  constexpr auto neighbours = EasingTrial<Scalar>::neighbours;
  trial.curve = {static_cast<Scalar>(curve.x1), static_cast<Scalar>(curve.y1), static_cast<Scalar>(curve.x2),
                 static_cast<Scalar>(curve.y2)};
  trial.x.clear();
  const auto one = std::bit_cast<Bits>(Scalar(1));
  const auto first = std::min(std::bit_cast<Bits>(static_cast<Scalar>(t)), static_cast<Bits>(one - neighbours));
  for (std::size_t k = 0; k < neighbours; ++k)
    trial.x.push_back(std::bit_cast<Scalar>(static_cast<Bits>(first + static_cast<Bits>(k))));
  for (std::size_t k = 0; k <= parts; ++k) trial.x.push_back(static_cast<Scalar>(k) / static_cast<Scalar>(parts));
  trial.on_grid = neighbours + 1 + static_cast<std::size_t>(number % (parts - 1));
  trial.outside = {-trial.x.front() - Scalar(0.5), trial.x.front() + Scalar(1.5)};
  trial.truth.clear();
  trial.truth_outside.clear();
  if (!std::isfinite(trial.curve.y1) || !std::isfinite(trial.curve.y2)) return;  // beyond the largest float
  const auto& [x1, y1, x2, y2] = trial.curve;
  for (const std::size_t k : {std::size_t{0}, trial.on_grid}) trial.truth.emplace_back(x1, y1, x2, y2, trial.x[k]);
  for (const Scalar x : trial.outside) trial.truth_outside.emplace_back(x1, y1, x2, y2, x);
}

template <class Scalar>
bool rises(const EasingCurve<Scalar>& curve) {
  return curve.y1 >= 0 && curve.y1 <= 1 && curve.y2 >= 0 && curve.y2 <= 1;
}

/// Whether y outside [0, 1] is on the lines that continue the curve, up to the roundings of two differences, their
/// quotient, the product with x or x - 1, which is exact here, and the sum.
template <class Scalar>
bool is_on_lines(const EasingKernel& method, EasingTrial<Scalar>& trial) {
  constexpr auto format = judge::ScalarFacts<Scalar>::format;
  constexpr double u = judge::ScalarFacts<Scalar>::arithmetic.unit_roundoff;
  std::array<Eased<Scalar>, 2> eased;
  method(trial.curve, std::span<const Scalar>(trial.outside), eased.data());
  for (std::size_t k = 0; k < eased.size(); ++k) {
    if (!std::isfinite(eased[k].y)) return false;
    auto& truth = trial.truth_outside[k];
    const double y = truth.nearest(format);
    const double step = std::abs(y - static_cast<double>(k));  // from the end of the curve
    constexpr double higher_orders = 1 + 0x1p-20;
    const double allowed =
        (4 * u * step + u * std::abs(y)) * higher_orders + std::ldexp(2, static_cast<int>(format.lowest_exponent));
    if (truth.error(eased[k].y) > allowed) return false;
  }
  return true;
}

template <class Scalar>
void judge_scalar(const EasingKernel& method, EasingTrial<Scalar>& trial, std::span<const Eased<Scalar>> eased,
                  std::uint64_t number, EasedErrors& errors) {
  constexpr auto format = judge::ScalarFacts<Scalar>::format;
  constexpr auto neighbours = EasingTrial<Scalar>::neighbours;
  const auto is_number = [](const Eased<Scalar>& one) { return std::isfinite(one.y); };
  if (!std::ranges::all_of(eased, is_number)) {
    ++errors.non_finite;
    if (method.is_correctly_rounded) errors.broken.add(number);
    return;
  }
  std::uint64_t misrounded = 0;
  for (std::size_t k = 0; k < trial.truth.size(); ++k) {
    auto& truth = trial.truth[k];
    const double y = eased[k == 0 ? 0 : trial.on_grid].y;
    errors.error.add(truth.error(y));
    metric::add_rounded(truth.error_ulp(y, format), errors.error_ulp);
    misrounded += truth.nearest(format) == y ? 0 : 1;
  }
  errors.misrounded += misrounded;
  const auto falls = [](std::span<const Eased<Scalar>> sequence) {
    return !std::ranges::is_sorted(sequence, {}, &Eased<Scalar>::y);
  };
  const bool is_monotone = !rises(trial.curve) || !(falls(eased.first(neighbours)) || falls(eased.subspan(neighbours)));
  if (!is_monotone) errors.non_monotone.add(number);
  const bool has_ends = eased[neighbours].y == 0 && eased.back().y == 1;
  if (!has_ends) errors.wrong_ends.add(number);
  if (!is_on_lines(method, trial)) errors.wrong_outside.add(number);
  int most = 0;
  bool converged = true;
  for (const auto& one : eased) {
    most = std::max(most, one.steps);
    converged = converged && one.converged;
  }
  errors.steps.add(static_cast<std::uint64_t>(most));
  errors.not_converged += converged ? 0 : 1;
  if (method.is_correctly_rounded && (misrounded > 0 || !is_monotone || !has_ends)) errors.broken.add(number);
}

}  // namespace

EasingProblem::EasingProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
    : curves_(study, seed, part.cell), range_(part.cell.coordinate_range) {}

void EasingProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  const int y_axis = std::min(1, drawn.curve.dimension - 1);
  const double range = std::max({range_, std::abs(drawn.curve(0, 1)), std::abs(drawn.curve(0, 2))});
  const auto share = [&](int i) { return range > 0 ? std::abs(drawn.curve(0, i)) / range : 0; };
  const auto curve =
      easing_curve_of(drawn.curve)
          .value_or(EasingCurve<double>{share(1), drawn.curve(y_axis, 1), share(2), drawn.curve(y_axis, 2)});
  fill_trial(curve, drawn.trial.t, number, drawn.in_double);
  fill_trial(curve, drawn.trial.t, number, drawn.in_float);
  drawn.nearest = drawn.in_double.truth.front().nearest(reference::binary64);
}

void EasingProblem::ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) {
  const auto& trial = drawn.in_double;
  answer.eased.resize(trial.x.size());
  answer.y.resize(trial.x.size());
  method.ease(trial.curve, trial.x, answer.eased.data());
  std::ranges::transform(answer.eased, answer.y.begin(), &Eased<double>::y);
}

void EasingProblem::judge(const Kernel& method, Drawn& drawn, double /*tolerance*/, const Answer& answer,
                          std::uint64_t number, Errors& errors) {
  errors.monotone_trials += rises(drawn.in_double.curve) ? 1 : 0;
  judge_scalar<double>(method, drawn.in_double, answer.eased, number, errors.in_double);
  if (drawn.in_float.truth.empty()) {
    ++errors.in_float.non_finite;
    return;
  }
  std::vector<Eased<float>> eased(drawn.in_float.x.size());
  method.ease_float(drawn.in_float.curve, drawn.in_float.x, eased.data());
  judge_scalar<float>(method, drawn.in_float, eased, number, errors.in_float);
}

bool EasingProblem::is_right(const Kernel& /*method*/, const Drawn& drawn, double /*tolerance*/, const Answer& answer) {
  const auto& curve = drawn.in_double.curve;
  const double size = std::max({1.0, std::abs(curve.y1), std::abs(curve.y2)});
  return std::abs(answer.y.front() - drawn.nearest) <= expected_accuracy * size;
}

extern constexpr StudyKind easing_kind =
    companion_kind<EasingProblem>({.id = "easing",
                                   .about = "y for x on easing curves, cubic-bezier() of CSS",
                                   .own = {},
                                   .methods_example = "[\"easing_halley\"]",
                                   .inputs = {.forms = suite::bernstein_form,
                                              .forms_reason = "easing curves are given by control points",
                                              .double_only = true,
                                              .parameters = suite::Parameters::from_0_to_1,
                                              .parameters_reason = "x is in [0, 1]"}});

}  // namespace bezierbench::studies
