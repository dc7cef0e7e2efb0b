// SPDX-License-Identifier: MIT
// `choose`: which method of a bundle is fast enough and right enough, best first.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/aligned.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/damage.hpp"
#include "experiments/cli/diagnostics.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/number/number.hpp"
#include "experiments/studies/choices.hpp"
#include "experiments/studies/method_choice.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::cli {
namespace {

struct Wish {
  std::string bundle;
  int degree = 0;
  std::string tolerance_text;
  double tolerance = 0;
  std::string unit = "u";
  std::string form = "bernstein";
  std::string mode = "point";
  std::string scalar = "double";
  int dimension = 2;
  std::string study;
  std::string accuracy_study;
  std::string format = "text";
  bool use_damaged = false;
  std::vector<std::string> damaged;  ///< files of the bundle that were used all the same

  [[nodiscard]] const studies::LargestError& error_of(const studies::Choice& choice) const {
    return unit == "u" ? choice.in_u : choice.absolute;
  }
};

std::string form_name(const studies::ChoiceGroup& group) {
  const auto curve = suite::parse<suite::CurveKind>(group.curve);
  return curve ? std::string(name(studies::form_of(*curve))) : group.curve;
}

std::vector<studies::ChoiceGroup> groups_of(Wish& wish) {
  bundle::CheckedReader reader(wish.bundle, damage_of(wish.use_damaged));
  const auto table = [&](const std::string& file) { return bundle::parse_csv(reader.read(file), reader.place(file)); };
  if (!reader.has("timing.csv"))
    throw Failure(
        Exit::usage,
        fmt::format("{}: has no times; run a timing suite into it, or choose from another bundle", wish.bundle));
  std::vector<bundle::CsvDocument> accuracies;
  for (const std::string file : {"accuracy.csv", "unstable.csv"})
    if (reader.has(file)) accuracies.push_back(table(file));
  const auto timing = table("timing.csv");
  wish.damaged = reader.told();
  return studies::choice_groups(timing, accuracies, wish.accuracy_study);
}

/// One thing that is asked of a group, and what the groups that meet all the others have of it.
struct Demand {
  std::string what;
  std::string value;
  std::string (*of)(const studies::ChoiceGroup& group);
};

std::vector<Demand> demands_of(const Wish& wish) {
  using Group = studies::ChoiceGroup;
  std::vector<Demand> demands{
      {"form", wish.form, form_name},
      {"scalar", wish.scalar, [](const Group& group) { return group.scalar; }},
      {"dimension", std::to_string(wish.dimension), [](const Group& group) { return group.dimension; }},
      {"mode", wish.mode, [](const Group& group) { return group.mode; }},
      {"degree", std::to_string(wish.degree), [](const Group& group) { return group.degree; }}};
  if (!wish.study.empty())
    demands.insert(demands.begin(), {"study", wish.study, [](const Group& group) { return group.study; }});
  return demands;
}

/// The groups that meet all demands; where one leaves none, says what it could have been.
std::vector<studies::ChoiceGroup> matching(std::vector<studies::ChoiceGroup> groups, const Wish& wish) {
  if (groups.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: no method{} has both a time and an error; run a suite that times and one "
                              "that judges the same methods at the same degrees into one bundle",
                              wish.bundle, wish.accuracy_study.empty() ? "" : " of study " + wish.accuracy_study));
  for (const auto& demand : demands_of(wish)) {
    std::vector<std::string> there;
    for (const auto& group : groups)
      if (auto value = demand.of(group); std::ranges::find(there, value) == there.end()) there.push_back(value);
    std::erase_if(groups, [&](const auto& group) { return demand.of(group) != demand.value; });
    if (groups.empty())
      throw Failure(Exit::usage, fmt::format("{}: nothing with {} {} has both a time and an error; there is {}",
                                             wish.bundle, demand.what, demand.value, fmt::join(there, ", ")));
  }
  return groups;
}

/// Of several heats the one with most methods; the others are named.
studies::ChoiceGroup one_of(std::vector<studies::ChoiceGroup> groups) {
  const auto size = [](const studies::ChoiceGroup& group) { return group.choices.size(); };
  const auto best = std::ranges::max_element(groups, {}, size);
  std::vector<std::string> others;
  for (auto group = groups.begin(); group != groups.end(); ++group)
    if (group != best) others.push_back(fmt::format("{} ({})", group->study, fmt::join(group->drawn, " ")));
  if (!others.empty())
    say(fmt::format("times of study {} ({}); there are also {}: see --study", best->study, fmt::join(best->drawn, " "),
                    fmt::join(others, ", ")));
  return *best;
}

