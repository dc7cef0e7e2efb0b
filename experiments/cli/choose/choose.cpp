// SPDX-License-Identifier: MIT
// `choose`: the methods of a bundle that are fast and accurate enough, best first.
#include "experiments/cli/choose/choose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/choices.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using tables::Choice;
using tables::ChoiceGroup;

/// The tables of a bundle that a choice uses.
struct Evidence {
  bundle::CsvDocument timing;
  std::optional<bundle::CsvDocument> cost;
  tables::JudgedTables judged;
  std::optional<bundle::CsvDocument> methods;
};

/// The methods of one race, the fastest first, and the class of curves of the choice.
struct JudgedRace {
  ChoiceGroup group;
  DrawnClass of;
  std::vector<std::string> cells;  ///< in which the methods were judged
};

constexpr std::string_view proved = "proved";
constexpr std::string_view proved_for_trials = "proved for the trials";

/// A method within the tolerance, with the evidence that it keeps it.
struct Candidate {
  const Choice* choice;
  double error;  ///< the largest that was observed, in the unit of the tolerance
  std::string_view assurance = "observed";
  std::optional<double> bound = {};  ///< the bound that proves it, or the only one there is
  std::string_view bound_of = {};    ///< `class` or `trials`
  metric::Front front = metric::Front::on;
};

/// `coordinates in [-1, 1], t in [0, 1]`.
std::string class_words(const DrawnClass& of) {
  const auto words = fmt::format("coordinates in [{0}, {1}], t in [{2}, {3}]", number::decimal(-of.range),
                                 number::decimal(of.range), number::decimal(of.t.min), number::decimal(of.t.max));
  if (of.exponent == 0) return words;
  return fmt::format("{}; judged in [{}, {}], times 2^{}", words, number::decimal(-of.judged_range()),
                     number::decimal(of.judged_range()), of.exponent);
}

/// The timing study and how its curves were drawn: `speed-bezier: coordinates in [-1, 1], t in [0, 1], continuous`.
std::string timed_curves(const JudgedRace& race) {
  auto text = fmt::format("{}: {}", race.group.study, class_words(race.of));
  constexpr std::size_t generator = 3;
  return generator < race.group.drawn.size() ? fmt::format("{}, {}", text, race.group.drawn[generator]) : text;
}

/// The command that makes a bundle in which such a choice can be made, as the end of a message. Empty where no suite
/// that comes with the program has errors and times of such methods.
std::string remedy(const Wish& wish) {
  // as in the ids of studies
  const std::string_view form = wish.form == name(Form::bernstein) ? "bezier"
                                : wish.form == name(Form::power)   ? "polynomial"
                                                                   : "rational";
  const bool in_quick = wish.mode == suite::name(suite::Mode::point) || wish.mode == suite::name(suite::Mode::one_shot);
  const bool can_be_run = wish.degree >= 0 && wish.degree <= max_degree && wish.dimension >= 1 && wish.dimension <= 3;
  if (!can_be_run || (!in_quick && form == name(Form::rational))) return "";
  const std::string suite = in_quick ? "quick" : "speed";
  std::string out = fmt::format("{}-{}", suite, wish.degree);
  while (std::filesystem::exists(out)) out += "-new";
  std::string set = fmt::format("--set degree={}", wish.degree);
  if (wish.range) set += fmt::format(" --set coordinate_range={}", number::decimal(*wish.range));
  if (wish.scalar != suite::name(suite::ScalarKind::float64)) set += " --set scalar=" + wish.scalar;
  if (wish.dimension != Wish().dimension) set += fmt::format(" --set dimension={}", wish.dimension);
  return fmt::format("; `{} run {} --only '{}*-{}{}' {} --out {}` makes a suitable bundle", this_program(), suite,
                     suite, form, in_quick ? "*" : "", set, out);
}

[[noreturn]] void refuse(const Wish& wish, const std::string& what) {
  throw Failure(Exit::usage, "{}: {}{}", wish.bundle, what, remedy(wish));
}

