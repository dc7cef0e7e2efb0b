// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/requirements/requirements.hpp"
#include "experiments/tables/table_row.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

std::string labelled(const std::string& label, const std::string& text) {
  constexpr std::size_t indent = 12;
  return wrapped(padded(label, indent), text, indent);
}

/// The errors of a method over all rows against the exact value.
struct Errors {
  std::size_t rows = 0;
  std::size_t failed = 0;  ///< rows of an external method that gave no answers
  double trials = 0;
  double non_finite = 0;
  std::optional<double> largest = {};     ///< empty where no row has one
  std::string where = {};                 ///< the unit of `largest` and its row
  std::optional<double> bound_used = {};  ///< the largest error over its bound; empty without a bound

  void add(const tables::TableRow& row, const compare::Inputs& inputs) {
    ++rows;
    trials += row.optional_number("trials").value_or(0);
    non_finite += row.optional_number("non_finite").value_or(0);
    const bool in_u = row.has("max_error_u");
    const auto error = row.optional_number(in_u ? "max_error_u" : "max_error");
    if (!error) return;
    if (!largest || *error > *largest) {
      largest = error;
      where = fmt::format("{} at {}", in_u ? "u p~" : "coordinate units", row_words(inputs));
    }
    if (const auto bound = row.optional_number("bound_u"); in_u && bound && *bound > 0)
      bound_used = std::max(bound_used.value_or(0), *error / *bound);
  }
};

Errors errors_of(const std::string& method, const std::filesystem::path& bundle) {
  Errors errors;
  const auto directory = bundle::BundleDirectory::open(bundle);
  for (const auto& declared : bundle::declared_tables()) {
    if (declared.method.empty() || declared.column("status") == nullptr) continue;
    const auto table = directory.table(declared.file);
    for (std::size_t at = 0; table && at < table->row_count(); ++at) {
      const tables::TableRow row(*table, at);
      const bool is_exact = !row.has("baseline") || row.text("baseline") == "exact";
      if (row.text(declared.method) != method || !is_exact) continue;
      if (row.text("status") == "ok")
        errors.add(row, compare::Inputs(declared, *table, at, *table));
      else if (!row.text("status").ends_with("_unsupported"))
        ++errors.failed;
    }
  }
  return errors;
}

}  // namespace

void Report::add(const std::string& label, const std::string& text, const std::vector<std::string>& details,
                 std::size_t shown) {
  shown = all ? details.size() : std::min(shown, details.size());
  const auto hidden = details.size() - shown;
  lines += labelled(label, hidden > 0 ? fmt::format("{}; {} more with --all", text, hidden) : text);
  for (std::size_t k = 0; k < shown; ++k) lines += labelled("", details[k]);
}

void Report::add_properties() {
  std::vector<std::string> broken;
  std::size_t decided = 0;
  std::size_t cases = 0;
  for (const auto& evaluator : requirements::evaluators())
    for (const auto& property : requirements::properties()) {
      if (evaluator.info().id != method || !property.concerns(evaluator.info())) continue;
      const auto outcome = property.decide(evaluator);
      ++decided;
      cases += outcome.cases();
      if (outcome.broken() == 0) continue;
      broken.push_back(fmt::format("{}: {}; broken in {} of {} cases, first in {} form, {}", property.id,
                                   property.statement, outcome.broken(), outcome.cases(), name(evaluator.info().form),
                                   outcome.first()));
      findings.push_back(fmt::format("property {} does not hold", property.id));
    }
  add("properties",
      decided == 0 ? "apply to evaluators only"
                   : fmt::format("{} of {} hold, in {} cases", decided - broken.size(), decided, cases),
      broken);
}

void Report::add_errors(const std::filesystem::path& bundle, const std::string& cells, const run::Outcome& judged) {
  const auto errors = errors_of(method, bundle);
  auto text = fmt::format("{} rows of {}, {} trials", errors.rows, printable(cells), number::decimal(errors.trials));
  if (errors.largest) text += fmt::format("; largest error {:.4g} {}", *errors.largest, errors.where);
  if (errors.non_finite > 0) text += fmt::format("; {} results are not finite", number::decimal(errors.non_finite));
  if (errors.failed > 0) {
    text += fmt::format("; {} more without answers", errors.failed);
    findings.push_back(fmt::format("it gives no answers in {} of {} rows", errors.failed, errors.rows + errors.failed));
  }
  add("accuracy", text);
  add_bound(errors.bound_used, judged);
}

