// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/comparison_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <optional>

#include "experiments/cli/commands/row_words.hpp"
#include "experiments/cli/terminal/fitted.hpp"
#include "experiments/cli/terminal/shell_word.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/compare/changes.hpp"
#include "experiments/echo.hpp"
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

/// Whether a fact differs between any two runs, or is said by other lines: readings of the moment, and digests.
bool is_for_all_only(const std::string& fact) {
  return fact.starts_with("load_average.") || fact == "clock.resolution_ns" || fact.ends_with("digest");
}

/// A value for people: of a commit, enough digits to know it by.
std::string brief(const compare::FactDifference& fact, const std::string& value) {
  constexpr std::size_t enough_digits = 12;
  return fact.name == "git_commit" ? value.substr(0, enough_digits) : value;
}

std::string facts_text(const compare::Pair& pair, bool all) {
  Lines lines{{"differs", "a", "b"}};
  for (const auto& fact : pair.facts)
    if (all)
      lines.push_back({fact.name, fact.a, fact.b});
    else if (!is_for_all_only(fact.name))
      lines.push_back({fact.name, brief(fact, fact.a), brief(fact, fact.b)});
  const auto left_out = pair.facts.size() - (lines.size() - 1);
  if (lines.size() == 1)
    return told(left_out == 0 ? "machines and builds: no recorded difference"
                              : fmt::format("machines and builds: the same, but for {} readings and digests, see --all",
                                            left_out));
  return table(lines) + (left_out == 0 ? "" : told(fmt::format("and {} readings and digests, see --all", left_out)));
}

std::string recorded_text(const compare::Side& side, std::string_view label, const compare::Inputs& inputs) {
  const auto input = compare::recorded_input(side, inputs);
  if (!input) return fmt::format("  {} has recorded no worst input of it\n", label);
  return also_told(fmt::format("{}: worst at trial {}, t {}, coefficients {}", label, printable(input->trial),
                               printable(input->t), printable(input->coefficients))) +
         fmt::format("     {} replay {} {}\n", printable(this_program()), printable(shell_word(side.name)),
                     printable(shell_word(input->id)));
}

std::string difference_text(const compare::Side& a, const compare::Side& b, const compare::AccuracyRow& row) {
  return also_told(fmt::format("the first of them: {}, {}", row.file, printable(row.inputs.words()))) +
         also_told(fmt::format("a: {} {}, line {}", row.column, printable(row.a), row.line_a)) +
         also_told(fmt::format("b: {} {}, line {}", row.column, printable(row.b), row.line_b)) +
         recorded_text(a, "a", row.inputs) + recorded_text(b, "b", row.inputs);
}

/// The names of tables, studies and methods, a few of them.
std::string named_rows(std::string_view what, const std::vector<bundle::Rows>& all) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(all.size(), most); ++k)
    text += wrapped("    ", fmt::format("{}: {}", what, printable(all[k].words())), 6);
  if (all.size() > most) text += fmt::format("    {}: {} more\n", what, all.size() - most);
  return text;
}

std::string methods_text(const compare::MethodComparison& methods) {
  std::string text = fmt::format("by table, study and method: {} agree", methods.agreeing.size());
  std::string names;
  const auto tell = [&](std::string_view what, const std::vector<bundle::Rows>& all) {
    if (all.empty()) return;
    text += fmt::format(", {} {}", all.size(), what);
    names += named_rows(what, all);
  };
  tell("differ", methods.differing);
  tell("have other cells or trials", methods.other_rows);
  tell("only in a", methods.only_a);
  tell("only in b", methods.only_b);
  return also_told(text) + names;
}

