// SPDX-License-Identifier: MIT
#include "experiments/studies/accuracy.hpp"

#include "experiments/studies/accuracy_cell.hpp"

namespace bezierbench::studies {
namespace {

class AccuracyJob final : public Job {
 public:
  AccuracyJob(const suite::Study& study, std::uint64_t seed) : study_(study) {
    for (const auto& cell : sample::cells(study_))
      for (const auto scalar : study_.scalar) {
        const auto& work = *cells_.emplace_back(accuracy_cell(study_, seed, cell, scalar));
        for (std::size_t number = 0; number < work.blocks(); ++number) blocks_.push_back({cells_.size() - 1, number});
      }
  }

  [[nodiscard]] std::size_t blocks() const override { return blocks_.size(); }
  void run_block(std::size_t block) override { cells_[blocks_[block].cell]->run_block(blocks_[block].number); }
  [[nodiscard]] double cost(std::size_t block) const override { return cells_[blocks_[block].cell]->cost(); }
  [[nodiscard]] std::uint64_t evaluations() const override {
    std::uint64_t sum = 0;
    for (const auto& cell : cells_) sum += cell->evaluations();
    return sum;
  }

  void write(Tables& tables) const override {
    for (const auto& cell : cells_) cell->write(tables);
  }
  [[nodiscard]] std::vector<Series> series() const override { return collected<Series>(); }
  [[nodiscard]] std::vector<Violation> violations() const override { return collected<Violation>(); }

 private:
  struct Block {
    std::size_t cell;
    std::size_t number;
  };

  template <class T>
  [[nodiscard]] std::vector<T> collected() const {
    std::vector<T> all;
    for (const auto& cell : cells_) cell->collect(all);
    return all;
  }

  suite::Study study_;
  std::vector<std::unique_ptr<AccuracyCell>> cells_;
  std::vector<Block> blocks_;
};

}  // namespace

std::unique_ptr<Job> accuracy_job(const suite::Study& study, std::uint64_t seed) {
  return std::make_unique<AccuracyJob>(study, seed);
}

}  // namespace bezierbench::studies