Evidence read_evidence(const Wish& wish) {
  const auto bundle = bundle::BundleDirectory::open(wish.bundle);
  auto timing = bundle.table("timing.csv");
  if (!timing) refuse(wish, "does not have times; choose from another bundle");
  std::vector<bundle::CsvDocument> accuracies;
  for (const auto* file : {"accuracy.csv", "unstable.csv"})
    if (auto found = bundle.table(file)) accuracies.push_back(std::move(*found));
  return {std::move(*timing), bundle.table("cost.csv"), tables::JudgedTables(std::move(accuracies)),
          bundle.table("methods.csv")};
}

/// The counted instructions of the methods, where the bundle has them.
void set_instructions(const Evidence& evidence, ChoiceGroup& group) {
  if (!evidence.cost) return;
  for (const auto& row : tables::rows_of(*evidence.cost)) {
    if (row.text("study") != group.study || row.text("form") != group.form || row.text("scalar") != group.scalar ||
        row.text("dimension") != group.dimension || row.text("degree") != group.degree ||
        row.text("mode") != group.mode)
      continue;
    const auto found = std::ranges::find(group.choices, row.text("method"), &Choice::method);
    if (found != group.choices.end()) found->instructions = row.number("instructions");
  }
}

/// The races of the wish. Where there is none, throws Failure with the values that are available.
std::vector<ChoiceGroup> races_of(const Evidence& evidence, const Wish& wish) {
  auto groups = tables::timed_groups(tables::rows_of(evidence.timing));
  std::erase_if(groups, [&](const ChoiceGroup& group) {
    return judged_ranges(group, evidence.judged, wish.accuracy_study).empty();
  });
  if (groups.empty())
    refuse(wish, fmt::format("no method{} has both a time and an error; choose from another bundle",
                             wish.accuracy_study.empty() ? "" : " of study " + wish.accuracy_study));
  const auto require = [&](std::string_view what, const std::string& wanted, std::string ChoiceGroup::*field) {
    std::vector<std::string> available;
    for (const auto& group : groups)
      if (std::ranges::find(available, group.*field) == available.end()) available.push_back(group.*field);
    std::erase_if(groups, [&](const ChoiceGroup& group) { return group.*field != wanted; });
    if (groups.empty())
      refuse(wish, fmt::format("no method has both a time and an error at {} {} (available: {})", what, wanted,
                               fmt::join(available, ", ")));
  };
  if (!wish.study.empty()) require("study", wish.study, &ChoiceGroup::study);
  require("form", wish.form, &ChoiceGroup::form);
  require("scalar", wish.scalar, &ChoiceGroup::scalar);
  require("dimension", std::to_string(wish.dimension), &ChoiceGroup::dimension);
  require("mode", wish.mode, &ChoiceGroup::mode);
  require("degree", std::to_string(wish.degree), &ChoiceGroup::degree);
  return groups;
}

/// The races whose methods were judged on the class of the choice, that with the most methods first.
std::vector<JudgedRace> judged_races(const Evidence& evidence, const Wish& wish) {
  std::vector<JudgedRace> races;
  std::string missing;  // of the first, which most of the users of a bundle are after
  for (auto group : races_of(evidence, wish)) {
    const auto asked = class_of(group, wish.range);
    if (!asked) continue;
    const auto judged = judged_ranges(group, evidence.judged, wish.accuracy_study);
    const auto of =
        scaled_to(*asked, class_of(group, {})->range, judged, wish.scalar == suite::name(suite::ScalarKind::float32))
            .value_or(*asked);
    if (missing.empty())
      missing =
          fmt::format("no timed method was judged at degree {} with {} (judged ranges of coordinates: {}); see --range",
                      wish.degree, class_words(*asked), fmt::join(judged, ", "));
    auto cells = judge_class(group, of, evidence.judged, evidence.methods, wish.accuracy_study);
    std::ranges::stable_sort(group.choices, {}, [](const Choice& choice) { return choice.time().median; });
    set_instructions(evidence, group);
    if (!group.choices.empty()) races.push_back({std::move(group), of, std::move(cells)});
  }
  if (races.empty())
    refuse(wish, missing.empty() ? "timing.csv does not state the range of the timed curves in numbers" : missing);
  std::ranges::stable_sort(races, std::greater(), [](const JudgedRace& race) { return race.group.choices.size(); });
  return races;
}

