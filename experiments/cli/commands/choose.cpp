// SPDX-License-Identifier: MIT
// `choose`: the methods of a bundle that are fast and accurate enough, best first.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/aligned.hpp"
#include "experiments/cli/commands/class_choice.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/damage.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/echo.hpp"
#include "experiments/judge/method_choice.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {
namespace {

struct Wish {
  std::string bundle;
  int degree = 0;
  std::string tolerance_text;
  double tolerance = 0;
  std::string unit = "u";
  std::optional<std::string> range_text;
  std::optional<double> range;
  std::string form = "bernstein";
  std::string mode = "point";
  std::string scalar = "double";
  int dimension = 2;
  std::string study;
  std::string accuracy_study;
  std::string format = "text";
  bool use_damaged = false;
  std::vector<std::string> damaged;  ///< damaged files of the bundle that were used nevertheless

  [[nodiscard]] const tables::LargestError& error_of(const tables::Choice& choice) const {
    return unit == "u" ? choice.errors.in_u : choice.errors.absolute;
  }
};

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
    throw Failure(
        Exit::usage,
        fmt::format("{}: has no times; run a timing suite into it, or choose from another bundle", wish.bundle));
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

/// The methods of one race cell, and the class of curves of the choice.
struct JudgedRace {
  tables::ChoiceGroup group;
  DrawnClass of;
};

std::string in_words(const DrawnClass& of) {
  return fmt::format("coordinates in [{0}, {1}], t in [{2}, {3}]", number::decimal(-of.range),
                     number::decimal(of.range), number::decimal(of.t.min), number::decimal(of.t.max));
}

/// The race cells whose methods were judged on the class of the choice.
std::vector<JudgedRace> judged_races(const std::vector<tables::ChoiceGroup>& groups, const Evidence& evidence,
                                     const Wish& wish) {
  std::vector<JudgedRace> races;
  std::string missing;
  for (auto group : groups) {
    const auto of = class_of(group, evidence.judged, wish.range);
    if (!of) continue;
    missing = fmt::format("{}: nothing with degree {}, {} was judged; ranges of coordinates that were: {}; see --range",
                          wish.bundle, wish.degree, in_words(*of),
                          fmt::join(judged_ranges(group, evidence.judged, wish.accuracy_study), ", "));
    judge_class(group, *of, evidence.judged, evidence.methods, wish.accuracy_study);
    if (!group.choices.empty()) races.push_back({std::move(group), *of});
  }
  if (races.empty()) throw Failure(Exit::usage, missing);
  return races;
}

/// The race cell with the most methods. The output names the others.
JudgedRace one_of(const std::vector<JudgedRace>& races) {
  const auto size = [](const JudgedRace& race) { return race.group.choices.size(); };
  const auto best = std::ranges::max_element(races, {}, size);
  std::vector<std::string> others;
  for (auto race = races.begin(); race != races.end(); ++race)
    if (race != best) others.push_back(fmt::format("{} ({})", race->group.study, fmt::join(race->group.drawn, " ")));
  if (!others.empty())
    say(fmt::format("times of study {} ({}); there are also {}: see --study", best->group.study,
                    fmt::join(best->group.drawn, " "), fmt::join(others, ", ")));
  return *best;
}

bool is_quick_to_slow(const tables::Choice& a, const tables::Choice& b) { return a.ns.median < b.ns.median; }

/// The value to four digits, for people.
std::string brief(double value) { return fmt::format("{:.4g}", value); }

/// The evidence that a method keeps the tolerance, and the bound that proves it.
struct Assurance {
  std::string_view tolerance = "observed";
  std::optional<double> bound;
  std::string_view bound_of;
};

constexpr std::string_view proved = "proved";
constexpr std::string_view proved_for_trials = "proved for the trials";

Assurance assurance(const tables::LargestError& error, double tolerance) {
  const bool by_class = error.class_bound && *error.class_bound <= tolerance;
  if (!by_class && error.bound && *error.bound <= tolerance) return {proved_for_trials, error.bound, "trials"};
  Assurance given;
  if (by_class) given.tolerance = proved;
  given.bound = error.class_bound ? error.class_bound : error.bound;
  given.bound_of = error.class_bound ? "class" : error.bound ? "trials" : "";
  return given;
}

/// The table of the methods within the tolerance, best first. Its column `pareto` compares all methods of the group.
bundle::CsvTable within(const JudgedRace& race, const Wish& wish) {
  const auto write = wish.format == "csv" ? number::decimal : brief;
  const auto& choices = race.group.choices;
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : choices) tradeoffs.push_back({choice.ns, wish.error_of(choice).observed});
  const auto fronts = metric::pareto_front(tradeoffs);
  std::vector<std::string> columns{"method", "mode", "ns",     "ns_low",    "ns_high", "observed_max",
                                   "bound",  "unit", "pareto", "tolerance", "quality", "bound_of"};
  std::vector<std::string> of;  // the same in every row; the heading for people has it
  if (wish.format == "csv") {
    columns.insert(columns.end(), {"coordinate_range", "t_min", "t_max", "least_p_tilde"});
    of = {number::decimal(race.of.range), number::decimal(race.of.t.min), number::decimal(race.of.t.max),
          number::decimal(least_p_tilde(race.group, race.of))};
  }
  bundle::CsvTable table(columns);
  for (std::size_t m = 0; m < choices.size(); ++m) {
    const auto& choice = choices[m];
    const auto& error = wish.error_of(choice);
    if (!(error.observed <= wish.tolerance)) continue;
    const auto sure = assurance(error, wish.tolerance);
    std::vector<std::string> row{choice.method,
                                 race.group.mode,
                                 write(choice.ns.median),
                                 write(choice.ns.low),
                                 write(choice.ns.high),
                                 write(error.observed),
                                 sure.bound ? write(*sure.bound) : "",
                                 wish.unit,
                                 std::string(metric::name(fronts[m])),
                                 std::string(sure.tolerance),
                                 choice.quality,
                                 std::string(sure.bound_of)};
    row.insert(row.end(), of.begin(), of.end());
    table.add_row(std::move(row));
  }
  return table;
}

