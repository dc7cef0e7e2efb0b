// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy.hpp"

#include "experiments/studies/accuracy_cell.hpp"

namespace bezierbench::studies {
namespace {

class AccuracyJob final : public Job {
 public:
  AccuracyJob(const suite::Study& study, const JobContext& context) : study_(study) {
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar)
        cells_.push_back(accuracy_cell(study_, context.seed, cell, scalar, context.tier));
  }

  [[nodiscard]] std::size_t blocks() const override { return cells_.size() * blocks_per_cell(); }
  void run_block(std::size_t block) override { cells_[cell_of(block)]->run_block(block % blocks_per_cell()); }
  [[nodiscard]] double cost(std::size_t block) const override { return cells_[cell_of(block)]->cost(); }
  [[nodiscard]] double total_cost() const override {
    double sum = 0;
    for (const auto& cell : cells_) sum += cell->cost() * static_cast<double>(blocks_per_cell());
    return sum;
  }
  [[nodiscard]] Extent extent() const override {
    Extent sum;
    for (const auto& cell : cells_) sum += cell->extent();
    return sum;
  }

  void write(Tables& tables) const override {
    for (const auto& cell : cells_) cell->write(tables);
  }
  [[nodiscard]] std::vector<Series> series() const override { return collected<Series>(); }
  [[nodiscard]] std::vector<Violation> violations() const override { return collected<Violation>(); }

 private:
  /// The same for all cells of a study.
  [[nodiscard]] std::size_t blocks_per_cell() const { return cells_.front()->blocks(); }
  [[nodiscard]] std::size_t cell_of(std::size_t block) const { return block / blocks_per_cell(); }

  template <class T>
  [[nodiscard]] std::vector<T> collected() const {
    std::vector<T> all;
    for (const auto& cell : cells_) cell->collect(all);
    return all;
  }

  suite::Study study_;
  std::vector<std::unique_ptr<AccuracyCell>> cells_;
};

}  // namespace

std::unique_ptr<Job> accuracy_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<AccuracyJob>(study, context);
}

}  // namespace bezierbench::studies