/// A line for each method that differs, or for each of its rows, the largest growth first.
std::string changed_methods_text(const compare::AccuracyComparison& accuracy, bool all) {
  Lines lines{{"method", "rows", "of", "result", "a", "b", "where"}};
  for (const auto& change : compare::method_changes(accuracy)) {
    const auto add = [&](const compare::AccuracyRow& row, bool is_first) {
      const auto [column, a, b] = compare::shown_change(row);
      lines.push_back({is_first ? change.method : "", is_first ? std::to_string(change.differing.size()) : "",
                       is_first ? std::to_string(change.rows) : "", column, a, b, row_words(row.inputs)});
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
  else if (accuracy.differing == 0)
    text = fmt::format("accuracy: identical in all {} common rows\n", accuracy.rows.size());
  else
    text = fmt::format("accuracy: {} of {} common rows differ\n{}", accuracy.differing, accuracy.rows.size(),
                       changed_methods_text(accuracy, all) +
                           difference_text(a, b, *compare::method_changes(accuracy).front().differing.front()));
  if (a.manifest.seed != b.manifest.seed)
    text += also_told(
        fmt::format("seeds {} and {}: other inputs, so nothing to compare", a.manifest.seed, b.manifest.seed));
  else
    text += methods_text(accuracy.methods);
  if (accuracy.only_a + accuracy.only_b > 0)
    text += fmt::format("  {} rows only in a, {} only in b\n", accuracy.only_a, accuracy.only_b);
  for (const auto& file : accuracy.left_out)
    text += also_told(fmt::format("{} left out: the suites differ, and its rows do not say of how many trials", file));
  return text;
}

std::string time_text(const metric::Interval& ns) { return fmt::format("{:.4g}", ns.median); }

std::string ratio_text(const compare::TimeRatio& of) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", of.ratio.median, of.ratio.low, of.ratio.high);
}

/// The rows of timings, what matters most first: a narrow terminal has the rest below.
std::string times_table(const std::vector<const compare::TimingRow*>& rows) {
  Lines lines{{"method", "b/a", "verdict", "a ns", "b ns", "in sentinels", "rank a b", "quality", "where"}};
  for (const auto* row : rows) {
    const auto& normalised = row->normalised;
    lines.push_back({row->inputs.field("method"), ratio_text(row->raw), std::string(metric::name(row->raw.verdict)),
                     time_text(row->a), time_text(row->b),
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

}  // namespace

std::string verdict_line(const compare::Pair& pair) {
  const auto& accuracy = pair.accuracy;
  std::string text = "verdict  ";
  if (accuracy.rows.empty())
    text += "no accuracy in common";
  else if (accuracy.differing == 0)
    text += fmt::format("accuracy identical in {} rows", accuracy.rows.size());
  else
    text += fmt::format("accuracy differs in {} of {} rows", accuracy.differing, accuracy.rows.size());
  return told(fmt::format("{}; {}{}", text, pair.timing.rows.empty() ? "no times in common" : counts_text(pair),
                          pair.same_machine ? "" : "; different machines"));
}

std::string differences_text(const compare::Side& a, const compare::Side& b, const compare::Pair& pair, bool all) {
  return side_line("a", a) + side_line("b", b) + "\n" + facts_text(pair, all) + "\n" +
         accuracy_text(a, b, pair.accuracy, all);
}

std::string timing_summary(const compare::Pair& pair) {
  if (pair.timing.rows.empty()) return "timing: no common rows\n";
  const auto doubtful = std::ranges::count_if(
      pair.timing.rows, [](const compare::TimingRow& row) { return !row.is_sentinel() && !row.is_ok(); });
  std::string text = "timing, b over a: " + counts_text(pair);
  if (doubtful > 0) text += fmt::format("; {} doubtful, marked", doubtful);
  text = told(text);
  text += also_told(
      pair.same_machine
          ? "the same kind of machine: b/a compares the builds; in sentinels, a change of its clock is taken out"
          : "different machines: b/a compares them; in sentinels, steps of fixed work timed beside, it compares the "
            "methods");
  if (pair.timing.only_a + pair.timing.only_b > 0)
    text += fmt::format("  {} rows only in a, {} only in b\n", pair.timing.only_a, pair.timing.only_b);
  return text;
}

std::string changed_times_text(const compare::Pair& pair) {
  std::vector<const compare::TimingRow*> changed;
  for (const auto& row : pair.timing.rows) {
    const auto verdict = judged_ratio(row, pair.same_machine).verdict;
    if (!row.is_sentinel() && (verdict == metric::Verdict::slower || verdict == metric::Verdict::faster))
      changed.push_back(&row);
  }
  if (changed.empty()) return "  none is slower or faster for certain\n";
  const auto worst_first = [&](const auto* row) { return -judged_ratio(*row, pair.same_machine).ratio.median; };
  std::ranges::stable_sort(changed, {}, worst_first);
  return times_table(changed);
}

std::string timing_text(const compare::TimingComparison& timing) {
  std::vector<const compare::TimingRow*> rows;
  for (const auto& row : timing.rows) rows.push_back(&row);
  return times_table(rows);
}

std::string rank_changes_text(const compare::TimingComparison& timing) {
  std::string text;
  for (const auto& row : timing.rows)
    if (row.changed_place)
      text += also_told(fmt::format("{}: {} in a, {} in b{}", printable(row.inputs.words()), row.rank_a, row.rank_b,
                                    row.is_ok() ? "" : ", " + printable(row.quality)));
  constexpr std::string_view among = "among the methods of a race that both bundles have";
  return text.empty()
             ? told(fmt::format("ranks: none changed, {}", among))
             : told(fmt::format(
                   "ranks that changed, where both bundles resolve it, 1 + how many are certainly faster, {}", among)) +
                   text;
}

std::string standings_text(const std::vector<compare::Standing>& standings) {
  Lines lines{{"rank", "bundle", "cpu", "compiler", "accuracy", "time", "in sentinels"}};
  for (const auto& one : standings) {
    const auto mean = [&](double value) { return one.rank ? fmt::format("{:.3f}", value) : ""; };
    lines.push_back({one.rank ? std::to_string(*one.rank) : "", one.bundle, one.cpu, one.compiler,
                     one.differing == 0 ? "identical" : fmt::format("{} rows differ", one.differing),
                     mean(one.mean_ratio), mean(one.mean_normalised)});
  }
  return told(fmt::format("geometric mean of time over the first bundle's, {} common timings",
                          standings.front().timings)) +
         table(lines);
}

}  // namespace bezierbench::cli
