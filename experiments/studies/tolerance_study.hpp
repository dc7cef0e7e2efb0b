// SPDX-License-Identifier: MIT
// The part of a study of lengths that is the same for each problem: cells of random Bezier curves in double, every
// method at every tolerance, promises that are counted and, where broken, fail the run.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/judge/companions.hpp"
#include "experiments/judge/study_inputs.hpp"
#include "experiments/metric/tally.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/promises.hpp"
#include "experiments/suite/kinds.hpp"
#include "experiments/tables/cell_fields.hpp"
#include "reference/length_panels.hpp"

namespace bezierbench::studies {

/// The lengths of one trial: what every method is asked.
template <class Kernel>
struct ToleranceTrial {
  const sample::Cell& cell;
  const sample::Trial& drawn;
  std::uint64_t number;
  const std::vector<const Kernel*>& methods;
  const std::vector<double>& tolerances;

  [[nodiscard]] CurveView<double> curve() const {
    return {Form::bernstein, cell.dimension, cell.degree, drawn.coefficients};
  }
};

/// A column after trials and status. `field` is of one row and the number of trials.
template <class Row>
struct ToleranceColumn {
  const char* name;
  std::string (*field)(const Row& row, std::int64_t trials);
};

/// What sets a problem apart. A Row has `promises`, fields of its own, each_field and merge.
template <class Kernel, class Row>
struct ToleranceProblem {
  Problem problem;
  std::string_view table;  ///< NAME.csv, and NAME_unstable.csv for methods that are not bit-stable
  std::span<const Kernel> (*kernels)(int dimension);
  std::span<const ToleranceColumn<Row>> columns;
  /// CaseAxes every method at every tolerance and adds to `rows`, tolerance by tolerance.
  void (*judge)(const ToleranceTrial<Kernel>& trial, std::vector<Row>& rows);
};

template <class Kernel, class Row>
class ToleranceJob : public run::JobOf<ToleranceRows<Row>> {
 public:
  ToleranceJob(const suite::Study& study, std::uint64_t seed, const ToleranceProblem<Kernel, Row>& problem)
      : study_(study), seed_(seed), problem_(problem) {
    judge::check_inputs(study);
    for (const auto& cell : sample::cells(study_)) parts_.push_back({cell, methods_of(cell.dimension)});
  }

  [[nodiscard]] std::size_t parts() const override { return parts_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override {
    return static_cast<std::size_t>((trials() - 1) / block_trials + 1);
  }
  [[nodiscard]] double cost(std::size_t part) const override {
    const double n = parts_[part].cell.degree + 1.0;
    return static_cast<double>(std::min(trials(), block_trials)) * 1e6 * n * n;
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum;
    for (const Part& part : parts_) {
      const std::size_t rows = part.methods.size() * tolerances().size();
      sum += {1, rows, static_cast<std::uint64_t>(trials()) * rows};
    }
    return sum;
  }
  void write(tables::Tables& tables) const override {
    auto names = tables::cell_columns();
    names.insert(names.end(), {"tolerance", "trials", "status"});
    for (const auto& column : problem_.columns) names.emplace_back(column.name);
    each_row([&](const Part& part, double tolerance, const Kernel& method, const Row& row) {
      auto fields = tables::cell_fields(study_, part.cell, method.info->id, suite::ScalarKind::float64);
      fields.insert(fields.end(), {number::decimal(tolerance), std::to_string(trials()), "ok"});
      for (const auto& column : problem_.columns) fields.push_back(column.field(row, trials()));
      const auto file = fmt::format("{}{}.csv", problem_.table, method.info->bit_stable ? "" : "_unstable");
      tables.table(file, names).add_row(std::move(fields));
    });
  }
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }
  [[nodiscard]] std::vector<run::Violation> violations() const override {
    std::vector<run::Violation> all;
    each_row([&](const Part& part, double tolerance, const Kernel& method, const Row& row) {
      if (row.promises.broken == 0) return;
      all.push_back({fmt::format("{}, tolerance {}, method {}, first at trial {}",
                                 tables::describe(study_, part.cell, suite::ScalarKind::float64),
                                 number::decimal(tolerance), method.info->id, row.promises.first_broken),
                     row.promises.broken});
    });
    return all;
  }

