// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/comparison_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "experiments/cli/terminal/fitted.hpp"
#include "experiments/cli/terminal/shell_word.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string table(const Lines& lines) { return fitted(lines, terminal_width(STDOUT_FILENO)); }

/// A sentence in the width of the terminal.
std::string told(const std::string& text) { return wrapped("", text, 4); }
/// One that belongs to the sentence before it.
std::string also_told(const std::string& text) { return wrapped("  ", text, 4); }

std::string side_line(std::string_view label, const compare::Side& side) {
  return told(printable(fmt::format("{}  {}: {}, {}, {}", label, side.name, side.fact("cpu.model_name"),
                                    side.fact("build.compiler"), side.fact("build.flags"))));
}

std::string facts_text(const compare::Pair& pair, bool all) {
  constexpr std::size_t most_characters = 12;
  Lines lines{{"differs", "a", "b"}};
  for (const auto& [name, a, b] : pair.facts) {
    const bool is_reading = name.starts_with("load_average.") || name == "clock.resolution_ns";
    if (all)
      lines.push_back({name, a, b});
    else if (name == "git_commit")
      lines.push_back({name, a.substr(0, most_characters), b.substr(0, most_characters)});
    else if (!is_reading && !name.ends_with("digest"))
      lines.push_back({name, a, b});
  }
  const auto left_out = pair.facts.size() - (lines.size() - 1);
  const auto see = fmt::format("{} readings and digests, see --all", left_out);
  if (lines.size() > 1) return table(lines) + (left_out == 0 ? "" : told("and " + see));
  return told(left_out == 0 ? "machines and builds: no recorded difference"
                            : "machines and builds: the same, except for " + see);
}

/// The row with the largest change, and how to replay the worst input of its cell.
std::string difference_text(const compare::Side& a, const compare::Side& b, const compare::AccuracyRow& row) {
  std::string text = also_told(fmt::format("the first of them: {}, {}", row.file, printable(row.inputs.words())));
  const auto side_text = [&](std::string_view label, const compare::Side& side, const std::string& value,
                             std::size_t line) {
    text += also_told(fmt::format("{}: {} {}, line {}", label, row.first.column, printable(value), line));
    if (const auto id = compare::recorded_input(side, row.inputs); !id.empty())
      text += fmt::format("     {} replay {} {}\n", printable(this_program()), printable(shell_word(side.name)),
                          printable(shell_word(id)));
  };
  side_text("a", a, row.first.a, row.line_a);
  side_text("b", b, row.first.b, row.line_b);
  return text;
}

/// How many methods of a study and table agree, and the names of a few that do not.
std::string methods_text(const std::map<bundle::Rows, compare::RowCounts>& methods) {
  constexpr std::size_t most = 5;
  std::map<std::string_view, std::vector<const bundle::Rows*>> others;
  std::size_t agreeing = 0;
  for (const auto& [rows, count] : methods) {
    if (count.differing > 0)
      others["differ"].push_back(&rows);
    else if (count.pairs + count.only_b == 0)
      others["only in a"].push_back(&rows);
    else if (count.pairs + count.only_a == 0)
      others["only in b"].push_back(&rows);
    else if (count.only_a + count.only_b > 0)
      others["have other cells or trials"].push_back(&rows);
    else
      ++agreeing;
  }
  std::string text = fmt::format("by table, study and method: {} agree", agreeing);
  std::string names;
  for (const auto& [what, all] : others) {
    text += fmt::format(", {} {}", all.size(), what);
    for (std::size_t k = 0; k < std::min(all.size(), most); ++k)
      names += wrapped("    ", fmt::format("{}: {}", what, printable(all[k]->words())), 6);
    if (all.size() > most) names += fmt::format("    {}: {} more\n", what, all.size() - most);
  }
  return also_told(text) + names;
}