bool is_quick_to_slow(const studies::Choice& a, const studies::Choice& b) { return a.ns.median < b.ns.median; }

/// For people: four digits.
std::string brief(double value) { return fmt::format("{:.4g}", value); }

/// Those within the tolerance, best first; `pareto` is among all methods of the group.
bundle::CsvTable within(const studies::ChoiceGroup& group, const Wish& wish) {
  const auto write = wish.format == "csv" ? number::decimal : brief;
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : group.choices) tradeoffs.push_back({choice.ns, wish.error_of(choice).observed});
  const auto fronts = metric::pareto_front(tradeoffs);
  bundle::CsvTable table(
      {"method", "mode", "ns", "ns_low", "ns_high", "observed_max", "bound", "unit", "pareto", "tolerance", "quality"});
  for (std::size_t m = 0; m < group.choices.size(); ++m) {
    const auto& choice = group.choices[m];
    const auto& error = wish.error_of(choice);
    if (!(error.observed <= wish.tolerance)) continue;
    const bool proved = error.bound && *error.bound <= wish.tolerance;
    table.add_row({choice.method, group.mode, write(choice.ns.median), write(choice.ns.low), write(choice.ns.high),
                   write(error.observed), error.bound ? write(*error.bound) : "", wish.unit,
                   std::string(metric::name(fronts[m])), proved ? "proved" : "observed", choice.quality});
  }
  return table;
}

std::string none_is_right_enough(const studies::ChoiceGroup& group, const Wish& wish) {
  const auto best = std::ranges::min_element(
      group.choices, {}, [&](const studies::Choice& choice) { return wish.error_of(choice).observed; });
  return fmt::format("{}: no method of study {} stays within {} {}; the most accurate is {} with {}", wish.bundle,
                     group.accuracy_study, wish.tolerance_text, wish.unit, best->method,
                     number::decimal(wish.error_of(*best).observed));
}

Exit choose(Wish wish) {
  const auto tolerance = number::parse_number(wish.tolerance_text);
  if (!tolerance || !(*tolerance >= 0) || !std::isfinite(*tolerance))
    throw Failure(Exit::usage, fmt::format("--tolerance {}: is not a number from 0; give the largest error that you "
                                           "accept",
                                           wish.tolerance_text));
  wish.tolerance = *tolerance;
  auto groups = groups_of(wish);
  auto group = one_of(matching(std::move(groups), wish));
  std::ranges::stable_sort(group.choices, is_quick_to_slow);
  const auto table = within(group, wish);
  print_damage(wish.damaged);
  if (wish.format == "csv") {
    fmt::print("{}", table.text());
  } else {
    fmt::print("degree {}, {} form, {}, {} axes: times of study {}, largest errors of study {}\n\n", group.degree,
               wish.form, group.scalar, group.dimension, group.study, group.accuracy_study);
    fmt::print("{}", aligned_csv(table.text()));
  }
  if (table.row_count() > 0) return Exit::fine;
  say(none_is_right_enough(group, wish));
  return Exit::finding;
}

std::vector<std::string> words_of_forms() {
  std::vector<std::string> forms;
  for (const auto& entry : suite::words<suite::CurveKind>) forms.emplace_back(name(studies::form_of(entry.value)));
  return forms;
}

}  // namespace

void add_choose(Command program, Exit& exit) {
  auto wish = std::make_shared<Wish>();
  auto command = program.command("choose", "the methods of a bundle that are right enough, fastest first");
  command.option("bundle", wish->bundle, "folder of the bundle").required();
  command.option("--degree", wish->degree, "degree of the curves").required();
  command.option("--tolerance", wish->tolerance_text, "largest error that is accepted").required();
  command.option("--unit", wish->unit, "of the tolerance: u (units of u p~) or coordinate").one_of({"u", "coordinate"});
  command.option("--form", wish->form, "in which the curves are given").one_of(words_of_forms());
  command.option("--mode", wish->mode, "of the times").one_of(suite::all_words<suite::Mode>());
  command.option("--scalar", wish->scalar, "type that the methods compute in")
      .one_of(suite::all_words<suite::ScalarKind>());
  command.option("--dimension", wish->dimension, "axes of the curves");
  command.option("--study", wish->study, "whose times to take, where several have some");
  command.option("--accuracy-study", wish->accuracy_study, "whose errors to take, where several have some");
  command.option("--format", wish->format, "text or csv").one_of({"text", "csv"});
  add_damaged(command, wish->use_damaged);
  command.action([wish, &exit] { exit = choose(*wish); });
}

}  // namespace bezierbench::cli
