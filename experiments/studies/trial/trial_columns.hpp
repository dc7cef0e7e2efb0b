// SPDX-License-Identifier: MIT
// The columns of the errors of a companion problem.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "experiments/judge/case_axes.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::studies {

/// The content of a row: the errors of one method in all trials of a part, at one tolerance.
template <class Kernel, class ErrorsT>
struct TrialRow {
  using Errors = ErrorsT;
  const sample::Cell& cell;
  judge::CaseValues values;
  const Kernel& method;
  std::int64_t trials;
  const Errors& errors;
};

template <class Row>
struct TrialColumn {
  std::string_view name;
  tables::Field (*field)(const Row& row);
};

/// Trials in which a method broke a promise or a proved bound; any of them fails the run.
template <class Row>
struct TrialFailure {
  std::string_view what;  ///< for messages; empty if the problem has no other failure
  const metric::TrialCount& (*trials)(const Row& row);
  run::Broken broken = run::Broken::bound;
};

/// Functions that make a field from a value in the errors of a row. `members` lead to the value: a pointer to a member
/// of the errors, a pointer to a member of that, and so on.
namespace column {

template <auto... members>
constexpr const auto& reached(const auto& errors) {
  return (errors.*....*members);  // errors.*first.*second
}

template <tables::Statistic which, auto... members>
inline constexpr auto statistic =
    [](const auto& row) -> tables::Field { return tables::field(reached<members...>(row.errors), which); };

template <auto... members>
inline constexpr auto count =
    [](const auto& row) -> tables::Field { return tables::field(reached<members...>(row.errors)); };

/// A sum divided by the number of trials.
template <auto... members>
inline constexpr auto per_trial = [](const auto& row) -> tables::Field {
  return static_cast<double>(reached<members...>(row.errors)) / static_cast<double>(row.trials);
};

/// The value; empty where no trial has a proved bound.
template <auto... members>
inline constexpr auto where_bounded = [](const auto& row) -> tables::Field {
  return row.errors.bounded > 0 ? tables::field(reached<members...>(row.errors)) : tables::Field();
};

/// The value; empty where no error was tallied.
template <auto... members>
inline constexpr auto where_any = [](const auto& row) -> tables::Field {
  return row.errors.error.count() > 0 ? tables::field(reached<members...>(row.errors)) : tables::Field();
};

/// The trials that a TrialFailure counts.
template <auto... members>
inline constexpr auto trials =
    [](const auto& row) -> const metric::TrialCount& { return reached<members...>(row.errors); };

}  // namespace column

/// The columns of errors that are tallied as `error` and `error_u`.
template <class Row, class Errors = typename Row::Errors>
inline constexpr std::array error_columns{
    TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
    TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
    TrialColumn<Row>{"p99_error", column::statistic<tables::p99, &Errors::error>},
    TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
    TrialColumn<Row>{"mean_error_u", column::statistic<tables::mean, &Errors::error_u>},
    TrialColumn<Row>{"max_error_u", column::statistic<tables::largest, &Errors::error_u>},
};

/// The columns of both, in this order.
template <class Column, std::size_t first, std::size_t second>
constexpr std::array<Column, first + second> joined(const std::array<Column, first>& a,
                                                    const std::array<Column, second>& b) {
  std::array<Column, first + second> all{};
  std::ranges::copy(b, std::ranges::copy(a, all.begin()).out);
  return all;
}

}  // namespace bezierbench::studies