/// The methods within the tolerance, in the order of the race.
std::vector<Candidate> candidates_of(const JudgedRace& race, const Wish& wish) {
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : race.group.choices) tradeoffs.push_back({choice.time(), wish.error_of(choice).observed});
  const auto fronts = metric::pareto_front(tradeoffs);
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < fronts.size(); ++k) {
    const auto& choice = race.group.choices[k];
    const auto& error = wish.error_of(choice);
    if (error.observed > wish.tolerance) continue;
    const auto within = [&](const std::optional<double>& bound) { return bound && *bound <= wish.tolerance; };
    Candidate one{.choice = &choice, .error = error.observed, .front = fronts[k]};
    const bool by_trials = !within(error.class_bound) && within(error.bound);
    one.assurance = within(error.class_bound) ? proved : by_trials ? proved_for_trials : "observed";
    one.bound = by_trials || !error.class_bound ? error.bound : error.class_bound;
    one.bound_of = !one.bound ? "" : by_trials || !error.class_bound ? "trials" : "class";
    candidates.push_back(one);
  }
  return candidates;
}

std::string in_few_words(const Candidate& one, const Wish& wish) {
  const auto& choice = *one.choice;
  const auto time = choice.ratio ? fmt::format("{} times the time of {}", ratio_text(choice), choice.relative_to)
                                 : fmt::format("{} ns a point", brief(choice.ns.median));
  return fmt::format("{}, error {} {}", time, brief(one.error), wish.unit_words());
}

/// The fastest method and why it is the first, and what speaks for others. At least one method must be within.
std::string winner_text(const std::vector<Candidate>& candidates, const JudgedRace& race, const Wish& wish) {
  const auto& best = candidates.front();
  auto text =
      paragraph(fmt::format("{} of {} methods are within {} {}; the fastest: {}", candidates.size(),
                            race.group.choices.size(), wish.tolerance_text, wish.unit_words(), best.choice->method)) +
      indented(fmt::format("{}; {}", in_few_words(best, wish), best.assurance));
  constexpr std::size_t most_named = 2;
  std::vector<std::string> equals;
  for (const auto& one : candidates)
    if (&one != &best && one.choice->time().low <= best.choice->time().high) equals.push_back(one.choice->method);
  const auto count = equals.size();
  equals.resize(std::min(count, most_named));
  if (count > 0)
    text += indented(fmt::format("not certainly faster than {}{}", fmt::join(equals, ", "),
                                 count > most_named ? fmt::format(" and {} more", count - most_named) : ""));
  const auto sure = std::ranges::find(candidates, proved, &Candidate::assurance);
  if (best.assurance != proved && sure != candidates.end())
    text += indented(fmt::format("the fastest with a proof: {}", sure->choice->method)) +
            indented(in_few_words(*sure, wish));
  return text + "\n";
}

/// The class, the cells that the errors are of, and an explanation of the words in the table.
std::string heading_text(const std::vector<JudgedRace>& races, const Wish& wish) {
  const auto& race = races.front();
  const auto& group = race.group;
  auto text = paragraph(fmt::format("degree {}, {} form, {}, {} axes, mode {}", group.degree, wish.form, group.scalar,
                                    group.dimension, group.mode)) +
              paragraph(class_words(race.of)) +
              paragraph(fmt::format("times of study {}; largest errors of {} cell{}:", group.study, race.cells.size(),
                                    race.cells.size() == 1 ? "" : "s"));
  constexpr std::size_t most_cells = 4;
  for (std::size_t k = 0; k < std::min(most_cells, race.cells.size()); ++k) text += indented(race.cells[k]);
  if (race.cells.size() > most_cells) text += indented(fmt::format("and {} more", race.cells.size() - most_cells));
  if (races.size() > 1) text += paragraph("other timing studies, see --study:");
  for (std::size_t k = 1; k < races.size(); ++k) text += indented(timed_curves(races[k]));
  if (wish.unit == "u")
    text += paragraph(fmt::format("error, bound: in u p~ = 2^-{} sum |b_i| B_i(t)", group.scalar == "float" ? 24 : 53));
  const auto scope =
      wish.unit == "u" ? fmt::format(" with p~ of at least {}", brief(least_p_tilde(group, race.of))) : "";
  return text +
         paragraph(
             fmt::format("within: proved for every such curve and t{}; trials: proved for the judged inputs only; "
                         "observed: on these inputs, without a proof",
                         scope)) +
         paragraph(
             fmt::format("ratio: of the time to that of {}, measured side by side; ns, in a wide terminal: about, "
                         "on the machine of the bundle",
                         group.choices.front().relative_to)) +
         paragraph("*: no other method is both faster and more accurate; ?: the times do not decide that") + "\n";
}

