// SPDX-License-Identifier: MIT
// For this folder's tests only: a job that is nothing but its size.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "experiments/run/job.hpp"

namespace bezierbench::run {

/// Parts of unequal cost and nothing to do.
class Costs final : public Job {
 public:
  Costs(std::vector<double> costs, std::size_t each, bool timing)
      : costs_(std::move(costs)), each_(each), timing_(timing) {}
  [[nodiscard]] std::size_t parts() const override { return costs_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return each_; }
  [[nodiscard]] double cost(std::size_t part) const override { return costs_[part]; }
  [[nodiscard]] bool exclusive() const override { return timing_; }
  [[nodiscard]] std::unique_ptr<Result> run_block(std::size_t) const override { return nullptr; }
  [[nodiscard]] std::unique_ptr<Result> read_result(number::ByteReader&) const override { return nullptr; }
  [[nodiscard]] Extent extent() const override { return {}; }
  void write(tables::Tables&) const override {}
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 private:
  std::vector<double> costs_;
  std::size_t each_;
  bool timing_;
};

}  // namespace bezierbench::run
