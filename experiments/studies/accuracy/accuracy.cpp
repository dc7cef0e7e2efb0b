// SPDX-License-Identifier: MIT
// Studies of kind `accuracy`: random curves and parameters, every method, errors against the exact point or a baseline.

#include <deque>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/judge/scalar_facts.hpp"
#include "experiments/studies/accuracy/accuracy_cell.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/timing/timed_evaluation.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::studies {
namespace {

class AccuracyJob final : public run::JobOf<judge::CellTally> {
 public:
  AccuracyJob(const suite::Study& study, const run::JobContext& context) : study_(study) {
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        judge::with_scalar(scalar, [&]<class Scalar>(Scalar /*zero*/) {
          cells_.emplace_back(std::in_place_type<AccuracyCell<Scalar>>, study_, context, cell);
        });
  }

  [[nodiscard]] std::size_t parts() const override { return cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return std::visit([](const auto& cell) { return cell.blocks(); }, cells_[0]);  // all cells alike
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    return std::visit([](const auto& cell) { return cell.cost(); }, cells_[part]);
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      sum += std::visit([](const auto& cell) { return cell.extent(); }, cells_[k]);
    return sum;
  }

  void write(tables::Tables& tables) const override {
    for (std::size_t k = 0; k < cells_.size(); ++k)
      std::visit([&](const auto& cell) { cell.write(state(k), tables); }, cells_[k]);
  }
  [[nodiscard]] std::vector<tables::Series> series() const override { return collected<tables::Series>(); }
  [[nodiscard]] std::vector<run::Violation> violations() const override { return collected<run::Violation>(); }

 protected:
  [[nodiscard]] judge::CellTally work(std::size_t block) const override {
    return std::visit([&](const auto& cell) { return cell.run_block(block % blocks_per_part()); },
                      cells_[part_of(block)]);
  }

 private:
  using Cell = std::variant<AccuracyCell<double>, AccuracyCell<float>>;

  template <class T>
  [[nodiscard]] std::vector<T> collected() const {
    std::vector<T> all;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      std::visit([&](const auto& cell) { cell.collect(state(k), all); }, cells_[k]);
    return all;
  }

  suite::Study study_;
  std::deque<Cell> cells_;  ///< elements must not move: a cell holds references to itself
};

std::unique_ptr<run::Job> accuracy_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<AccuracyJob>(study, context);
}

constexpr std::array accuracy_fields{
    suite::field<&suite::Study::decomposed_trials>(
        {.key = "decomposed_trials",
         .meaning = "number of trials of the first replicate of a cell whose error is decomposed by its sources",
         .example = "100",
         .left_out = "0"}),
    suite::field<&suite::Study::published>(suite::published_key)};

}  // namespace

extern constexpr StudyKind accuracy_kind{.asks = {.id = "accuracy",
                                                  .about = "errors of points on random curves, of every method",
                                                  .own = accuracy_fields,
                                                  .methods_example = "[\"de_casteljau\", \"horner_bernstein\"]",
                                                  .problem = Problem::evaluation,
                                                  .has_baseline = true},
                                         .make = accuracy_job,
                                         .timed = timed_evaluation,
                                         .make_external = external_accuracy_job};

}  // namespace bezierbench::studies