 protected:
  [[nodiscard]] ToleranceRows<Row> work(std::size_t block) const override {
    const Part& part = parts_[this->part_of(block)];
    const sample::Sampler sampler(seed_, study_.id, part.cell);
    ToleranceRows<Row> tally;
    tally.rows.resize(part.methods.size() * tolerances().size());
    sample::Trial drawn;
    const auto first = static_cast<std::int64_t>(block % blocks_per_part()) * block_trials;
    const auto last = std::min(trials(), first + block_trials);
    for (auto trial = first; trial < last && !run::interrupted(); ++trial) {
      const auto number = static_cast<std::uint64_t>(trial);
      sampler.draw(number, drawn);
      try {
        problem_.judge({part.cell, drawn, number, part.methods, tolerances()}, tally.rows);
      } catch (const reference::NotCertain& error) {
        throw Failure(Exit::usage, fmt::format("{}, trial {}: {}; leave this cell out of the suite",
                                               tables::describe(study_, part.cell, suite::ScalarKind::float64), trial,
                                               error.what()));
      }
    }
    return tally;
  }

  [[nodiscard]] const suite::Study& study() const { return study_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const sample::Cell& cell(std::size_t part) const { return parts_[part].cell; }

 private:
  static constexpr std::int64_t block_trials = 16;  // true lengths take a while

  struct Part {
    sample::Cell cell;
    std::vector<const Kernel*> methods;
  };

  [[nodiscard]] const std::vector<double>& tolerances() const { return suite::tolerances_of(study_); }
  [[nodiscard]] std::int64_t trials() const { return study_.trials * study_.replicates; }

  [[nodiscard]] std::vector<const Kernel*> methods_of(int dimension) const {
    std::vector<const Kernel*> methods;
    const auto chosen = judge::chosen_companions(study_, problem_.problem);
    for (const auto& kernel : problem_.kernels(dimension))
      if (std::ranges::find(chosen, kernel.info) != chosen.end()) methods.push_back(&kernel);
    return methods;
  }

  template <class Visit>
  void each_row(Visit&& visit) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      std::size_t k = 0;
      for (const double tolerance : tolerances())
        for (const auto* method : parts_[p].methods) visit(parts_[p], tolerance, *method, this->state(p).rows.at(k++));
    }
  }

  suite::Study study_;
  std::uint64_t seed_;
  ToleranceProblem<Kernel, Row> problem_;
  std::vector<Part> parts_;
};

/// Fields of columns. A statistic of no trial is an empty field.
template <class Row>
struct ToleranceFields {
  using Statistic = double (*)(const metric::Tally&);
  static constexpr Statistic mean = [](const metric::Tally& tally) { return tally.mean(); };
  static constexpr Statistic median = [](const metric::Tally& tally) { return tally.quantile(0.5); };
  static constexpr Statistic p99 = [](const metric::Tally& tally) { return tally.quantile(0.99); };
  static constexpr Statistic largest = [](const metric::Tally& tally) { return tally.max(); };

  template <metric::Tally Row::*Of, Statistic Which>
  static std::string statistic(const Row& row, std::int64_t /*trials*/) {
    return (row.*Of).count() > 0 ? number::decimal(Which(row.*Of)) : "";
  }
  template <std::uint64_t Promises::*Of>
  static std::string count(const Row& row, std::int64_t /*trials*/) {
    return std::to_string(row.promises.*Of);
  }
  static std::string mean_evaluations(const Row& row, std::int64_t trials) {
    return number::decimal(static_cast<double>(row.promises.evaluations) / static_cast<double>(trials));
  }
};

}  // namespace bezierbench::studies
