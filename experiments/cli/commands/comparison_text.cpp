// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "experiments/cli/commands/aligned.hpp"
#include "experiments/cli/commands/row_words.hpp"
#include "experiments/compare/changes.hpp"
#include "experiments/echo.hpp"

namespace bezierbench::cli {
namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string side_line(std::string_view label, const compare::Side& side) {
  return printable(fmt::format("{}  {}: {}, {}, {}", label, side.name, side.fact("cpu.model_name"),
                               side.fact("build.compiler"), side.fact("build.flags"))) +
         "\n";
}

std::string facts_text(const compare::Pair& pair) {
  if (pair.facts.empty()) return "machines and builds: no recorded difference\n";
  Lines lines;
  for (const auto& fact : pair.facts) {
    lines.push_back({"  " + fact.name, "a", fact.a});
    lines.push_back({"", "b", fact.b});
  }
  return fmt::format("machines and builds differ in\n{}", aligned(lines));
}

std::string recorded_text(const compare::Side& side, std::string_view label, const compare::Inputs& inputs) {
  const auto input = compare::recorded_input(side, inputs);
  if (!input) return fmt::format("  {} has recorded no worst input of it\n", label);
  return fmt::format("  {}: worst at trial {}, t {}, coefficients {}\n     bezierbench replay {} {}\n", label,
                     printable(input->trial), printable(input->t), printable(input->coefficients), printable(side.name),
                     printable(input->id));
}

std::string difference_text(const compare::Side& a, const compare::Side& b, const compare::AccuracyRow& row) {
  return fmt::format("  the first of them: {}, {}\n  a: {} {}, line {}\n  b: {} {}, line {}\n{}{}", row.file,
                     printable(row.inputs.words()), row.column, printable(row.a), row.line_a, row.column,
                     printable(row.b), row.line_b, recorded_text(a, "a", row.inputs),
                     recorded_text(b, "b", row.inputs));
}

/// The names of tables, studies and methods, a few of them.
std::string named_rows(std::string_view what, const std::vector<bundle::Rows>& all) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t k = 0; k < std::min(all.size(), most); ++k)
    text += fmt::format("    {}: {}\n", what, printable(all[k].words()));
  if (all.size() > most) text += fmt::format("    {}: {} more\n", what, all.size() - most);
  return text;
}

std::string methods_text(const compare::MethodComparison& methods) {
  std::string text = fmt::format("  by table, study and method: {} agree", methods.agreeing.size());
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
  return text + "\n" + names;
}

/// A line for each method that differs, or for each of its rows, the largest growth first.
std::string changed_methods_text(const compare::AccuracyComparison& accuracy, bool all) {
  Lines lines{{"  method", "rows", "of", "result", "a", "b", "where"}};
  for (const auto& change : compare::method_changes(accuracy)) {
    const auto add = [&](const compare::AccuracyRow& row, bool is_first) {
      const auto [column, a, b] = compare::shown_change(row);
      lines.push_back({is_first ? "  " + change.method : "", is_first ? std::to_string(change.differing.size()) : "",
                       is_first ? std::to_string(change.rows) : "", column, a, b, row_words(row.inputs)});
    };
    for (const auto* row : change.differing) {
      add(*row, row == change.differing.front());
      if (!all) break;
    }
  }
  return aligned(lines);
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
    text += fmt::format("  seeds {} and {}: other inputs, so nothing to compare\n", a.manifest.seed, b.manifest.seed);
  else
    text += methods_text(accuracy.methods);
  if (accuracy.only_a + accuracy.only_b > 0)
    text += fmt::format("  {} rows only in a, {} only in b\n", accuracy.only_a, accuracy.only_b);
  for (const auto& file : accuracy.left_out)
    text += fmt::format("  {} left out: the suites differ, and its rows do not say of how many trials\n", file);
  return text;
}

std::string time_text(const metric::Interval& ns) { return fmt::format("{:.4g}", ns.median); }

std::string ratio_text(const compare::TimeRatio& of) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", of.ratio.median, of.ratio.low, of.ratio.high);
}

std::vector<std::string> header_of_times() {
  return {"  method", "a ns", "b ns", "b/a", "", "in sentinels", "", "rank a b"};
}