/// Prints the options and the sources of the numbers, then an explanation of the words in the table.
void print_heading(const JudgedRace& race, const Wish& wish) {
  const auto& group = race.group;
  fmt::print("degree {}, {} form, {}, {} axes, {}\n", printable(group.degree), wish.form, printable(group.scalar),
             printable(group.dimension), in_words(race.of));
  fmt::print("times of study {}, largest errors of all rows on such curves: {}\n", printable(group.study),
             printable(group.accuracy_study));
  fmt::print("{}: for every such curve and t", proved);
  if (wish.unit == "u") fmt::print(" with p~ of at least {}", brief(least_p_tilde(group, race.of)));
  fmt::print("; {}: for the inputs that were judged\n\n", proved_for_trials);
}

std::string none_is_right_enough(const JudgedRace& race, const Wish& wish) {
  const auto best = std::ranges::min_element(
      race.group.choices, {}, [&](const tables::Choice& choice) { return wish.error_of(choice).observed; });
  return fmt::format("{}: no method stays within {} {} at degree {}, {}; the most accurate is {} with {}", wish.bundle,
                     wish.tolerance_text, wish.unit, wish.degree, in_words(race.of), best->method,
                     number::decimal(wish.error_of(*best).observed));
}

void read_numbers(Wish& wish) {
  const auto tolerance = number::parse_number(wish.tolerance_text);
  if (!tolerance || !(*tolerance >= 0) || !std::isfinite(*tolerance))
    throw Failure(Exit::usage, fmt::format("--tolerance {}: is not a number from 0; give the largest error that you "
                                           "accept",
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
  const auto table = within(race, wish);
  print_damage(wish.damaged);
  if (wish.format == "csv") {
    fmt::print("{}", table.text());
  } else {
    print_heading(race, wish);
    fmt::print("{}", aligned_csv(table.text()));
  }
  if (table.row_count() > 0) return Exit::fine;
  say(none_is_right_enough(race, wish));
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
  auto command = program.command("choose", "the methods of a bundle that are right enough, fastest first");
  command.option("bundle", wish->bundle, "folder of the bundle").required();
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
