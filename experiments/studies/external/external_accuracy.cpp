// SPDX-License-Identifier: MIT
// Errors of an external method. A block is one batch, in a process of its own. A batch holds trials of several replicates
// where each has few, since starting a process may take as long as a thousand answers.
#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/judge/trial_inputs.hpp"
#include "experiments/studies/accuracy/accuracy_cell.hpp"
#include "experiments/studies/external/external.hpp"

namespace bezierbench::studies {
namespace {

using external::Status;

/// The errors of the answered blocks, and the worst status of all blocks.
struct ExternalTally {
  judge::CellTally tally;
  std::uint8_t status = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.tally, self.status);
  }
  void merge(const ExternalTally& other) {
    tally.merge(other.tally);
    status = std::max(status, other.status);
  }
};

class ExternalAccuracyJob final : public run::JobOf<ExternalTally> {
 public:
  ExternalAccuracyJob(const suite::Study& study, const suite::ExternalMethod& record, const external::Method* given,
                      run::JobContext context)
      : study_(study), method_(record, study.form, given) {
    context.audited_trials = 0;  // the study's own job audits them
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        if (method_.answers_in(scalar))
          judge::with_scalar(scalar, [&]<class Scalar>(Scalar /*zero*/) {
            cells_.emplace_back(std::in_place_type<AccuracyCell<Scalar>>, study_, context, cell,
                                method_.described<Scalar>(cell.dimension));
          });
  }

  [[nodiscard]] std::size_t parts() const override { return cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return (blocks_per_cell() - 1) / together() + 1; }
  [[nodiscard]] double cost(std::size_t part) const override {
    constexpr double process_cost = 2e7;
    return process_cost +
           static_cast<double>(together()) * std::visit([](const auto& cell) { return cell.cost(); }, cells_[part]);
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      sum += std::visit([](const auto& cell) { return cell.extent(); }, cells_[k]);
    sum.cells = 0;  // they are those of the study's own job
    return sum;
  }
  void write(tables::Tables& tables) const override {
    (void)tables.table("reference.csv");
    for (std::size_t k = 0; k < cells_.size(); ++k)
      std::visit([&](const auto& cell) { cell.write(state(k).tally, tables, failure(state(k))); }, cells_[k]);
  }

 protected:
  [[nodiscard]] ExternalTally work(std::size_t block) const override {
    return std::visit([&](const auto& cell) { return work(cell, block); }, cells_[part_of(block)]);
  }

 private:
  using Cell = std::variant<AccuracyCell<double>, AccuracyCell<float>>;

  [[nodiscard]] std::size_t blocks_per_cell() const {
    return std::visit([](const auto& cell) { return cell.blocks(); }, cells_[0]);  // all cells alike
  }
  /// Blocks of a cell that one batch holds.
  [[nodiscard]] std::size_t together() const {
    constexpr std::uint64_t max_trials = 1024;
    const auto [first, end] = std::visit([](const auto& cell) { return cell.trials_of(0); }, cells_[0]);
    return std::max<std::size_t>(1, max_trials / (end - first));
  }
  /// The first block of a cell in a batch, and one past the last.
  [[nodiscard]] std::pair<std::size_t, std::size_t> blocks_in(std::size_t batch) const {
    return {batch * together(), std::min(blocks_per_cell(), (batch + 1) * together())};
  }
  template <class Scalar>
  [[nodiscard]] ExternalTally work(const AccuracyCell<Scalar>& cell, std::size_t block) const;
  template <class Scalar>
  void add_inputs(const AccuracyCell<Scalar>& cell, std::size_t block, external::Batch& batch) const;
  /// The errors of the blocks in a batch; without points a tally without trials.
  template <class Scalar>
  [[nodiscard]] judge::CellTally judged(const AccuracyCell<Scalar>& cell, std::size_t batch,
                                        std::span<const double> points) const;
  /// The status in place of the numbers; empty where there are numbers.
  static std::string_view failure(const ExternalTally& state) {
    const auto status = static_cast<Status>(state.status);
    if (status != Status::ok) return name(status);
    const bool finite = std::ranges::any_of(state.tally.judgements, [](const auto& j) { return j.error.count() > 0; });
    return finite ? std::string_view() : name(Status::non_finite);
  }

  suite::Study study_;
  JudgedExternal method_;
  std::deque<Cell> cells_;  ///< elements must not move: a cell holds references to itself
};

template <class Scalar>
void ExternalAccuracyJob::add_inputs(const AccuracyCell<Scalar>& cell, std::size_t block,
                                     external::Batch& batch) const {
  judge::TrialInputs<Scalar> inputs(study_.form, cell.cell());
  const auto [first, end] = cell.trials_of(block);
  for (auto trial = first; trial < end; ++trial) {
    inputs.draw(cell.sampler(), trial);
    const double t = inputs.true_t();
    batch.add(inputs.true_curve(), std::span(&t, 1));
  }
}

template <class Scalar>
judge::CellTally ExternalAccuracyJob::judged(const AccuracyCell<Scalar>& cell, std::size_t batch,
                                             std::span<const double> points) const {
  const auto [first_block, end_block] = blocks_in(batch);
  std::optional<judge::CellTally> sum;
  for (auto block = first_block; block < end_block; ++block) {
    const auto [first, end] = cell.trials_of(block);
    const auto block_answers =
        points.first(std::min(points.size(), (end - first) * static_cast<std::size_t>(cell.cell().dimension)));
    points = points.subspan(block_answers.size());
    auto tally = cell.judge_block(block, block_answers);
    if (sum)
      sum->merge(tally);
    else
      sum = std::move(tally);
  }
  return std::move(*sum);
}

template <class Scalar>
ExternalTally ExternalAccuracyJob::work(const AccuracyCell<Scalar>& cell, std::size_t block) const {
  const std::size_t batch_number = block % blocks_per_part();
  if (!method_.info().supports<Scalar>(cell.cell().degree)) return {judged(cell, batch_number, {}), 0};
  external::Batch batch{.scalar = judge::ScalarFacts<Scalar>::kind,
                        .form = study_.form,
                        .dimension = cell.cell().dimension,
                        .degree = cell.cell().degree};
  const auto [first, end] = blocks_in(batch_number);
  for (auto k = first; k < end; ++k) add_inputs(cell, k, batch);
  const auto answer = method_.ask(study_, part_of(block), batch);
  return {judged(cell, batch_number, answer.numbers), static_cast<std::uint8_t>(answer.status)};
}

}  // namespace

std::unique_ptr<run::Job> external_accuracy_job(const suite::Study& study, const suite::ExternalMethod& record,
                                                const external::Method* given, const run::JobContext& context) {
  return std::make_unique<ExternalAccuracyJob>(study, record, given, context);
}

}  // namespace bezierbench::studies
