// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/comparison_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "experiments/cli/terminal/text.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

using compare::Gate;
using compare::GateReport;
using compare::Ruling;

std::vector<std::string> words() {
  std::vector<std::string> all;
  for (const auto gate : compare::gates()) all.emplace_back(name(gate));
  return all;
}

/// The gates that a list names, in the order of reports.
std::vector<Gate> gates_of(const std::string& list) {
  std::vector<Gate> chosen;
  std::stringstream rest(list);
  for (std::string word; std::getline(rest, word, ',');) {
    const auto gate = std::ranges::find(compare::gates(), word, [](Gate one) { return name(one); });
    if (gate == compare::gates().end())
      throw Failure(Exit::usage, "--fail-on {}: is not a gate{}; choose from {}", echo(word),
                    suite::suggestion(word, words()), fmt::join(words(), ", "));
    chosen.push_back(*gate);
  }
  return chosen;
}

/// 0.05 for `5%` or `0.05`.
double threshold_of(const std::string& text) {
  constexpr double percent = 100;
  const bool in_percent = text.ends_with('%');
  const auto number = number::parse_number(in_percent ? text.substr(0, text.size() - 1) : text);
  const double threshold = number.value_or(-1) / (in_percent ? percent : 1);
  if (!(threshold >= 0 && threshold <= percent))
    throw Failure(Exit::usage, "--threshold {}: must be a share from 0 on, for example 5% or 0.05", echo(text));
  return threshold;
}

/// What a gate decides on, and where it comes from.
std::string_view rows_missing(Gate gate) {
  switch (gate) {
    case Gate::slower: return "times in common; run both with the same timing studies";
    case Gate::costlier: return "counts of one compiler in common; run both with --counts";
    case Gate::any_change:
    case Gate::less_accurate: break;
  }
  return "results in common; run both with the same studies and seed";
}

std::string where(const compare::Row& row) {
  return fmt::format("{}, {}", row.inputs.field("method"), row_words(row.inputs));
}

/// A field of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

using Lines = std::vector<std::vector<std::string>>;

std::string table(const Lines& lines) { return fitted(lines, terminal_width(STDOUT_FILENO)); }

/// A sentence in the width of the terminal.
std::string sentence(const std::string& text) { return wrapped("", printable(text), 4); }
/// The same, indented below another sentence.
std::string detail(const std::string& text) { return wrapped("  ", printable(text), 4); }

std::string side_line(std::string_view label, const compare::Side& side) {
  return sentence(fmt::format("{}  {}: {}, {}, {}", label, side.name, side.fact("cpu.model_name"),
                              side.fact("build.compiler"), side.fact("build.flags")));
}

std::string facts_text(const compare::Comparison& comparison, bool all) {
  const auto facts = compare::fact_differences(*comparison.a, *comparison.b);
  Lines lines{{"differs", "a", "b"}};
  for (const auto& [name, a, b] : facts) {
    const bool is_reading = name.starts_with("load_average.") || name == "clock.resolution_ns";
    if (all || (!is_reading && !name.ends_with("digest"))) lines.push_back({name, a, b});
  }
  const auto hidden = facts.size() - (lines.size() - 1);
  const auto see = fmt::format("{} readings and digests, see --all", hidden);
  if (lines.size() > 1) return table(lines) + (hidden == 0 ? "" : sentence("and " + see));
  return sentence(hidden == 0 ? "machines and builds: no recorded difference"
                              : "machines and builds: the same, except for " + see);
}

/// How to replay the worst input of the cell with the largest change.
std::string replays_text(const compare::Comparison& comparison) {
  const auto& row = *comparison.differing().front();
  auto text = detail(fmt::format("the largest change: {}, {}", row.file, row.inputs.words()));
  for (const auto* side : {comparison.a, comparison.b})
    if (const auto id = compare::recorded_input(*side, row.inputs); !id.empty())
      text += fmt::format("    {} replay {} {}\n", printable(this_program()), printable(shell_word(side->name)),
                          printable(shell_word(id)));
  return text;
}

