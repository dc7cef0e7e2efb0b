// SPDX-License-Identifier: MIT
#include "experiments/studies/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "experiments/failure.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/number/number.hpp"
#include "experiments/studies/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

/// One line of a table that was read.
class Row {
 public:
  Row(const bundle::CsvDocument& table, std::size_t row) : table_(table), row_(row) {}

  [[nodiscard]] const std::string& text(std::string_view column) const { return table_.at(row_, column); }
  [[nodiscard]] double number(std::string_view column) const {
    if (const auto value = number::parse_number(text(column))) return *value;
    throw Failure(Exit::input_output, fmt::format("{}:{}: {} is not a number; run the suite again", table_.file_name(),
                                                  table_.line(row_), column));
  }
  /// Empty for an empty field, and for a column that an older version did not write.
  [[nodiscard]] std::optional<double> optional_number(std::string_view column) const {
    if (!table_.has_column(column) || text(column).empty()) return std::nullopt;
    return number(column);
  }

 private:
  const bundle::CsvDocument& table_;
  std::size_t row_;
};

/// What kind of curves a row is about.
using CurveKind = std::vector<std::string>;

CurveKind kind_of(const Row& row) {
  return {row.text("curve"), row.text("scalar"), row.text("dimension"), row.text("degree")};
}

struct Errors {
  LargestError in_u;
  LargestError absolute;
};

void add(LargestError& all, double observed, std::optional<double> bound, bool is_first) {
  all.observed = is_first ? observed : std::max(all.observed, observed);
  if (is_first)
    all.bound = bound;
  else if (all.bound)
    all.bound = bound ? std::optional(std::max(*all.bound, *bound)) : std::nullopt;
}

/// The errors of the methods of one accuracy study on one kind of curve.
struct Judged {
  std::string study;
  std::map<std::string, Errors> methods;
};

/// Over all cells of the study: ranges, intervals and generators.
void add(Judged& judged, const Row& row) {
  const bool finite = row.number("non_finite") == 0;
  const auto observed = [&](std::string_view column) {
    return finite ? row.number(column) : std::numeric_limits<double>::infinity();
  };
  const auto [place, is_first] = judged.methods.try_emplace(row.text("method"));
  add(place->second.in_u, observed("max_error_u"), row.optional_number("bound_u"), is_first);
  add(place->second.absolute, observed("max_error"), row.optional_number("max_bound"), is_first);
}

using JudgedKinds = std::map<CurveKind, std::vector<Judged>>;

JudgedKinds judged_kinds(std::span<const bundle::CsvDocument> accuracies, const std::string& only) {
  JudgedKinds kinds;
  for (const auto& table : accuracies)
    for (std::size_t at = 0; at < table.row_count(); ++at) {
      const Row row(table, at);
      const auto& study = row.text("study");
      if (row.text("baseline") != "exact" || row.text("status") != "ok" || (!only.empty() && study != only)) continue;
      auto& studies = kinds[kind_of(row)];
      auto found = std::ranges::find(studies, study, &Judged::study);
      if (found == studies.end()) found = studies.insert(studies.end(), {study, {}});
      add(*found, row);
    }
  return kinds;
}

std::vector<std::string> drawn_of(const bundle::CsvDocument& timing, const Row& row) {
  std::vector<std::string> drawn;
  for (const auto& column : drawn_columns())
    if (timing.has_column(column)) drawn.push_back(row.text(column));
  return drawn;
}

/// The groups with the methods that were timed, their errors not yet known.
std::vector<ChoiceGroup> timed_groups(const bundle::CsvDocument& timing) {
  std::vector<ChoiceGroup> groups;
  for (std::size_t at = 0; at < timing.row_count(); ++at) {
    const Row row(timing, at);
    if (row.text("degree").empty()) continue;  // the sentinel
    const ChoiceGroup key{row.text("study"),
                          "",
                          row.text("curve"),
                          row.text("scalar"),
                          row.text("dimension"),
                          row.text("degree"),
                          row.text("mode"),
                          drawn_of(timing, row),
                          {}};
    const auto same = [&](const ChoiceGroup& group) {
      return group.study == key.study && group.curve == key.curve && group.scalar == key.scalar &&
             group.dimension == key.dimension && group.degree == key.degree && group.mode == key.mode &&
             group.drawn == key.drawn;
    };
    auto group = std::ranges::find_if(groups, same);
    if (group == groups.end()) group = groups.insert(groups.end(), key);
    group->choices.push_back({row.text("method"),
                              {row.number("median_ns"), row.number("low_ns"), row.number("high_ns")},
                              row.text("quality"),
                              {},
                              {}});
  }
  return groups;
}

