// SPDX-License-Identifier: MIT
// One study of a run, as work that can be cut into blocks and rows that can be written when all blocks are done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::studies {

/// The CSV files of a bundle while they grow, by file name.
class Tables {
 public:
  /// The table of this name, made with these columns when first asked for.
  bundle::CsvTable& table(const std::string& file, const std::vector<std::string>& columns);
  [[nodiscard]] const std::map<std::string, bundle::CsvTable>& all() const { return tables_; }

 private:
  std::map<std::string, bundle::CsvTable> tables_;
};

/// One statistic of one cell, once per replicate: what a printed cell of a report is compared with.
struct Series {
  std::string study;
  std::string curve;
  std::string method;
  std::string statistic;  ///< mean_error, max_error, count_within_1e-5, ..., total_time
  std::string degree;     ///< a number, or first..last for statistics over degrees
  double coordinate_range = 0;
  std::optional<suite::Interval> t_interval;
  std::string generator;
  std::string baseline;  ///< exact or a method id; empty for times
  std::string mode;      ///< of a timing; empty otherwise
  std::vector<double> values;
};

/// Where a proved bound was seen to fail.
struct Violation {
  std::string where;  ///< study, method, cell and trial
  std::uint64_t count;
};

/// How much a study is, before it is done.
struct Extent {
  std::size_t cells = 0;
  std::size_t rows = 0;           ///< of CSV
  std::uint64_t evaluations = 0;  ///< of methods or conversions
  std::size_t memory = 0;         ///< bytes, about

  Extent& operator+=(const Extent& other) {
    cells += other.cells;
    rows += other.rows;
    evaluations += other.evaluations;
    memory += other.memory;
    return *this;
  }
};

/// What all studies of a run share.
struct JobContext {
  std::uint64_t seed = 1;
  reference::Tier tier = reference::Tier::exact;
};

class Job {
 public:
  Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  Job(Job&&) = delete;
  Job& operator=(Job&&) = delete;
  virtual ~Job() = default;

  /// Units of work; independent of each other, run in any order and on any thread unless `exclusive`.
  [[nodiscard]] virtual std::size_t blocks() const = 0;
  virtual void run_block(std::size_t block) = 0;
  /// Relative cost of a block, for the estimate of the time left.
  [[nodiscard]] virtual double cost(std::size_t block) const = 0;
  [[nodiscard]] virtual double total_cost() const;
  /// True for timings: nothing else may run beside them.
  [[nodiscard]] virtual bool exclusive() const { return false; }
  /// For --dry-run.
  [[nodiscard]] virtual Extent extent() const = 0;

  /// Appends this study's rows; all blocks are done.
  virtual void write(Tables& tables) const = 0;
  [[nodiscard]] virtual std::vector<Series> series() const = 0;
  [[nodiscard]] virtual std::vector<Violation> violations() const { return {}; }
};

}  // namespace bezierbench::studies
