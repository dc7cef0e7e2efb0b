// SPDX-License-Identifier: MIT
// The trials of a companion problem, for its errors and for its times: how a trial is drawn, how a method is called, and
// when its answer is accurate enough.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/method.hpp"
#include "experiments/judge/case_axes.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/sample/draw.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::judge {

/// A cell and a case of it: what one set of trials is drawn for. The tolerance of `values` is empty, because the
/// methods of a study solve the same trials for each tolerance.
struct TrialPart {
  sample::Cell cell;
  CaseValues values;
};

/// The trials of one part.
///
/// `draw` overwrites `drawn`, which may hold another trial, with trial `number` and its truth. `ask` writes the answer
/// of a method, and is what is timed; `tolerance` is 0 for a problem without one. `numbers` are the spans of doubles of
/// an answer: the answers of a timed run must have the bits of those that were judged. `timed_trials` is the number of
/// trials in a batch of the race. A problem of which one call gives several answers has their number as
/// `answers_per_call`; times are then per answer. The kind of study (suite/kind.hpp) says which inputs the problem
/// takes.
template <class P>
concept TrialProblem = std::constructible_from<P, const suite::Study&, std::uint64_t, const TrialPart&> &&
    std::default_initializable<typename P::Drawn> && std::copyable<typename P::Answer> &&
    requires(const P& trials, const typename P::Kernel& method, std::uint64_t number, const TrialPart& part,
             typename P::Drawn& drawn, const typename P::Drawn& asked, double tolerance, typename P::Answer& answer,
             const typename P::Answer& judged) {
  requires std::same_as<const Problem, decltype(P::problem)>;
  requires std::same_as<const CaseAxes, decltype(P::axes)>;
  { P::kernels(int{}) } -> std::same_as<std::span<const typename P::Kernel>>;
  { P::timed_trials(part) } -> std::same_as<std::size_t>;
  trials.draw(number, drawn);
  trials.ask(method, asked, tolerance, answer);
  { trials.is_right(method, asked, tolerance, judged) } -> std::same_as<bool>;
  P::numbers(answer);
};

/// The degree of the segments of splines and fits.
inline constexpr int segment_degree = 3;

/// The largest accepted error where no bound is proved, in u times the scale of the result: half of the digits of the
/// result are right.
inline constexpr double half_of_the_digits = 0x1p26;

/// Every cell of the study with every case, tolerances left out. Where the curves have no degree, the number of points
/// takes its place among the axes, and the cell has the degree of the segments.
std::vector<TrialPart> parts_of(const suite::Study& study, CaseAxes axes);

/// The tolerances of each trial; a single 0 where the problem has no tolerance.
std::vector<double> tolerances_of(const suite::Study& study, const CaseAxes& axes);

/// The info of every method of the problem, each once: our own in roster order, then those of other libraries.
template <TrialProblem P>
std::vector<const MethodInfo*> infos() {
  std::vector<const MethodInfo*> all;
  for (int dimension = 1; dimension <= reference::max_dimension; ++dimension)
    for (const auto& kernel : P::kernels(dimension))
      if (std::ranges::count(all, kernel.info) == 0) all.push_back(kernel.info);
  return all;
}

/// The kernels that the study names and that take its form of curve, in roster order.
template <TrialProblem P>
std::vector<const typename P::Kernel*> chosen_trial_kernels(const suite::Study& study, int dimension) {
  std::vector<const typename P::Kernel*> methods;
  const auto chosen = chosen_companions(study, infos<P>());
  for (const auto& kernel : P::kernels(dimension))
    if (kernel.info->form == study.form && std::ranges::find(chosen, kernel.info) != chosen.end())
      methods.push_back(&kernel);
  return methods;
}

/// Whether a method takes the curves of a cell. Of a problem that starts from data points, the degree is that of the
/// curves that these are taken from.
template <TrialProblem P>
bool takes(const MethodInfo& info, const sample::Cell& cell) {
  return P::axes.data || info.supports<double>(cell.degree);
}

// Trials of a cell: a curve and a parameter.

/// Is neither copied nor moved: the curve refers to the trial.
struct DrawnCurve {
  sample::Trial trial;
  CurveView<double> curve;

  DrawnCurve() = default;
  DrawnCurve(const DrawnCurve&) = delete;
  DrawnCurve& operator=(const DrawnCurve&) = delete;
};

class CurveSampler {
 public:
  CurveSampler(const suite::Study& study, std::uint64_t seed, const sample::Cell& cell)
      : form_(study.form), cell_(cell), sampler_(seed, study.id, cell) {}

  void draw(std::uint64_t number, DrawnCurve& drawn) const {
    sampler_.draw(number, drawn.trial);
    drawn.curve = {form_, cell_.dimension, cell_.degree, drawn.trial.coefficients, drawn.trial.weights};
  }

 private:
  Form form_;
  sample::Cell cell_;
  sample::Sampler sampler_;
};

}  // namespace bezierbench::judge