std::string methods_table(const std::vector<Candidate>& candidates) {
  std::vector<std::vector<std::string>> lines{{"  method", "ratio", "error", "bound", "within", "instructions", "ns"}};
  for (const auto& one : candidates)
    lines.push_back({marked(one.choice->method, one.front), ratio_text(*one.choice), in_table(one.error),
                     one.bound ? in_table(*one.bound) : "",
                     std::string(one.assurance == proved_for_trials ? "trials" : one.assurance),
                     one.choice->instructions ? in_table(*one.choice->instructions) : "",
                     in_table(one.choice->ns.median)});
  constexpr std::size_t optional = 2;  // columns
  return fitted(std::move(lines), terminal_width(STDOUT_FILENO), optional);
}

bundle::CsvTable csv_table(const std::vector<Candidate>& candidates, const JudgedRace& race, const Wish& wish) {
  bundle::CsvTable table(
      {"method", "mode",          "ns",        "ns_low",    "ns_high",    "observed_max",     "bound",
       "unit",   "pareto",        "tolerance", "quality",   "bound_of",   "coordinate_range", "t_min",
       "t_max",  "least_p_tilde", "ratio",     "ratio_low", "ratio_high", "relative_to",      "instructions"});
  for (const auto& one : candidates) {
    const auto& [method, ns, quality, errors, ratio, relative_to, instructions] = *one.choice;
    table.add_row(tables::texts(method, race.group.mode, ns.median, ns.low, ns.high, one.error, one.bound, wish.unit,
                                metric::name(one.front), one.assurance, quality, one.bound_of, race.of.range,
                                race.of.t.min, race.of.t.max, least_p_tilde(race.group, race.of),
                                end_of(ratio, &metric::Interval::median), end_of(ratio, &metric::Interval::low),
                                end_of(ratio, &metric::Interval::high), relative_to, instructions));
  }
  return table;
}

std::string none_is_accurate_enough(const JudgedRace& race, const Wish& wish) {
  const auto error = [&](const Choice& choice) { return wish.error_of(choice).observed; };
  const auto best = std::ranges::min_element(race.group.choices, {}, error);
  return fmt::format("{}: no method stays within {} at degree {}, {}; the most accurate is {} with {} {}{}",
                     wish.bundle, wish.tolerance_text, wish.degree, class_words(race.of), best->method,
                     brief(error(*best)), wish.unit_words(),
                     wish.unit == "u" ? "; --unit coordinate takes a tolerance in coordinates" : "");
}

void read_numbers(Wish& wish) {
  if (wish.degree_text) {
    const auto degree = number::parse_integer(*wish.degree_text);
    if (!degree || *degree < 0 || *degree > max_degree)
      throw Failure(Exit::usage, "--degree {}: must be a whole number from 0 to {}", *wish.degree_text, max_degree);
    wish.degree = static_cast<int>(*degree);
  }
  if (wish.tolerance_text.empty()) return;  // only with --curves
  const auto tolerance = number::parse_number(wish.tolerance_text);
  if (!tolerance || !(*tolerance >= 0) || !std::isfinite(*tolerance))
    throw Failure(Exit::usage, "--tolerance {}: is not a number from 0 on; give the largest error that you accept",
                  wish.tolerance_text);
  wish.tolerance = *tolerance;
  if (!wish.range_text) return;
  wish.range = number::parse_number(*wish.range_text);
  if (!wish.range || !(*wish.range > 0) || !std::isfinite(*wish.range))
    throw Failure(Exit::usage, "--range {}: is not a number above 0; give the largest coordinate of your curves",
                  *wish.range_text);
}