/// The study that judged most of the group's methods; none where no method was judged.
const Judged* best_cover(const ChoiceGroup& group, const JudgedKinds& kinds) {
  const auto studies = kinds.find({group.curve, group.scalar, group.dimension, group.degree});
  if (studies == kinds.end()) return nullptr;
  const auto covered = [&](const Judged& judged) {
    return std::ranges::count_if(group.choices, [&](const Choice& one) { return judged.methods.contains(one.method); });
  };
  const auto best = std::ranges::max_element(studies->second, {}, covered);
  return covered(*best) > 0 ? &*best : nullptr;
}

void fill_errors(ChoiceGroup& group, const Judged& judged) {
  group.accuracy_study = judged.study;
  std::erase_if(group.choices, [&](const Choice& one) { return !judged.methods.contains(one.method); });
  for (auto& choice : group.choices) {
    choice.in_u = judged.methods.at(choice.method).in_u;
    choice.absolute = judged.methods.at(choice.method).absolute;
  }
}

std::string decimal_or_empty(const std::optional<double>& value) { return value ? number::decimal(*value) : ""; }

void add_rows(bundle::CsvTable& table, const ChoiceGroup& group) {
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : group.choices) tradeoffs.push_back({choice.ns, choice.in_u.observed});
  const auto fronts = metric::pareto_front(tradeoffs);
  for (std::size_t m = 0; m < group.choices.size(); ++m) {
    const Choice& choice = group.choices[m];
    std::vector<std::string> row{group.study,
                                 group.accuracy_study,
                                 group.curve,
                                 choice.method,
                                 group.scalar,
                                 group.dimension,
                                 group.degree,
                                 group.mode,
                                 number::decimal(choice.ns.median),
                                 number::decimal(choice.ns.low),
                                 number::decimal(choice.ns.high),
                                 number::decimal(choice.in_u.observed),
                                 decimal_or_empty(choice.in_u.bound),
                                 number::decimal(choice.absolute.observed),
                                 decimal_or_empty(choice.absolute.bound),
                                 choice.quality,
                                 std::string(metric::name(fronts[m]))};
    row.insert(row.end(), group.drawn.begin(), group.drawn.end());
    table.add_row(std::move(row));
  }
}

}  // namespace

std::vector<ChoiceGroup> choice_groups(const bundle::CsvDocument& timing,
                                       std::span<const bundle::CsvDocument> accuracies,
                                       const std::string& accuracy_study) {
  const auto kinds = judged_kinds(accuracies, accuracy_study);
  auto groups = timed_groups(timing);
  std::erase_if(groups, [&](const ChoiceGroup& group) { return best_cover(group, kinds) == nullptr; });
  for (auto& group : groups) fill_errors(group, *best_cover(group, kinds));
  return groups;
}

void write_pareto(Tables& tables) {
  std::optional<bundle::CsvDocument> timing;
  std::vector<bundle::CsvDocument> accuracies;
  for (const auto& [file, table] : tables.all()) {
    if (file == "timing.csv") timing = bundle::parse_csv(table.text(), file);
    if (file == "accuracy.csv" || file == "unstable.csv") accuracies.push_back(bundle::parse_csv(table.text(), file));
  }
  if (!timing) return;
  const auto groups = choice_groups(*timing, accuracies);
  if (groups.empty()) return;
  std::vector<std::string> columns{"study",   "accuracy_study", "curve", "method",  "scalar",  "dimension",
                                   "degree",  "mode",           "ns",    "ns_low",  "ns_high", "observed_max_u",
                                   "bound_u", "observed_max",   "bound", "quality", "pareto"};
  columns.insert(columns.end(), drawn_columns().begin(), drawn_columns().end());
  auto& table = tables.table("pareto.csv", columns);
  for (const auto& group : groups) add_rows(table, group);
}

}  // namespace bezierbench::studies