void Report::add_bound(std::optional<double> used, const run::Outcome& judged) {
  constexpr double percent = 100;
  if (judged.violations > 0) {
    add("bound", fmt::format("violated {} times", judged.violations));
    findings.emplace_back("the bound is violated");
  } else {
    add("bound", used ? fmt::format("holds in every trial; the largest error is {:.2g} % of it", percent * *used)
                      : "none is stated in units of u p~");
  }
  if (judged.broken_promises > 0)
    findings.push_back(fmt::format("the guarantee does not hold in {} trials", judged.broken_promises));
  if (judged.refuted_proofs > 0) findings.push_back(fmt::format("{} proofs are refuted", judged.refuted_proofs));
}

void Report::add_changes(const std::string& name, const compare::Comparison& comparison) {
  std::vector<std::string> builds;
  for (const std::string fact : {"build.compiler", "build.flags"})
    if (comparison.a->fact(fact) != comparison.b->fact(fact))
      builds.push_back(fmt::format("{} differs: {} before, {} now", fact, printable(comparison.a->fact(fact)),
                                   printable(comparison.b->fact(fact))));
  add("against", printable(name), builds);

  std::vector<std::string> details;
  for (const auto* row : comparison.differing())
    details.push_back(
        fmt::format("{} {} -> {} at {}", row->column, printable(row->a), printable(row->b), row_words(row->inputs)));
  const auto rows = comparison.results.size();
  const auto changed = details.size();
  for (const auto& [singles, what] : {std::pair(&comparison.only_a, "missing"), std::pair(&comparison.only_b, "new")})
    for (const auto& one : *singles)
      if (one.inputs.field("method") == method && one.file != compare::timing_file)
        details.push_back(printable(fmt::format("a row of {} is {}: {}", one.file, what, one.inputs.words())));
  add("  accuracy",
      rows == 0 && details.empty() ? "no rows to compare"
                                   : fmt::format("the same bits in {} of {} rows", rows - changed, rows),
      details);
  if (details.size() > changed) findings.emplace_back("rows are missing or new");
}

void Report::add_counts(const std::vector<compare::Row>& costs) {
  std::multimap<double, std::string, std::greater<>> changed;
  for (const auto& row : costs)
    if (row.verdict == compare::different || all)
      changed.emplace(row.ratio.median, fmt::format("{:.3f}  {} -> {} instructions  {}", row.ratio.median, row.a, row.b,
                                                    row_words(row.inputs)));
  std::vector<std::string> most_costly_first;
  for (auto& [ratio, text] : changed) most_costly_first.push_back(std::move(text));
  add("  counts",
      costs.empty() ? "none: the programs are of different compilers or flags"
                    : fmt::format("the same instructions in {} of {} races",
                                  std::ranges::count(costs, compare::identical, &compare::Row::verdict), costs.size()),
      most_costly_first);
}

void Report::add_times(const std::map<compare::Inputs, PairedTimes>& times, int pairs) {
  using metric::Verdict;
  std::map<Verdict, std::size_t> counts;
  std::multimap<double, std::string, std::greater<>> details;
  bool all_checked = true;
  for (const auto& [inputs, time] : times) {
    const auto verdict = time.verdict();
    ++counts[verdict];
    all_checked = all_checked && time.checked;
    if (!all && time.checked && verdict == Verdict::same) continue;
    const auto ratio = time.ratio();
    details.emplace(ratio.median,
                    fmt::format("{:.3f} [{:.3f}, {:.3f}] {:<10}  {:.4g} -> {:.4g} ns  {}{}", ratio.median, ratio.low,
                                ratio.high, metric::name(verdict), metric::median(time.before),
                                metric::median(time.after), row_words(inputs), time.checked ? "" : ", wrong results"));
  }
  std::vector<std::string> slowest_first;
  for (auto& [ratio, text] : details) slowest_first.push_back(std::move(text));
  const bool is_decided = counts[Verdict::slower] + counts[Verdict::faster] > 0 || !all_checked;
  add("  times",
      fmt::format("{} slower, {} faster, {} same, {} unresolved of {}; now over before, {} pairs of runs",
                  counts[Verdict::slower], counts[Verdict::faster], counts[Verdict::same], counts[Verdict::unresolved],
                  times.size(), pairs),
      slowest_first, is_decided ? 3 : 1);
  if (!all_checked) findings.emplace_back("timed results differ from the judged ones");
}

std::string Report::text() const {
  const auto found = findings.empty() ? "no problem was found" : fmt::to_string(fmt::join(findings, "; "));
  return labelled("verdict", fmt::format("{}: {}", method, found)) + lines;
}

}  // namespace bezierbench::cli