std::vector<std::string> timing_line(const compare::TimingRow& row) {
  std::vector<std::string> line{"  " + row.inputs.field("method"), time_text(row.a), time_text(row.b),
                                ratio_text(row.raw), std::string(metric::name(row.raw.verdict))};
  line.push_back(row.normalised ? ratio_text(*row.normalised) : "");
  line.emplace_back(row.normalised ? metric::name(row.normalised->verdict) : "");
  line.push_back(row.rank_a == 0 ? "" : fmt::format("{} {}", row.rank_a, row.rank_b));
  if (!row.is_ok()) line.push_back(row.quality);
  return line;
}

std::string counts_text(const compare::TimingComparison& timing) {
  std::map<metric::Verdict, std::size_t> counts;
  std::size_t methods = 0;
  for (const auto& row : timing.rows) {
    if (row.is_sentinel()) continue;
    ++methods;
    ++counts[row.raw.verdict];
  }
  using metric::Verdict;
  return fmt::format("{} slower, {} same, {} faster, {} unresolved of {} times", counts[Verdict::slower],
                     counts[Verdict::same], counts[Verdict::faster], counts[Verdict::unresolved], methods);
}

/// The verdict that compares methods: in sentinels where the machines differ.
const compare::TimeRatio& judged_ratio(const compare::TimingRow& row, bool same_machine) {
  return same_machine || !row.normalised ? row.raw : *row.normalised;
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
  return fmt::format("{}; {}{}\n", text, pair.timing.rows.empty() ? "no times in common" : counts_text(pair.timing),
                     pair.same_machine ? "" : "; different machines");
}

std::string differences_text(const compare::Side& a, const compare::Side& b, const compare::Pair& pair, bool all) {
  return side_line("a", a) + side_line("b", b) + "\n" + facts_text(pair) + "\n" +
         accuracy_text(a, b, pair.accuracy, all);
}

std::string timing_summary(const compare::Pair& pair) {
  if (pair.timing.rows.empty()) return "timing: no common rows\n";
  const auto doubtful = std::ranges::count_if(
      pair.timing.rows, [](const compare::TimingRow& row) { return !row.is_sentinel() && !row.is_ok(); });
  std::string text = "timing, b over a: " + counts_text(pair.timing);
  if (doubtful > 0) text += fmt::format("; {} doubtful, marked", doubtful);
  text +=
      pair.same_machine
          ? "\n  the same kind of machine: b/a compares the builds; in sentinels, a change of its clock is taken out\n"
          : "\n  different machines: b/a compares them; in sentinels, steps of fixed work timed beside, it compares "
            "the methods\n";
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
  Lines lines{header_of_times()};
  for (const auto* row : changed) {
    lines.push_back(timing_line(*row));
    lines.back().insert(lines.back().begin() + 1, row_words(row->inputs));
  }
  lines.front().insert(lines.front().begin() + 1, "where");
  return aligned(lines);
}

std::string timing_text(const compare::TimingComparison& timing) {
  Lines lines{header_of_times()};
  std::optional<compare::Inputs> race;
  for (const auto& row : timing.rows) {
    if (auto inputs = row.inputs.without_method(); inputs != race) {
      lines.push_back({inputs.words()});
      race = std::move(inputs);
    }
    lines.push_back(timing_line(row));
  }
  return aligned(lines);
}

std::string rank_changes_text(const compare::TimingComparison& timing) {
  std::string text;
  for (const auto& row : timing.rows)
    if (row.changed_place)
      text += fmt::format("  {}: {} in a, {} in b{}\n", printable(row.inputs.words()), row.rank_a, row.rank_b,
                          row.is_ok() ? "" : ", " + printable(row.quality));
  constexpr std::string_view among = "among the methods of a race that both bundles have";
  return text.empty()
             ? fmt::format("ranks: none changed, {}\n", among)
             : fmt::format(
                   "ranks that changed, where both bundles resolve it, 1 + how many are certainly faster, {}\n{}",
                   among, text);
}

std::string standings_text(const std::vector<compare::Standing>& standings) {
  Lines lines{{"  rank", "bundle", "cpu", "compiler", "accuracy", "time", "in sentinels"}};
  for (const auto& one : standings) {
    const auto mean = [&](double value) { return one.rank ? fmt::format("{:.3f}", value) : ""; };
    lines.push_back({one.rank ? fmt::format("  {}", *one.rank) : "", one.bundle, one.cpu, one.compiler,
                     one.differing == 0 ? "identical" : fmt::format("{} rows differ", one.differing),
                     mean(one.mean_ratio), mean(one.mean_normalised)});
  }
  return fmt::format("geometric mean of time over the first bundle's, {} common timings\n{}", standings.front().timings,
                     aligned(lines));
}

}  // namespace bezierbench::cli