/// A line for each method that differs, or for each of its rows, the largest growth first.
std::string changed_methods_text(const compare::AccuracyComparison& accuracy, bool all) {
  Lines lines{{"method", "rows", "of", "result", "a", "b", "where"}};
  for (const auto& change : compare::method_changes(accuracy)) {
    const auto add = [&](const compare::AccuracyRow& row, bool is_first) {
      lines.push_back({is_first ? change.method : "", is_first ? std::to_string(change.differing.size()) : "",
                       is_first ? std::to_string(change.rows) : "", row.shown.column, row.shown.a, row.shown.b,
                       row_words(row.inputs)});
    };
    for (const auto* row : change.differing) {
      add(*row, row == change.differing.front());
      if (!all) break;
    }
  }
  return table(lines);
}

std::string accuracy_text(const compare::Side& a, const compare::Side& b, const compare::AccuracyComparison& accuracy,
                          bool all) {
  std::string text;
  if (accuracy.rows.empty())
    text = "accuracy: no common rows\n";
  else if (accuracy.differing() == 0)
    text = fmt::format("accuracy: identical in all {} common rows\n", accuracy.rows.size());
  else
    text = fmt::format("accuracy: {} of {} common rows differ\n{}", accuracy.differing(), accuracy.rows.size(),
                       changed_methods_text(accuracy, all) +
                           difference_text(a, b, *compare::method_changes(accuracy).front().differing.front()));
  if (a.manifest.seed != b.manifest.seed)
    text += also_told(fmt::format("the seeds {} and {} give different inputs, so no rows can be compared",
                                  a.manifest.seed, b.manifest.seed));
  else
    text += methods_text(accuracy.methods);
  if (accuracy.only_a + accuracy.only_b > 0)
    text += fmt::format("  {} rows only in a, {} only in b\n", accuracy.only_a, accuracy.only_b);
  for (const auto& file : accuracy.left_out)
    text += also_told(
        fmt::format("{} is left out: the suites differ, and its rows do not say how many trials they cover", file));
  return text;
}

std::string ratio_text(const compare::TimeRatio& of) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", of.ratio.median, of.ratio.low, of.ratio.high);
}

/// The rows of timings, what matters most first: a narrow terminal has the rest below.
std::string times_table(const std::vector<const compare::TimingRow*>& rows) {
  Lines lines{{"method", "b/a", "verdict", "a ns", "b ns", "in sentinels", "rank a b", "quality", "where"}};
  for (const auto* row : rows) {
    const auto& normalised = row->normalised;
    lines.push_back({row->inputs.field("method"), ratio_text(row->raw), std::string(metric::name(row->raw.verdict)),
                     fmt::format("{:.4g}", row->a.median), fmt::format("{:.4g}", row->b.median),
                     normalised ? fmt::format("{} {}", ratio_text(*normalised), metric::name(normalised->verdict)) : "",
                     row->rank_a == 0 ? "" : fmt::format("{} {}", row->rank_a, row->rank_b),
                     row->is_ok() ? "" : row->quality, row_words(row->inputs)});
  }
  return table(lines);
}

/// The verdict that compares methods: in sentinels where the machines differ.
const compare::TimeRatio& judged_ratio(const compare::TimingRow& row, bool same_machine) {
  return same_machine || !row.normalised ? row.raw : *row.normalised;
}

std::string counts_text(const compare::Pair& pair) {
  std::map<metric::Verdict, std::size_t> counts;
  std::size_t methods = 0;
  for (const auto& row : pair.timing.rows) {
    if (row.is_sentinel()) continue;
    ++methods;
    ++counts[judged_ratio(row, pair.same_machine).verdict];
  }
  using metric::Verdict;
  return fmt::format("{} slower, {} same, {} faster, {} unresolved of {} times{}", counts[Verdict::slower],
                     counts[Verdict::same], counts[Verdict::faster], counts[Verdict::unresolved], methods,
                     pair.same_machine ? "" : " in sentinels");
}

std::string verdict_line(const compare::Pair& pair) {
  const auto& accuracy = pair.accuracy;
  std::string text = "no accuracy rows in common";
  if (accuracy.differing() > 0)
    text = fmt::format("accuracy differs in {} of {} rows", accuracy.differing(), accuracy.rows.size());
  else if (!accuracy.rows.empty())
    text = fmt::format("accuracy identical in {} rows", accuracy.rows.size());
  return told(fmt::format("verdict  {}; {}{}", text,
                          pair.timing.rows.empty() ? "no times in common" : counts_text(pair),
                          pair.same_machine ? "" : "; different machines"));
}