/// How many rows of each study and method have no partner in the other bundle.
std::string singles_text(const compare::Comparison& comparison, bool all) {
  if (comparison.only_a.empty() && comparison.only_b.empty()) return "";
  std::map<std::string, std::pair<std::size_t, std::size_t>> counts;
  const auto words = [](const compare::Single& one) {
    return fmt::format("{}, {} {}", one.file, one.inputs.field("study"), one.inputs.field("method"));
  };
  for (const auto& one : comparison.only_a) ++counts[words(one)].first;
  for (const auto& one : comparison.only_b) ++counts[words(one)].second;
  constexpr std::size_t shown = 5;
  Lines lines{{"only in a", "only in b", "rows of"}};
  for (const auto& [of, count] : counts)
    if (all || lines.size() <= shown) lines.push_back({std::to_string(count.first), std::to_string(count.second), of});
  const auto hidden = counts.size() - (lines.size() - 1);
  return sentence(fmt::format("{} rows only in a, {} only in b", comparison.only_a.size(), comparison.only_b.size())) +
         table(lines) + (hidden == 0 ? "" : sentence(fmt::format("and {} more, see --all", hidden))) + "\n";
}

std::string accuracy_words(const compare::Comparison& comparison) {
  const auto rows = comparison.results.size();
  const auto differing = comparison.differing().size();
  if (rows == 0) return "no accuracy rows in common";
  return differing == 0 ? fmt::format("accuracy identical in {} rows", rows)
                        : fmt::format("accuracy differs in {} of {} rows", differing, rows);
}

/// The results that differ: a line for each method with its largest growth, or with `all` for each row.
std::string results_table(const compare::Comparison& comparison, bool all) {
  std::map<std::string, std::size_t> rows;
  for (const auto& row : comparison.results) ++rows[row.inputs.field("method")];
  const auto differing = comparison.differing();
  std::map<std::string, std::size_t> changed;
  for (const auto* row : differing) ++changed[row->inputs.field("method")];
  std::set<std::string> shown;
  Lines lines{{"method", "rows", "of", "result", "a", "b", "where"}};
  for (const auto* row : differing) {
    const auto& method = row->inputs.field("method");
    const bool is_first = shown.insert(method).second;
    if (is_first || all)
      lines.push_back({method, is_first ? std::to_string(changed[method]) : "",
                       is_first ? std::to_string(rows[method]) : "", row->column, row->a, row->b,
                       row_words(row->inputs)});
  }
  return table(lines);
}

std::string accuracy_text(const compare::Comparison& comparison, bool all) {
  auto text = sentence(accuracy_words(comparison));
  if (!comparison.differing().empty()) text += results_table(comparison, all) + replays_text(comparison);
  const auto seed_a = comparison.a->manifest.seed;
  const auto seed_b = comparison.b->manifest.seed;
  if (seed_a != seed_b)
    text +=
        detail(fmt::format("the seeds {} and {} give different inputs, so only times are compared", seed_a, seed_b));
  for (const auto& file : comparison.left_out)
    text += detail(
        fmt::format("{} is left out: the suites differ, and its rows do not say how many trials they cover", file));
  return text;
}

std::string ratio_text(const metric::Interval& ratio) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", ratio.median, ratio.low, ratio.high);
}

/// The counts of the verdicts on the times of methods.
std::string counts_text(const compare::Comparison& comparison) {
  std::map<std::string_view, std::size_t> counts;
  std::size_t methods = 0;
  for (const auto& row : comparison.times) {
    if (row.is_sentinel()) continue;
    ++methods;
    ++counts[row.verdict];
  }
  if (methods == 0) return "no times in common";
  return fmt::format("{} slower, {} same, {} faster, {} unresolved of {} times{}", counts["slower"], counts["same"],
                     counts["faster"], counts["unresolved"], methods,
                     comparison.same_machine ? "" : " in sentinels; different machines");
}

/// The times that are slower or faster, the slowest first, or with `all` every time in the order of a. A narrow
/// terminal has the last columns below.
std::string times_text(const compare::Comparison& comparison, bool all) {
  std::vector<const compare::Row*> rows;
  for (const auto& row : comparison.times)
    if (all || (!row.is_sentinel() && (row.verdict == "slower" || row.verdict == "faster"))) rows.push_back(&row);
  if (rows.empty()) return "  none is certainly slower or faster\n";
  if (!all) std::ranges::stable_sort(rows, {}, [&](const auto* row) { return -row->timed->judged.median; });
  Lines lines{{"method", "b/a", "verdict", "a ns", "b ns", "in sentinels", "rank a b", "quality", "where"}};
  for (const auto* row : rows) {
    const auto& timed = *row->timed;
    const auto& units = timed.normalised;
    lines.push_back({row->inputs.field("method"), ratio_text(row->ratio), std::string(row->verdict),
                     fmt::format("{:.4g}", timed.a.median), fmt::format("{:.4g}", timed.b.median),
                     units ? ratio_text(*units) : "",
                     timed.rank_a == 0 ? "" : fmt::format("{} {}", timed.rank_a, timed.rank_b),
                     timed.quality == "ok" ? "" : timed.quality, row_words(row->inputs)});
  }
  return table(lines);
}