Exit choose(Wish wish) {
  if (!wish.problem.empty()) {
    if (wish.bundle.empty() || !wish.degree_text)
      throw Failure(Exit::usage, "--problem: must come with BUNDLE and --degree");
    return choose_companion(wish);
  }
  if (!wish.curves.empty()) {
    if (!wish.bundle.empty())
      throw Failure(Exit::usage, "--curves: cannot be combined with the bundle {}; remove one of them", wish.bundle);
    read_numbers(wish);
    return choose_on_curves(wish);
  }
  for (const auto& [option, is_missing] :
       {std::pair("BUNDLE", wish.bundle.empty()), std::pair("--degree", !wish.degree_text),
        std::pair("--tolerance", wish.tolerance_text.empty())})
    if (is_missing) throw Failure(Exit::usage, "{} is required; or name files of curves by --curves", option);
  if (wish.unit != "u" && wish.unit != "coordinate")
    throw Failure(Exit::usage, "--unit {}: is for --curves; a bundle states largest errors in u or coordinate",
                  wish.unit);
  read_numbers(wish);
  const auto evidence = read_evidence(wish);
  const auto races = judged_races(evidence, wish);
  const auto& race = races.front();
  const auto candidates = candidates_of(race, wish);
  if (wish.format == "csv") {
    for (std::size_t k = 1; k < races.size(); ++k)
      say(fmt::format("times of another study are left out: {}; see --study", timed_curves(races[k])));
    fmt::print("{}", csv_table(candidates, race, wish).text());
  } else if (!candidates.empty()) {
    fmt::print("{}{}{}", winner_text(candidates, race, wish), heading_text(races, wish), methods_table(candidates));
  }
  if (!candidates.empty()) return Exit::fine;
  say(none_is_accurate_enough(race, wish));
  return Exit::finding;
}

}  // namespace

void add_choose(Command program, Exit& exit) {
  auto wish = std::make_shared<Wish>();
  auto command = program.command("choose", "list the methods that are accurate enough, of a bundle or on given curves");
  command.option("BUNDLE", wish->bundle, "folder of the bundle; none with --curves").takes(bundle_value);
  command.option("--curves", wish->curves, "curve files or ids of shipped curve sets on which methods are judged")
      .takes("FILE", shipped_curves);
  command.option("--degree", wish->degree_text, "degree of the curves; with --curves, default: all");
  command.option("--tolerance", wish->tolerance_text, "the largest error that is accepted; optional with --curves");
  command
      .option("--unit", wish->unit,
              "unit of the tolerance: u (units of u p~) or coordinate; with --curves also ulp and size")
      .one_of({"u", "ulp", "coordinate", "size"});
  command.flag("--measure", wish->measure,
               "with --curves: measure times instead of taking those of the shipped answers");
  command
      .option("--problem", wish->problem,
              "rank the methods of a companion problem instead of evaluators; --tolerance is then that of its study")
      .one_of(companion_problems());
  command.option("--range", wish->range_text, "R of coordinates in [-R, R]; default: that of the timed curves");
  command.option("--form", wish->form, "form of the given curves").one_of(suite::all_words<Form>());
  command.option("--mode", wish->mode, "mode of the times").one_of(suite::all_words<suite::Mode>());
  command.option("--scalar", wish->scalar, "type that the methods compute in")
      .one_of(suite::all_words<suite::ScalarKind>());
  command.option("--dimension", wish->dimension, "number of axes of the curves");
  command.option("--study", wish->study, "the study whose times are used, where several have some");
  command.option("--accuracy-study", wish->accuracy_study, "the study whose errors are used, where several have some");
  command.option("--format", wish->format, "text or csv").one_of({"text", "csv"});
  command.action([wish, &exit] { exit = choose(*wish); });
}

}  // namespace bezierbench::cli
