// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy/accuracy.hpp"

#include "experiments/studies/accuracy/accuracy_cell.hpp"

namespace bezierbench::studies {
namespace {

class AccuracyJob final : public run::JobOf<judge::CellTally> {
 public:
  AccuracyJob(const suite::Study& study, const run::JobContext& context) : study_(study) {
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        cells_.push_back(accuracy_cell(study_, context.seed, cell, scalar, context.tier));
  }

  [[nodiscard]] std::size_t parts() const override { return cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return cells_.front()->blocks(); }  // all cells alike
  [[nodiscard]] double cost(std::size_t part) const override { return cells_[part]->cost(); }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const auto& cell : cells_) sum += cell->extent();
    return sum;
  }

  void write(tables::Tables& tables) const override {
    for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k]->write(state(k), tables);
  }
  [[nodiscard]] std::vector<tables::Series> series() const override { return collected<tables::Series>(); }
  [[nodiscard]] std::vector<run::Violation> violations() const override { return collected<run::Violation>(); }

 protected:
  [[nodiscard]] judge::CellTally work(std::size_t block) const override {
    return cells_[part_of(block)]->run_block(block % blocks_per_part());
  }

 private:
  template <class T>
  [[nodiscard]] std::vector<T> collected() const {
    std::vector<T> all;
    for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k]->collect(state(k), all);
    return all;
  }

  suite::Study study_;
  std::vector<std::unique_ptr<AccuracyCell>> cells_;
};

}  // namespace

std::unique_ptr<run::Job> accuracy_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<AccuracyJob>(study, context);
}

}  // namespace bezierbench::studies
