// SPDX-License-Identifier: MIT
#include "experiments/tables/choices.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "experiments/metric/pareto.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::tables {
namespace {

/// Form, scalar, dimension and degree of the curves that a row is about, and their set and placement; these are empty
/// for drawn curves.
using CurveKind = std::vector<std::string>;

std::string set_of(const std::string& curves, const std::string& placement) {
  return curves.empty() ? "" : curves + ' ' + placement;
}

CurveKind kind_of(const TableRow& row) {
  return {row.text("form"), row.text("scalar"), text(row.field("dimension")), text(row.field("degree")),
          row.has("curves") ? set_of(row.text("curves"), row.text("generator")) : ""};
}

CurveKind kind_of(const ChoiceGroup& group) {
  constexpr std::size_t placement = 3;  // of drawn_columns()
  constexpr std::size_t curves = 4;
  return {group.form, group.scalar, group.dimension, group.degree,
          curves < group.drawn.size() ? set_of(group.drawn[curves], group.drawn[placement]) : ""};
}

/// The errors of the methods of one accuracy study on one kind of curve.
struct Judged {
  std::string study;
  std::map<std::string, LargestErrors> methods;
};

using JudgedKinds = std::map<CurveKind, std::vector<Judged>>;

/// The errors of every method in every study, over all ranges, intervals and generators.
JudgedKinds judged_kinds(const JudgedTables& tables) {
  JudgedKinds kinds;
  tables.each_row("", [&](const TableRow& row) {
    const auto& study = row.text("study");
    auto& studies = kinds[kind_of(row)];
    auto found = std::ranges::find(studies, study, &Judged::study);
    if (found == studies.end()) found = studies.insert(studies.end(), {study, {}});
    found->methods[row.text("method")].add(row);
  });
  return kinds;
}

std::vector<std::string> drawn_of(const TableRow& row) {
  std::vector<std::string> drawn;
  for (const auto& column : drawn_columns())
    if (row.has(column)) drawn.push_back(text(row.field(column)));
  return drawn;
}

/// The study that judged most of the group's methods; null where none was judged.
const Judged* best_cover(const ChoiceGroup& group, const JudgedKinds& kinds) {
  const auto studies = kinds.find(kind_of(group));
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
  for (auto& choice : group.choices) choice.errors = judged.methods.at(choice.method);
}

void add_rows(Tables& tables, const ChoiceGroup& group) {
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : group.choices) tradeoffs.push_back({choice.time(), choice.errors.in_u.observed});
  const auto fronts = metric::pareto_front(tradeoffs);
  for (std::size_t m = 0; m < group.choices.size(); ++m) {
    const Choice& choice = group.choices[m];
    tables.add(Row("pareto.csv")
                   .set("study", group.study)
                   .set("accuracy_study", group.accuracy_study)
                   .set("form", group.form)
                   .set("method", choice.method)
                   .set("scalar", group.scalar)
                   .set("dimension", group.dimension)
                   .set("degree", group.degree)
                   .set("mode", group.mode)
                   .set("ns", choice.ns.median)
                   .set("ns_low", choice.ns.low)
                   .set("ns_high", choice.ns.high)
                   .set("observed_max_u", choice.errors.in_u.observed)
                   .set("bound_u", choice.errors.in_u.bound)
                   .set("observed_max", choice.errors.absolute.observed)
                   .set("bound", choice.errors.absolute.bound)
                   .set("quality", choice.quality)
                   .set("pareto", metric::name(fronts[m]))
                   .set_each(drawn_columns(), group.drawn));
  }
}

}  // namespace

void LargestError::add(double seen, std::optional<double> proved, bool is_first) {
  observed = is_first ? seen : std::max(observed, seen);
  if (is_first)
    bound = proved;
  else if (bound)
    bound = proved ? std::optional(std::max(*bound, *proved)) : std::nullopt;
}

void LargestErrors::add(const TableRow& row, double scale) {
  const bool finite = row.number("non_finite") == 0;
  const auto observed = [&](std::string_view column) {
    return finite ? row.number(column) : std::numeric_limits<double>::infinity();
  };
  in_u.add(observed("max_error_u"), bound(row, "bound_u"), rows == 0);
  auto absolute_bound = bound(row, "max_bound");
  if (absolute_bound) *absolute_bound *= scale;
  absolute.add(scale * observed("max_error"), absolute_bound, rows == 0);
  ++rows;
}

std::vector<ChoiceGroup> timed_groups(const std::vector<TableRow>& timing) {
  std::vector<ChoiceGroup> groups;
  for (const TableRow& row : timing) {
    if (row.field("degree") == Field()) continue;  // the row of a sentinel
    const ChoiceGroup key{row.text("study"),
                          "",
                          row.text("form"),
                          row.text("scalar"),
                          text(row.field("dimension")),
                          text(row.field("degree")),
                          row.text("mode"),
                          drawn_of(row),
                          {}};
    const auto same = [&](const ChoiceGroup& group) {
      return group.study == key.study && group.form == key.form && group.scalar == key.scalar &&
             group.dimension == key.dimension && group.degree == key.degree && group.mode == key.mode &&
             group.drawn == key.drawn;
    };
    auto group = std::ranges::find_if(groups, same);
    if (group == groups.end()) group = groups.insert(groups.end(), key);
    group->choices.push_back({row.text("method"),
                              {row.number("median_ns"), row.number("low_ns"), row.number("high_ns")},
                              row.text("quality"),
                              {}});
    auto& choice = group->choices.back();
    if (!row.optional_number("ratio")) continue;
    choice.ratio = metric::Interval{row.number("ratio"), row.number("ratio_low"), row.number("ratio_high")};
    choice.relative_to = row.text("relative_to");
  }
  return groups;
}

std::vector<ChoiceGroup> choice_groups(const std::vector<TableRow>& timing, const JudgedTables& judged) {
  const auto kinds = judged_kinds(judged);
  auto groups = timed_groups(timing);
  std::erase_if(groups, [&](const ChoiceGroup& group) { return best_cover(group, kinds) == nullptr; });
  for (auto& group : groups) fill_errors(group, *best_cover(group, kinds));
  return groups;
}

void write_pareto(Tables& tables) {
  const auto* timing = tables.find("timing.csv");
  if (timing == nullptr) return;
  for (const auto& group : choice_groups(rows_of(*timing), JudgedTables(tables))) add_rows(tables, group);
}

}  // namespace bezierbench::tables