/// The counts of instructions that changed, the most costly first, or with `all` every one.
std::string costs_text(const compare::Comparison& comparison, bool all) {
  std::vector<const compare::Row*> rows;
  for (const auto& row : comparison.costs)
    if (all || row.verdict == compare::different) rows.push_back(&row);
  std::ranges::stable_sort(rows, std::greater(), [](const auto* row) { return row->ratio.median; });
  auto text = sentence(fmt::format("instructions, b over a: {} of {} counts differ",
                                   std::ranges::count(comparison.costs, compare::different, &compare::Row::verdict),
                                   comparison.costs.size()));
  Lines lines{{"method", "b/a", "a", "b", "where"}};
  for (const auto* row : rows)
    lines.push_back({row->inputs.field("method"), fmt::format("{:.3f}", row->ratio.median), row->a, row->b,
                     row_words(row->inputs)});
  return rows.empty() ? text : text + table(lines);
}

std::string timing_summary(const compare::Comparison& comparison) {
  if (comparison.times.empty()) return "timing: no common rows\n";
  return sentence("timing, b over a: " + counts_text(comparison)) +
         detail(comparison.same_machine ? "the same kind of machine: a verdict is stated where b/a and the ratio in "
                                          "sentinels, in which a change of the clock frequency cancels, both decide"
                                        : "b/a compares the machines; in sentinels, the unit of fixed work that is "
                                          "timed beside every race, it compares the methods");
}

/// The methods that changed their order, where both bundles decide it.
std::string ranks_text(const compare::Comparison& comparison) {
  std::string text;
  for (const auto& row : comparison.times)
    if (row.timed->changed_place)
      text += detail(fmt::format("{}: {} in a, {} in b", row.inputs.words(), row.timed->rank_a, row.timed->rank_b));
  return sentence(text.empty() ? "ranks: none changed, among the methods of a race that both bundles have"
                               : "ranks that changed: 1 + the number of methods in the race that are certainly "
                                 "faster, where both bundles decide the order") +
         text;
}

}  // namespace

void GateOptions::add(Command& command) {
  std::vector<std::string> usual;
  for (const auto gate : usual_) usual.emplace_back(name(gate));
  command
      .option("--fail-on", fail_on_,
              fmt::format("exit 1 only where b is different, less-accurate, costlier or slower: one or several, with "
                          "commas; default: {}",
                          fmt::join(usual, ",")))
      .takes("GATES", words);
  command
      .option(
          "--threshold", threshold_,
          "how much a time, a count or an error may grow: the low end of the interval of a time must not lie above it")
      .takes("SHARE");
}

std::vector<GateReport> GateOptions::reports(const std::vector<compare::Comparison>& comparisons) const {
  const auto threshold = threshold_of(threshold_);
  const auto named = gates_of(fail_on_);
  std::vector<GateReport> reports;
  for (const auto& one : comparisons)
    for (const auto gate : compare::gates()) {
      const auto& chosen = named.empty() ? usual_ : named;
      if (std::ranges::find(chosen, gate) == chosen.end()) continue;
      reports.push_back(compare::rule(gate, one, threshold));
      if (reports.back().rows.empty() && !named.empty())
        throw Failure(Exit::usage, "--fail-on {}: {} and {} do not have {}", name(gate), one.a->name, one.b->name,
                      rows_missing(gate));
    }
  return reports;
}

std::vector<std::string> findings_of(const std::vector<GateReport>& reports) {
  std::vector<std::string> findings;
  for (const auto& one : reports)
    if (auto finding = one.finding(); !finding.empty()) findings.push_back(std::move(finding));
  return findings;
}

std::string markdown(const std::vector<GateReport>& reports, const std::vector<std::string>& others) {
  const auto failing = std::ranges::count_if(reports, [](const auto& one) { return !one.finding().empty(); });
  auto text = fmt::format(
      "**bezierbench: {}**\n\n| | gate | rows | fail | undecided |\n|---|---|---|---|---|\n",
      failing == 0 && others.empty() ? "no gate fails" : fmt::format("{} of {} gates fail", failing, reports.size()));
  for (const auto& other : others) text += fmt::format("| **fails** | {} | | | |\n", cell(other));
  std::string details;
  for (const auto& one : reports) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", one.finding().empty() ? "passes" : "**fails**", name(one.gate),
                        one.rows.size(), one.count(Ruling::fails), one.count(Ruling::undecided));
    for (const auto ruling : {Ruling::fails, Ruling::undecided})
      for (const auto& row : one.rows)
        if (row.ruling == ruling)
          details += fmt::format("| {} | {} | {} | {} |\n", name(one.gate), name(ruling), cell(where(*row.row)),
                                 cell(row.why));
  }
  return details.empty() ? text : text + "\n| gate | | row | b over a |\n|---|---|---|---|\n" + details;
}

