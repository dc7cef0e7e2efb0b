// SPDX-License-Identifier: MIT
// The columns that a problem adds to the row of a method.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "experiments/judge/case_axes.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/tables/statistics.hpp"

namespace bezierbench::studies {

/// What a row says: how one method did in all trials of a part, at one tolerance.
template <class Kernel, class Errors>
struct TrialRow {
  const sample::Cell& cell;
  judge::CaseValues values;
  const Kernel& method;
  std::int64_t trials;
  const Errors& errors;
};

template <class Row>
struct TrialColumn {
  std::string_view name;
  std::string (*field)(const Row& row);
};

/// What a method says that it keeps and did not: trials that fail the run.
template <class Row>
struct TrialFailure {
  std::string_view what;  ///< for people; empty where nothing else can fail
  const metric::TrialCount& (*trials)(const Row& row);
};

/// Columns of a tally, count or number that is reached from the errors of a row by `members`: pointers to a member of
/// the errors, to a member of that one, and so on.
namespace column {

template <auto... members>
constexpr const auto& reached(const auto& errors) {
  return (errors.*....*members);  // errors.*first.*second
}

template <tables::Statistic which, auto... members>
inline constexpr auto statistic =
    [](const auto& row) -> std::string { return tables::field(reached<members...>(row.errors), which); };

template <auto... members>
inline constexpr auto count =
    [](const auto& row) -> std::string { return tables::field(reached<members...>(row.errors)); };

/// A sum over the number of trials.
template <auto... members>
inline constexpr auto per_trial = [](const auto& row) -> std::string {
  return number::decimal(static_cast<double>(reached<members...>(row.errors)) / static_cast<double>(row.trials));
};

/// Empty where no bound is proved of any trial.
template <auto... members>
inline constexpr auto where_bounded = [](const auto& row) -> std::string {
  return row.errors.bounded > 0 ? tables::field(reached<members...>(row.errors)) : "";
};

/// Empty where no error was tallied.
template <auto... members>
inline constexpr auto where_any = [](const auto& row) -> std::string {
  return row.errors.error.count() > 0 ? tables::field(reached<members...>(row.errors)) : "";
};

/// The trials that a TrialFailure is about.
template <auto... members>
inline constexpr auto trials =
    [](const auto& row) -> const metric::TrialCount& { return reached<members...>(row.errors); };

}  // namespace column

}  // namespace bezierbench::studies
