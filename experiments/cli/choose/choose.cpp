// SPDX-License-Identifier: MIT
// `choose`: the methods of a bundle that are fast and accurate enough, best first.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/choose/choice.hpp"
#include "experiments/cli/choose/class_choice.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/damage.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/echo.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {
namespace {

std::string form_name(const tables::ChoiceGroup& group) {
  const auto curve = suite::parse<Form>(group.curve);
  return curve ? std::string(name(*curve)) : group.curve;
}

/// The tables of a bundle that a choice uses.
struct Evidence {
  bundle::CsvDocument timing;
  tables::JudgedTables judged;
  std::optional<bundle::CsvDocument> methods;
};

Evidence read_evidence(Wish& wish) {
  bundle::CheckedReader reader(wish.bundle, damage_of(wish.use_damaged));
  const auto table = [&](const std::string& file) -> std::optional<bundle::CsvDocument> {
    if (!reader.has(file)) return std::nullopt;
    return bundle::parse_csv(reader.read(file), reader.place(file));
  };
  auto timing = table("timing.csv");
  if (!timing)
    throw Failure(Exit::usage,
                  fmt::format("{}: does not have times; choose from another bundle{}", wish.bundle, remedy(wish)));
  std::vector<bundle::CsvDocument> accuracies;
  for (const std::string file : {"accuracy.csv", "unstable.csv"})
    if (auto found = table(file)) accuracies.push_back(std::move(*found));
  Evidence evidence{std::move(*timing), tables::JudgedTables(std::move(accuracies), table("reference.csv")),
                    table("methods.csv")};
  wish.damaged = reader.told();
  return evidence;
}

/// One demand on a group of races: what it is about, the value that is demanded, and the value of a group.
struct Demand {
  std::string what;
  std::string value;
  std::string (*of)(const tables::ChoiceGroup& group);
};

std::vector<Demand> demands_of(const Wish& wish) {
  using Group = tables::ChoiceGroup;
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

/// The groups that meet all demands. Where there is none, throws Failure with the values that a demand could have.
std::vector<tables::ChoiceGroup> matching(std::vector<tables::ChoiceGroup> groups, const Wish& wish) {
  if (groups.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: no method{} has both a time and an error; choose from another bundle{}", wish.bundle,
                              wish.accuracy_study.empty() ? "" : " of study " + wish.accuracy_study, remedy(wish)));
  for (const auto& demand : demands_of(wish)) {
    std::vector<std::string> there;
    for (const auto& group : groups)
      if (auto value = demand.of(group); std::ranges::find(there, value) == there.end()) there.push_back(value);
    std::erase_if(groups, [&](const auto& group) { return demand.of(group) != demand.value; });
    if (groups.empty())
      throw Failure(Exit::usage,
                    fmt::format("{}: no method has both a time and an error at {} {} (available: {}){}", wish.bundle,
                                demand.what, demand.value, fmt::join(there, ", "), remedy(wish)));
  }
  return groups;
}

/// The races whose methods were judged on the class of the choice.
std::vector<JudgedRace> judged_races(const std::vector<tables::ChoiceGroup>& groups, const Evidence& evidence,
                                     const Wish& wish) {
  std::vector<JudgedRace> races;
  std::string missing;  // of the first, which most of the users of a bundle are after
  for (auto group : groups) {
    const auto of = class_of(group, wish.range);
    if (!of) continue;
    if (missing.empty())
      missing = fmt::format(
          "{}: no timed method was judged at degree {} with {} (judged ranges of coordinates: {}); see --range{}",
          wish.bundle, wish.degree, in_words(*of),
          fmt::join(judged_ranges(group, evidence.judged, wish.accuracy_study), ", "), remedy(wish));
    auto cells = judge_class(group, *of, evidence.judged, evidence.methods, wish.accuracy_study);
    if (!group.choices.empty()) races.push_back({std::move(group), *of, std::move(cells)});
  }
  if (missing.empty() && races.empty())
    missing = fmt::format("{}: timing.csv does not state the range of the timed curves in numbers{}", wish.bundle,
                          remedy(wish));
  if (races.empty()) throw Failure(Exit::usage, missing);
  return races;
}

/// The race with the most methods, with the names of the others.
JudgedRace one_of(const std::vector<JudgedRace>& races) {
  const auto size = [](const JudgedRace& race) { return race.group.choices.size(); };
  const auto best = std::ranges::max_element(races, {}, size);
  auto chosen = *best;
  for (auto race = races.begin(); race != races.end(); ++race)
    if (race != best) chosen.others.push_back(timed_curves(*race));
  return chosen;
}

bool is_quick_to_slow(const tables::Choice& a, const tables::Choice& b) { return a.ns.median < b.ns.median; }

std::string none_is_accurate_enough(const JudgedRace& race, const Wish& wish) {
  const auto best = std::ranges::min_element(
      race.group.choices, {}, [&](const tables::Choice& choice) { return wish.error_of(choice).observed; });
  return fmt::format("{}: no method stays within {} at degree {}, {}; the most accurate is {} with {}{}", wish.bundle,
                     wish.tolerance_text, wish.degree, in_words(race.of), best->method, error_text(*best, wish),
                     wish.unit == "u" ? "; --unit coordinate takes a tolerance in coordinates" : "");
}

void read_numbers(Wish& wish) {
  const auto tolerance = number::parse_number(wish.tolerance_text);
  if (!tolerance || !(*tolerance >= 0) || !std::isfinite(*tolerance))
    throw Failure(Exit::usage, fmt::format("--tolerance {}: is not a number from 0 on; give the largest error that "
                                           "you accept",
                                           wish.tolerance_text));
  wish.tolerance = *tolerance;
  if (!wish.range_text) return;
  wish.range = number::parse_number(*wish.range_text);
  if (!wish.range || !(*wish.range > 0) || !std::isfinite(*wish.range))
    throw Failure(Exit::usage, fmt::format("--range {}: is not a number above 0; give the largest coordinate of your "
                                           "curves",
                                           *wish.range_text));
}

Exit choose(Wish wish) {
  read_numbers(wish);
  const auto evidence = read_evidence(wish);
  auto groups = tables::timed_groups(evidence.timing);
  std::erase_if(groups, [&](const tables::ChoiceGroup& group) {
    return judged_ranges(group, evidence.judged, wish.accuracy_study).empty();
  });
  auto race = one_of(judged_races(matching(std::move(groups), wish), evidence, wish));
  std::ranges::stable_sort(race.group.choices, is_quick_to_slow);
  print_damage(wish.damaged);
  if (wish.format == "csv") {
    for (const auto& other : race.others)
      say(fmt::format("times of another study are left out: {}; see --study", other));
    fmt::print("{}", csv_table(race, wish).text());
  } else {
    fmt::print("{}", choice_text(race, wish));
  }
  if (!within(race, wish).empty()) return Exit::fine;
  say(none_is_accurate_enough(race, wish));
  return Exit::finding;
}

std::vector<std::string> words_of_forms() {
  std::vector<std::string> forms;
  for (const auto& entry : suite::words<Form>) forms.emplace_back(name(entry.value));
  return forms;
}

}  // namespace

void add_choose(Command program, Exit& exit) {
  auto wish = std::make_shared<Wish>();
  auto command = program.command("choose", "list the methods of a bundle that are accurate enough, fastest first");
  command.option("BUNDLE", wish->bundle, "folder of the bundle").required();
  command.option("--degree", wish->degree, "degree of the curves").required();
  command.option("--tolerance", wish->tolerance_text, "largest error that is accepted").required();
  command.option("--unit", wish->unit, "of the tolerance: u (units of u p~) or coordinate").one_of({"u", "coordinate"});
  command.option("--range", wish->range_text, "R of coordinates in [-R, R]; left out, that of the timed curves");
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
