// SPDX-License-Identifier: MIT
#include "experiments/cli/choose/choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "experiments/cli/terminal/fitted.hpp"
#include "experiments/cli/terminal/shell_word.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/echo.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

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

/// Whether each method of the race is worth choosing, compared with all others.
std::vector<metric::Front> fronts(const JudgedRace& race, const Wish& wish) {
  std::vector<metric::Tradeoff> tradeoffs;
  for (const auto& choice : race.group.choices) tradeoffs.push_back({choice.ns, wish.error_of(choice).observed});
  return metric::pareto_front(tradeoffs);
}

std::string_view unit_words(const Wish& wish) { return wish.unit == "u" ? "u p~" : "coordinate units"; }

std::string in_few_words(const tables::Choice& choice, const Wish& wish) {
  return fmt::format("{:.4g} ns [{:.4g}, {:.4g}] a point, error {}", choice.ns.median, choice.ns.low, choice.ns.high,
                     error_text(choice, wish));
}

/// Lines in the width of the terminal, those after the first four characters to the right.
std::string paragraph(const std::string& text) { return wrapped("", text, 4); }
std::string indented(const std::string& text) { return wrapped("  ", text, 4); }

/// The fastest method and why it is the first, and what speaks for others. Empty where no method is within.
std::string winner_text(const JudgedRace& race, const Wish& wish) {
  const auto kept = within(race, wish);
  if (kept.empty()) return "";
  const auto& best = *kept.front();
  const auto proof = [&](const tables::Choice* choice) {
    return assurance(wish.error_of(*choice), wish.tolerance).tolerance;
  };
  auto text = paragraph(fmt::format("{}, the fastest of {} (of {}) within {} {}", printable(best.method), kept.size(),
                                    race.group.choices.size(), wish.tolerance_text, unit_words(wish)));
  text += indented(fmt::format("{}; {}", in_few_words(best, wish), proof(&best)));
  std::vector<std::string> equals;
  for (const auto* choice : kept)
    if (choice != &best && choice->ns.low <= best.ns.high) equals.push_back(printable(choice->method));
  constexpr std::size_t most_named = 2;
  const std::size_t count = equals.size();
  equals.resize(std::min(count, most_named));
  if (count > 0)
    text += indented(fmt::format("not certainly faster than {}{}", fmt::join(equals, ", "),
                                 count > most_named ? fmt::format(" and {} more", count - most_named) : ""));
  if (const auto sure = std::ranges::find(kept, proved, proof); proof(&best) != proved && sure != kept.end())
    text += indented(fmt::format("the fastest with a proof: {}", printable((*sure)->method))) +
            indented(in_few_words(**sure, wish));
  return text + "\n";
}

/// The class, the cells that the errors are of, and an explanation of the words in the table.
std::string heading_text(const JudgedRace& race, const Wish& wish) {
  const auto& group = race.group;
  auto text = paragraph(fmt::format("degree {}, {} form, {}, {} axes, mode {}", printable(group.degree), wish.form,
                                    printable(group.scalar), printable(group.dimension), printable(group.mode)));
  text += paragraph(in_words(race.of));
  text += paragraph(fmt::format("times of study {}; largest errors of {} cell{}:", printable(group.study),
                                race.cells.size(), race.cells.size() == 1 ? "" : "s"));
  constexpr std::size_t most_cells = 4;
  for (std::size_t k = 0; k < std::min(most_cells, race.cells.size()); ++k) text += indented(printable(race.cells[k]));
  if (race.cells.size() > most_cells) text += indented(fmt::format("and {} more", race.cells.size() - most_cells));
  if (!race.others.empty()) text += paragraph("other timing studies, see --study:");
  for (const auto& other : race.others) text += indented(printable(other));
  text += paragraph(wish.unit == "u" ? fmt::format("{}: for every such curve and t with p~ of at least {}", proved,
                                                   brief(least_p_tilde(group, race.of)))
                                     : fmt::format("{}: for every such curve and t", proved));
  return text + paragraph("proved for the trials: for the inputs that were judged") +
         paragraph("~: unreliable timing") +
         paragraph("pareto: no other method is both faster and more accurate; unresolved: the times do not decide") +
         "\n";
}

