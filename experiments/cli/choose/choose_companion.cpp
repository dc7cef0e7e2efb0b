// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/cli/choose/choose.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/tables/choices.hpp"
#include "experiments/tables/table_row.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using tables::TableRow;

constexpr const char* unstable = "_unstable.csv";  ///< end of the table of the methods whose last bits libm decides
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What the rows of a problem say of a method.
struct Judged {
  double measure = 0;                    ///< the largest value of the table's first measure
  double trials = 0;                     ///< in all rows
  std::map<std::string, double> faults;  ///< counts above 0, by column
};

struct Ranked {
  const tables::Choice* time;
  const Judged* judged;
  metric::Front front = metric::Front::off;  ///< of those without a fault
};

[[noreturn]] void refuse_problem(const Wish& wish, const std::string& what) {
  throw Failure(Exit::usage, "{}: {}", wish.bundle, what);
}

/// Keeps the rows with this word in the column. Throws Failure(usage) with the available words where there are none.
void require(std::vector<TableRow>& rows, const Wish& wish, const char* column, const std::string& word) {
  std::set<std::string> available;
  for (const auto& row : rows) available.insert(row.text(column));
  const auto asked = number::parse_number(word);
  const auto is_meant = [&](const std::string& field) {
    return field == word || (asked && number::parse_number(field) == asked);
  };
  std::erase_if(rows, [&](const TableRow& row) { return !is_meant(row.text(column)); });
  if (rows.empty())
    refuse_problem(wish, word.empty()
                             ? fmt::format("--{} is required; available: {}", column, fmt::join(available, ", "))
                             : fmt::format("no method of {} was judged at {} {}; available: {}", wish.problem, column,
                                           word, fmt::join(available, ", ")));
}

std::vector<TableRow> judged_rows(const std::vector<bundle::CsvDocument>& judgements, const Wish& wish) {
  std::vector<TableRow> rows;
  for (const auto& table : judgements)
    for (const auto& row : tables::rows_of(table))
      if (row.text("status") == "ok" && (wish.accuracy_study.empty() || row.text("study") == wish.accuracy_study))
        rows.push_back(row);
  if (rows.empty())
    refuse_problem(wish, fmt::format("no method of {} was judged{}; choose from another bundle", wish.problem,
                                     wish.accuracy_study.empty() ? "" : " in study " + wish.accuracy_study));
  require(rows, wish, "form", wish.form);
  require(rows, wish, "scalar", wish.scalar);
  require(rows, wish, "dimension", std::to_string(wish.dimension));
  require(rows, wish, "degree", *wish.degree_text);
  if (rows.front().has("tolerance"))
    require(rows, wish, "tolerance", wish.tolerance_text);
  else if (!wish.tolerance_text.empty())
    refuse_problem(wish,
                   fmt::format("--tolerance {}: {} has no tolerance; remove it", wish.tolerance_text, wish.problem));
  return rows;
}

std::map<std::string, Judged> judged_methods(const std::vector<TableRow>& rows, const bundle::DeclaredTable& declared) {
  std::map<std::string, Judged> methods;
  for (const auto& row : rows) {
    auto& one = methods[row.text(declared.method)];
    one.trials += row.number("trials");
    one.measure = std::max(one.measure, row.optional_number(declared.measure).value_or(0));
    for (const auto& fault : declared.faults)
      if (const double count = row.optional_number(fault).value_or(0); count > 0) one.faults[fault] += count;
    const auto& within = declared.within_tolerance;
    if (!within.empty() && row.optional_number(within).value_or(0) > row.number("tolerance"))
      one.faults[within + " above the tolerance, rows"] += 1;
  }
  return methods;
}

/// The race of these methods on such curves with the most of them; empty without one.
std::optional<tables::ChoiceGroup> race_of(const bundle::CsvDocument& timing, const Wish& wish,
                                           const std::map<std::string, Judged>& judged) {
  auto rows = tables::rows_of(timing);
  const auto tolerance = number::parse_number(wish.tolerance_text);
  std::erase_if(rows, [&](const TableRow& row) {
    return row.text("form") != wish.form || row.text("scalar") != wish.scalar ||
           row.text("dimension") != std::to_string(wish.dimension) || row.text("degree") != *wish.degree_text ||
           row.optional_number("tolerance") != tolerance || row.text("mode") != "one_shot" ||
           (!wish.study.empty() && row.text("study") != wish.study);
  });
  auto races = tables::timed_groups(rows);
  for (auto& race : races)
    std::erase_if(race.choices, [&](const tables::Choice& one) { return !judged.contains(one.method); });
  const auto most = std::ranges::max_element(races, {}, [](const auto& race) { return race.choices.size(); });
  if (most == races.end() || most->choices.empty()) return std::nullopt;
  return *most;
}

