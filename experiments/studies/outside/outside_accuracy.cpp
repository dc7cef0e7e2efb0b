// SPDX-License-Identifier: MIT
// Errors of a method from outside. A block of trials is one batch, in a process of its own.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <utility>

#include "experiments/judge/trial_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/accuracy/accuracy_cell.hpp"
#include "experiments/studies/outside/outside_jobs.hpp"

namespace bezierbench::studies {
namespace {

using outside::Status;

/// The errors of the blocks that were answered, and the worst of what came of the others.
struct OutsideTally {
  judge::CellTally tally;
  std::uint8_t status = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.tally, self.status);
  }
  void merge(const OutsideTally& other) {
    tally.merge(other.tally);
    status = std::max(status, other.status);
  }
};

class OutsideAccuracyJob final : public run::JobOf<OutsideTally> {
 public:
  OutsideAccuracyJob(const suite::Study& study, const suite::OutsideMethod& record, const outside::Method* at_hand,
                     run::JobContext context)
      : study_(study), method_(record, study.curve, at_hand) {
    context.audited_trials = 0;  // the study's own job audits them
    for (const auto& cell : sample::cells(study_)) {
      cells_.emplace_back(study_, context, cell, method_.described(cell.dimension));
      late_.emplace_back(false);
    }
  }

  [[nodiscard]] std::size_t parts() const override { return cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return cells_.front().blocks(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    constexpr double of_a_process = 2e7;
    return of_a_process + cells_[part].cost();
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const auto& cell : cells_) sum += cell.extent();
    sum.cells = 0;  // they are those of the study's own job
    return sum;
  }
  void write(tables::Tables& tables) const override {
    (void)tables.table("reference.csv");
    for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k].write(state(k).tally, tables, failure(state(k)));
  }
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] OutsideTally work(std::size_t block) const override;

 private:
  using Cell = AccuracyCell<double>;

  [[nodiscard]] outside::Batch batch_of(const Cell& cell, std::size_t block) const;
  /// The status that stands for numbers; empty where there are some.
  static std::string_view failure(const OutsideTally& state) {
    const auto status = static_cast<Status>(state.status);
    if (status != Status::ok) return name(status);
    const bool finite = std::ranges::any_of(state.tally.judgements, [](const auto& j) { return j.error.count() > 0; });
    return finite ? std::string_view() : name(Status::non_finite);
  }

  suite::Study study_;
  JudgedOutside method_;
  std::deque<Cell> cells_;                      ///< which never move: what a cell judges with refers to it
  mutable std::deque<std::atomic<bool>> late_;  ///< cells in which a block took too long; no other is asked
};

outside::Batch OutsideAccuracyJob::batch_of(const Cell& cell, std::size_t block) const {
  outside::Batch batch{study_.curve, cell.cell().dimension, cell.cell().degree, {}, {}, {}};
  judge::TrialInputs<double> inputs(study_.curve, cell.cell());
  const auto [first, end] = cell.trials_of(block);
  for (auto trial = first; trial < end; ++trial) {
    inputs.draw(cell.sampler(), trial);
    const auto curve = inputs.curve();
    batch.t.push_back(inputs.t());
    batch.coefficients.insert(batch.coefficients.end(), curve.coefficients.begin(), curve.coefficients.end());
    batch.weights.insert(batch.weights.end(), curve.weights.begin(), curve.weights.end());
  }
  return batch;
}

OutsideTally OutsideAccuracyJob::work(std::size_t block) const {
  const std::size_t part = part_of(block);
  const std::size_t of_cell = block % blocks_per_part();
  const Cell& cell = cells_[part];
  const auto nothing = [&](Status status) {
    return OutsideTally{cell.judge_block(of_cell, {}), static_cast<std::uint8_t>(status)};
  };
  if (!method_.info().supports<double>(cell.cell().degree)) return nothing(Status::ok);
  if (late_[part]) return nothing(Status::timed_out);
  const auto answer = method_.method().points(batch_of(cell, of_cell));
  if (run::interrupted()) return nothing(Status::ok);  // the engine drops what was not finished
  if (answer.status == Status::ok) return {cell.judge_block(of_cell, answer.points), 0};
  if (answer.status == Status::timed_out) late_[part] = true;
  method_.tell(study_, answer);
  return nothing(answer.status);
}

}  // namespace

std::unique_ptr<run::Job> outside_accuracy_job(const suite::Study& study, const suite::OutsideMethod& record,
                                               const outside::Method* at_hand, const run::JobContext& context) {
  return std::make_unique<OutsideAccuracyJob>(study, record, at_hand, context);
}

}  // namespace bezierbench::studies