std::string junit(const std::vector<GateReport>& reports, const std::vector<std::string>& others) {
  pugi::xml_document document;
  auto all = document.append_child("testsuites");
  if (!others.empty()) {
    auto suite = all.append_child("testsuite");
    suite.append_attribute("name") = "method";
    suite.append_attribute("tests") = others.size();
    suite.append_attribute("failures") = others.size();
    for (const auto& other : others) {
      auto test = suite.append_child("testcase");
      test.append_attribute("name") = other.c_str();
      test.append_child("failure").append_attribute("message") = other.c_str();
    }
  }
  for (const auto& one : reports) {
    auto suite = all.append_child("testsuite");
    suite.append_attribute("name") = fmt::format("{}: {}", one.comparison->b->name, name(one.gate)).c_str();
    suite.append_attribute("tests") = one.rows.size();
    suite.append_attribute("failures") = one.count(Ruling::fails);
    suite.append_attribute("skipped") = one.count(Ruling::undecided);
    for (const auto& row : one.rows) {
      auto test = suite.append_child("testcase");
      test.append_attribute("classname") = name(one.gate).data();
      test.append_attribute("name") = where(*row.row).c_str();
      if (row.ruling == Ruling::passes) continue;
      auto result = test.append_child(row.ruling == Ruling::fails ? "failure" : "skipped");
      result.append_attribute("message") = row.why.c_str();
    }
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

std::string row_words(const compare::Inputs& inputs) {
  const suite::Study usual;
  std::string text = inputs.field("study");
  const auto add = [&](std::string_view label, std::string_view name, std::string_view left_out) {
    if (const auto& field = inputs.field(name); !field.empty() && field != left_out)
      text += fmt::format(", {}{}", label, field);
  };
  add("", "scalar", suite::name(usual.scalar.front()));
  add("", "mode", "");
  for (const std::string_view axis : {"degree", "order", "points", "tolerance"})
    add(fmt::format("{} ", axis), axis, "");
  add("dimension ", "dimension", std::to_string(usual.dimension.front()));
  add("R ", "coordinate_range", number::decimal(usual.coordinate_range.front()));
  add("", "generator", usual.generator.front());
  add("t from ", "t_min", number::decimal(usual.t_interval.front().min));
  add("t to ", "t_max", number::decimal(usual.t_interval.front().max));
  add("against ", "baseline", usual.baseline.front());
  return printable(text);
}

std::string comparison_text(const compare::Comparison& comparison, bool times, bool all) {
  auto text = sentence(fmt::format("verdict  {}; {}", accuracy_words(comparison), counts_text(comparison))) +
              side_line("a", *comparison.a) + side_line("b", *comparison.b) + "\n" + facts_text(comparison, all) +
              "\n" + accuracy_text(comparison, all) + "\n" + singles_text(comparison, all) + timing_summary(comparison);
  if (times && !comparison.times.empty()) text += times_text(comparison, all) + "\n" + ranks_text(comparison);
  if (!comparison.costs.empty()) text += "\n" + costs_text(comparison, all);
  return text;
}

std::string standings_text(const std::vector<compare::Standing>& standings) {
  Lines lines{{"rank", "bundle", "cpu", "compiler", "accuracy", "time", "in sentinels"}};
  for (const auto& one : standings) {
    const auto mean = [&](double value) { return one.rank ? fmt::format("{:.3f}", value) : ""; };
    lines.push_back({one.rank ? std::to_string(*one.rank) : "", one.side->name, one.side->fact("cpu.model_name"),
                     one.side->fact("build.compiler"),
                     one.differing == 0 ? "identical" : fmt::format("{} rows differ", one.differing),
                     mean(one.mean_ratio), mean(one.mean_normalised)});
  }
  return sentence(fmt::format("geometric mean of the times over those of the first bundle, {} common times",
                              standings.front().timings)) +
         table(lines);
}

}  // namespace bezierbench::cli