/// `broken 82, undecided 1`.
std::string faults_text(const Judged& judged) {
  std::vector<std::string> texts;
  for (const auto& [column, count] : judged.faults) texts.push_back(fmt::format("{} {:.0f}", column, count));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string text_of(const std::vector<Ranked>& ranked, const tables::ChoiceGroup& race,
                    const bundle::DeclaredTable& declared, const Wish& wish) {
  const auto faultless = std::ranges::count_if(ranked, [](const Ranked& one) { return one.judged->faults.empty(); });
  const auto& relative_to = ranked.front().time->relative_to;
  std::string text;
  if (faultless > 0) {
    const auto& best = ranked.front();
    text = paragraph(fmt::format("{} of {} methods are without a fault in {} trials; the fastest: {}", faultless,
                                 ranked.size(), best.judged->trials, best.time->method)) +
           indented(fmt::format("{} times the time of {}; {}: {}", ratio_text(*best.time), relative_to,
                                declared.measure_words, brief(best.judged->measure))) +
           "\n";
  }
  const auto& within = declared.within_tolerance;
  text +=
      paragraph(fmt::format("{}, degree {}, {} form, {}, {} axes{}", wish.problem, *wish.degree_text, wish.form,
                            wish.scalar, wish.dimension,
                            wish.tolerance_text.empty() ? "" : ", tolerance " + wish.tolerance_text)) +
      paragraph(fmt::format("times of study {}; errors and faults of all such rows of {}", race.study, declared.file)) +
      paragraph(fmt::format("a fault: a trial that is counted in {}{}", fmt::join(declared.faults, ", "),
                            within.empty() ? "" : "; a " + within + " above the tolerance")) +
      paragraph(fmt::format("{}: {}, the largest of the rows", declared.measure, declared.measure_words)) +
      paragraph(fmt::format("ratio: of the time to that of {}, measured side by side", relative_to)) +
      paragraph(fmt::format("*: no other method without a fault is both faster and better in {}", declared.measure)) +
      "\n";
  std::vector<std::vector<std::string>> lines{{"  method", "ratio", declared.measure, "faults", "ns"}};
  for (const auto& one : ranked)
    lines.push_back({marked(one.time->method, one.front), ratio_text(*one.time), in_table(one.judged->measure),
                     one.judged->faults.empty() ? "none" : faults_text(*one.judged), in_table(one.time->ns.median)});
  return text + fitted(std::move(lines), terminal_width(STDOUT_FILENO), 1);
}

std::string csv_of(const std::vector<Ranked>& ranked, const bundle::DeclaredTable& declared) {
  bundle::CsvTable table({"method", "ns", "ns_low", "ns_high", "ratio", "ratio_low", "ratio_high", "relative_to",
                          declared.measure, "faults", "pareto"});
  for (const auto& one : ranked) {
    const auto& [method, ns, quality, errors, ratio, relative_to, instructions] = *one.time;
    table.add_row(tables::texts(method, ns.median, ns.low, ns.high, end_of(ratio, &metric::Interval::median),
                                end_of(ratio, &metric::Interval::low), end_of(ratio, &metric::Interval::high),
                                relative_to, one.judged->measure, faults_text(*one.judged), name(one.front)));
  }
  return table.text();
}

}  // namespace

std::vector<std::string> companion_problems() {
  std::vector<std::string> problems;
  for (const auto& table : bundle::declared_tables())
    if (!table.faults.empty() && !table.file.ends_with(unstable))
      problems.push_back(table.file.substr(0, table.file.rfind('.')));
  return problems;
}

Exit choose_companion(const Wish& wish) {
  const auto bundle = bundle::BundleDirectory::open(wish.bundle);
  const auto& declared = *bundle::declared_table(wish.problem + ".csv");
  std::vector<bundle::CsvDocument> judgements;
  for (const auto& file : {declared.file, wish.problem + unstable})
    if (auto found = bundle.table(file)) judgements.push_back(std::move(*found));
  const auto timing = bundle.table("timing.csv");
  if (judgements.empty() || !timing)
    refuse_problem(wish, fmt::format("does not have both {} and times; choose from another bundle", declared.file));
  const auto judged = judged_methods(judged_rows(judgements, wish), declared);
  const auto race = race_of(*timing, wish, judged);
  if (!race)
    refuse_problem(wish,
                   fmt::format("no method of {} was timed on such curves; choose from another bundle", wish.problem));
  std::vector<metric::Tradeoff> tradeoffs;
  std::vector<Ranked> ranked;
  for (const auto& choice : race->choices) {
    ranked.push_back({&choice, &judged.at(choice.method)});
    const auto& judgement = *ranked.back().judged;
    tradeoffs.push_back({choice.time(), judgement.faults.empty() ? judgement.measure : infinity});
  }
  const auto fronts = metric::pareto_front(tradeoffs);
  for (std::size_t k = 0; k < ranked.size(); ++k)
    if (ranked[k].judged->faults.empty()) ranked[k].front = fronts[k];
  std::ranges::stable_sort(
      ranked, {}, [](const Ranked& one) { return std::pair(!one.judged->faults.empty(), one.time->time().median); });
  fmt::print("{}", wish.format == "csv" ? csv_of(ranked, declared) : text_of(ranked, *race, declared, wish));
  if (ranked.front().judged->faults.empty()) return Exit::fine;
  say(fmt::format("{}: every method of {} has a fault at degree {}", wish.bundle, wish.problem, *wish.degree_text));
  return Exit::finding;
}

}  // namespace bezierbench::cli