std::string methods_table(const JudgedRace& race, const Wish& wish) {
  const auto front = fronts(race, wish);
  std::vector<std::vector<std::string>> lines{{"method", "ns", "error", "bound", "tolerance", "pareto"}};
  for (const auto* choice : within(race, wish)) {
    const auto& error = wish.error_of(*choice);
    const auto sure = assurance(error, wish.tolerance);
    lines.push_back({choice->method, brief(choice->ns.median) + (choice->quality == "ok" ? "" : " ~"),
                     brief(error.observed), sure.bound ? brief(*sure.bound) : "", std::string(sure.tolerance),
                     std::string(metric::name(front[static_cast<std::size_t>(choice - race.group.choices.data())]))});
  }
  return fitted(std::move(lines), terminal_width(STDOUT_FILENO));
}

}  // namespace

std::string in_words(const DrawnClass& of) {
  return fmt::format("coordinates in [{0}, {1}], t in [{2}, {3}]", number::decimal(-of.range),
                     number::decimal(of.range), number::decimal(of.t.min), number::decimal(of.t.max));
}

std::string timed_curves(const JudgedRace& race) {
  auto text = fmt::format("{}: {}", race.group.study, in_words(race.of));
  return race.group.drawn.empty() ? text : fmt::format("{}, {}", text, race.group.drawn.back());
}

std::string remedy(const Wish& wish) {
  // as in the ids of studies
  const std::string_view form = wish.form == name(Form::bernstein) ? "bezier"
                                : wish.form == name(Form::power)   ? "polynomial"
                                                                   : "rational";
  const bool in_quick = wish.mode == suite::name(suite::Mode::point) || wish.mode == suite::name(suite::Mode::one_shot);
  if (!in_quick && form == name(Form::rational)) return "";
  const bool can_be_run = wish.degree >= 0 && wish.degree <= max_degree && wish.dimension >= 1 && wish.dimension <= 3;
  if (!can_be_run) return "";
  const std::string suite = in_quick ? "quick" : "speed";
  const std::string studies = fmt::format("{}*-{}{}", suite, form, in_quick ? "*" : "");
  std::string out = fmt::format("{}-{}", suite, wish.degree);
  while (std::filesystem::exists(out)) out += "-new";
  std::string set = fmt::format("--set degree={}", wish.degree);
  if (wish.range) set += fmt::format(" --set coordinate_range={}", number::decimal(*wish.range));
  if (wish.scalar != suite::name(suite::ScalarKind::float64)) set += " --set scalar=" + wish.scalar;
  if (constexpr int usual_dimension = 2; wish.dimension != usual_dimension)
    set += fmt::format(" --set dimension={}", wish.dimension);
  return fmt::format("; `{} run {} --only '{}' {} --out {}` makes a suitable bundle", this_program(), suite, studies,
                     set, out);
}

std::string error_text(const tables::Choice& choice, const Wish& wish) {
  return fmt::format("{} {}", brief(wish.error_of(choice).observed), unit_words(wish));
}

std::vector<const tables::Choice*> within(const JudgedRace& race, const Wish& wish) {
  std::vector<const tables::Choice*> kept;
  for (const auto& choice : race.group.choices)
    if (wish.error_of(choice).observed <= wish.tolerance) kept.push_back(&choice);
  return kept;
}

bundle::CsvTable csv_table(const JudgedRace& race, const Wish& wish) {
  bundle::CsvTable table({"method", "mode", "ns", "ns_low", "ns_high", "observed_max", "bound", "unit", "pareto",
                          "tolerance", "quality", "bound_of", "coordinate_range", "t_min", "t_max", "least_p_tilde"});
  const auto front = fronts(race, wish);
  for (const auto* choice : within(race, wish)) {
    const auto& error = wish.error_of(*choice);
    const auto sure = assurance(error, wish.tolerance);
    table.add_row({choice->method, race.group.mode, number::decimal(choice->ns.median), number::decimal(choice->ns.low),
                   number::decimal(choice->ns.high), number::decimal(error.observed),
                   sure.bound ? number::decimal(*sure.bound) : "", wish.unit,
                   std::string(metric::name(front[static_cast<std::size_t>(choice - race.group.choices.data())])),
                   std::string(sure.tolerance), choice->quality, std::string(sure.bound_of),
                   number::decimal(race.of.range), number::decimal(race.of.t.min), number::decimal(race.of.t.max),
                   number::decimal(least_p_tilde(race.group, race.of))});
  }
  return table;
}

std::string choice_text(const JudgedRace& race, const Wish& wish) {
  return winner_text(race, wish) + heading_text(race, wish) + methods_table(race, wish);
}

}  // namespace bezierbench::cli