std::string timing_summary(const compare::Pair& pair) {
  if (pair.timing.rows.empty()) return "timing: no common rows\n";
  const auto unreliable = std::ranges::count_if(
      pair.timing.rows, [](const compare::TimingRow& row) { return !row.is_sentinel() && !row.is_ok(); });
  std::string text = "timing, b over a: " + counts_text(pair);
  if (unreliable > 0) text += fmt::format("; {} unreliable, see quality", unreliable);
  text = told(text);
  text += also_told(pair.same_machine
                        ? "the same kind of machine: b/a compares the builds; in sentinels, a change of the clock "
                          "frequency cancels"
                        : "different machines: b/a compares the machines; in sentinels, the unit of fixed work that is "
                          "timed beside every race, it compares the methods");
  if (pair.timing.only_a + pair.timing.only_b > 0)
    text += fmt::format("  {} rows only in a, {} only in b\n", pair.timing.only_a, pair.timing.only_b);
  return text;
}

/// The times that are certainly slower or faster, the slowest first, or with `all` every time in the order of a.
std::string times_text(const compare::Pair& pair, bool all) {
  std::vector<const compare::TimingRow*> rows;
  for (const auto& row : pair.timing.rows) {
    const auto verdict = judged_ratio(row, pair.same_machine).verdict;
    const bool has_changed = verdict == metric::Verdict::slower || verdict == metric::Verdict::faster;
    if (all || (!row.is_sentinel() && has_changed)) rows.push_back(&row);
  }
  if (rows.empty()) return "  none is certainly slower or faster\n";
  const auto slowest_first = [&](const auto* row) { return -judged_ratio(*row, pair.same_machine).ratio.median; };
  if (!all) std::ranges::stable_sort(rows, {}, slowest_first);
  return times_table(rows);
}

/// The methods that changed their order, as far as both bundles show it.
std::string rank_changes_text(const compare::TimingComparison& timing) {
  std::string text;
  for (const auto& row : timing.rows)
    if (row.changed_place)
      text += also_told(fmt::format("{}: {} in a, {} in b{}", printable(row.inputs.words()), row.rank_a, row.rank_b,
                                    row.is_ok() ? "" : ", " + printable(row.quality)));
  return told(text.empty()
                  ? "ranks: none changed, among the methods of a race that both bundles have"
                  : "ranks that changed: 1 + the number of methods in the race that are certainly faster, where "
                    "both bundles decide the order") +
         text;
}

}  // namespace

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
  const auto& [low, high] = usual.t_interval.front();
  const auto& t_min = inputs.field("t_min");
  const auto& t_max = inputs.field("t_max");
  if (!t_min.empty() && (t_min != number::decimal(low) || t_max != number::decimal(high)))
    text += fmt::format(", t in [{}, {}]", t_min, t_max);
  add("against ", "baseline", usual.baseline.front());
  return printable(text);
}

std::string pair_text(const compare::Side& a, const compare::Side& b, const compare::Pair& pair, bool rows, bool all) {
  auto text = verdict_line(pair) + side_line("a", a) + side_line("b", b) + "\n" + facts_text(pair, all) + "\n" +
              accuracy_text(a, b, pair.accuracy, all) + "\n" + timing_summary(pair);
  if (rows && !pair.timing.rows.empty()) text += times_text(pair, all) + "\n" + rank_changes_text(pair.timing);
  return text;
}

std::string standings_text(const std::vector<compare::Standing>& standings) {
  Lines lines{{"rank", "bundle", "cpu", "compiler", "accuracy", "time", "in sentinels"}};
  for (const auto& one : standings) {
    const auto mean = [&](double value) { return one.rank ? fmt::format("{:.3f}", value) : ""; };
    lines.push_back({one.rank ? std::to_string(*one.rank) : "", one.bundle, one.cpu, one.compiler,
                     one.differing == 0 ? "identical" : fmt::format("{} rows differ", one.differing),
                     mean(one.mean_ratio), mean(one.mean_normalised)});
  }
  return told(fmt::format("geometric mean of the times over those of the first bundle, {} common times",
                          standings.front().timings)) +
         table(lines);
}

}  // namespace bezierbench::cli
