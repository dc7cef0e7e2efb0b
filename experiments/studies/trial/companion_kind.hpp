// SPDX-License-Identifier: MIT
// The kind of study of a companion problem: its errors, its times and its methods follow from problem.hpp.
#pragma once

#include <deque>
#include <memory>
#include <span>

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

// The errors of an external method in a companion problem, judged as those of our methods. A block is one batch, in a
// process of its own.

/// A problem that external methods can solve.
///
/// `give` adds a drawn trial to a batch, in the layout of external::inputs_of(); P::numbers are those of an answer.
/// `described` is a kernel that only describes a method: its function is null, and it has no bound and no promise.
template <class P>
concept ExternalProblem = StudiedProblem<P> &&
    requires(const P& trials, const typename P::Drawn& drawn, double tolerance, external::Batch& batch,
             const MethodInfo& info) {
  trials.give(drawn, tolerance, batch);
  { P::described(info, int{}) } -> std::same_as<typename P::Kernel>;
};

template <ExternalProblem P>
class ExternalTrialJob final : public TrialJob<P> {
 public:
  ExternalTrialJob(const suite::Study& study, const suite::ExternalMethod& record, const external::Method* given,
                   const run::JobContext& context)
      : TrialJob<P>(study, context, trials_together), method_(record, study.form, given) {
    for (std::size_t k = 0; k < kernels_.size(); ++k)
      kernels_[k] = P::described(method_.info(), static_cast<int>(k) + 1);
    for (auto& part : this->parts_) part.methods = {&kernels_[static_cast<std::size_t>(part.part.cell.dimension) - 1]};
  }

  [[nodiscard]] run::Extent extent() const override {
    auto extent = TrialJob<P>::extent();
    extent.cells = 0;  // they are those of the study's own job
    return extent;
  }

 protected:
  [[nodiscard]] TrialErrors<typename P::Errors> work(std::size_t block) const override;
  [[nodiscard]] std::string_view failure(std::size_t part) const override {
    const auto status = static_cast<external::Status>(this->state(part).status);
    return status == external::Status::ok ? std::string_view() : external::name(status);
  }

 private:
  /// Of a block: few enough to spread over threads, since the truth takes longer than a process to start.
  static constexpr std::int64_t trials_together = 256;

  struct Trial {
    std::uint64_t number = 0;
    typename P::Drawn drawn;
  };

  /// The answer of which these are the numbers.
  [[nodiscard]] static typename P::Answer answer_of(std::span<const double> numbers) {
    typename P::Answer answer{};
    if constexpr (requires { answer.resize(numbers.size()); }) answer.resize(numbers.size());
    for (const auto part : P::numbers(answer)) {
      std::ranges::copy(numbers.first(part.size()), part.begin());
      numbers = numbers.subspan(part.size());
    }
    return answer;
  }

  JudgedExternal method_;
  std::array<typename P::Kernel, 3> kernels_{};  ///< by dimension
};

template <ExternalProblem P>
TrialErrors<typename P::Errors> ExternalTrialJob<P>::work(std::size_t block) const {
  const auto& part = this->parts_[this->part_of(block)];
  const auto& cell = part.part.cell;
  TrialErrors<typename P::Errors> tally;
  tally.rows.resize(this->tolerances_.size());
  if (!method_.info().template supports<double>(cell.degree)) return tally;
  const P problem = this->problem_of(part);
  external::Batch batch{
      .problem = P::problem, .form = this->study_.form, .dimension = cell.dimension, .degree = cell.degree};
  std::deque<Trial> trials;
  run::each_trial(this->blocks_[block % this->blocks_per_part()], [&](std::int64_t trial) {
    auto& asked = trials.emplace_back();
    asked.number = static_cast<std::uint64_t>(trial);
    this->with_truth(part, asked.number, [&] { problem.draw(asked.number, asked.drawn); });
    for (const double tolerance : this->tolerances_) problem.give(asked.drawn, tolerance, batch);
  });
  const auto answer = method_.ask(this->study_, this->part_of(block), batch);
  tally.status = static_cast<std::uint8_t>(answer.status);
  if (answer.numbers.empty()) return tally;
  std::span numbers(answer.numbers);
  for (const auto& trial : trials)
    this->with_truth(part, trial.number, [&] {
      for (std::size_t k = 0; k < this->tolerances_.size(); ++k) {
        problem.judge(*part.methods.front(), trial.drawn, this->tolerances_[k],
                      answer_of(numbers.first(batch.answer_size())), trial.number, tally.rows[k]);
        numbers = numbers.subspan(batch.answer_size());
      }
    });
  return tally;
}

/// Its job, as StudyKind::make_external.
template <ExternalProblem P>
std::unique_ptr<run::Job> external_trial_job(const suite::Study& study, const suite::ExternalMethod& record,
                                             const external::Method* given, const run::JobContext& context) {
  return std::make_unique<ExternalTrialJob<P>>(study, record, given, context);
}

/// The kind that judges and times the methods of P. `asks` states what else suites may ask of it.
template <StudiedProblem P>
constexpr StudyKind companion_kind(suite::Kind asks, race::Size size = race::Size::unclaimed) {
  asks.problem = P::problem;
  StudyKind kind{asks, trial_job<P>, race::timed_companion<P>(size), judge::infos<P>};
  if constexpr (ExternalProblem<P>) kind.make_external = external_trial_job<P>;
  return kind;
}

}  // namespace bezierbench::studies
