// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "experiments/bundle/check/checked_reader.hpp"
#include "experiments/bundle/schema/columns.hpp"
#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/compare/accuracy.hpp"
#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"
#include "experiments/requirements/requirements.hpp"
#include "experiments/tables/table_row.hpp"

namespace bezierbench::cli {
namespace {

using metric::Verdict;

/// The errors of a method over all rows against the exact value.
struct Errors {
  std::size_t rows = 0;
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
  bundle::CheckedReader reader(bundle, bundle::Damage::refused);
  for (const auto& declared : bundle::declared_tables()) {
    if (declared.method.empty() || declared.column("status") == nullptr || !reader.has(declared.file)) continue;
    const auto table = bundle::parse_csv(reader.read(declared.file), reader.place(declared.file));
    for (std::size_t at = 0; at < table.row_count(); ++at) {
      const tables::TableRow row(table, at);
      const bool against_truth = !row.has("baseline") || row.text("baseline") == "exact";
      if (row.text(declared.method) == method && row.text("status") == "ok" && against_truth)
        errors.add(row, compare::Inputs(declared, table, at, table));
    }
  }
  return errors;
}

}  // namespace

void Report::add_properties() {
  Section section{"properties", "apply to evaluators only"};
  std::size_t decided = 0;
  std::size_t cases = 0;
  for (const auto& evaluator : requirements::evaluators())
    for (const auto& property : requirements::properties()) {
      if (evaluator.info().id != method || !property.concerns(evaluator.info())) continue;
      const auto outcome = property.decide(evaluator);
      ++decided;
      cases += outcome.cases();
      if (outcome.broken() == 0) continue;
      section.details.push_back(fmt::format("{}: {}; broken in {} of {} cases, first in {} form, {}", property.id,
                                            property.statement, outcome.broken(), outcome.cases(),
                                            name(evaluator.info().form), outcome.first()));
      findings.push_back(fmt::format("property {} does not hold", property.id));
    }
  if (decided > 0)
    section.head = fmt::format("{} of {} hold, in {} cases", decided - section.details.size(), decided, cases);
  sections.push_back(std::move(section));
}

void Report::add_errors(const std::filesystem::path& bundle, const std::string& cells, const run::Outcome& judged) {
  const auto errors = errors_of(method, bundle);
  auto head = fmt::format("{} rows of {}, {} trials", errors.rows, printable(cells), number::decimal(errors.trials));
  if (errors.largest) head += fmt::format("; largest error {:.4g} {}", *errors.largest, errors.where);
  if (errors.non_finite > 0) head += fmt::format("; {} results are not finite", number::decimal(errors.non_finite));
  sections.push_back({"accuracy", std::move(head)});
  add_bound(errors.bound_used, judged);
}

void Report::add_bound(std::optional<double> used, const run::Outcome& judged) {
  constexpr double percent = 100;
  if (judged.violations > 0) {
    sections.push_back({"bound", fmt::format("violated {} times", judged.violations)});
    findings.emplace_back("the bound is violated");
  } else {
    sections.push_back({"bound", used ? fmt::format("holds in every trial; the largest error is {:.2g} % "
                                                    "of it",
                                                    percent * *used)
                                      : "none is stated in units of u p~"});
  }
  if (judged.broken_promises > 0)
    findings.push_back(fmt::format("the guarantee does not hold in {} trials", judged.broken_promises));
  if (judged.refuted_proofs > 0) findings.push_back(fmt::format("{} proofs are refuted", judged.refuted_proofs));
}

void Report::add_changes(const std::string& name, const compare::Side& before, const compare::Side& after) {
  Section builds{"against", printable(name)};
  for (const std::string fact : {"build.compiler", "build.flags"})
    if (before.fact(fact) != after.fact(fact))
      builds.details.push_back(fmt::format("{} differs: {} before, {} now", fact, printable(before.fact(fact)),
                                           printable(after.fact(fact))));
  sections.push_back(std::move(builds));

  const auto accuracy = compare::compare_accuracy(before, after);
  Section section{"  accuracy", "no rows to compare"};
  const auto rows = std::ranges::count_if(
      accuracy.rows, [&](const compare::AccuracyRow& row) { return row.inputs.field("method") == method; });
  for (const auto& change : compare::method_changes(accuracy)) {
    if (change.method != method) continue;
    for (const auto* row : change.differing)
      section.details.push_back(fmt::format("{} {} -> {} at {}", row->shown.column, printable(row->shown.a),
                                            printable(row->shown.b), row_words(row->inputs)));
  }
  const auto changed = section.details.size();
  for (const auto& [others, count] : accuracy.methods)
    if (others.method == method && count.only_a + count.only_b > 0)
      section.details.push_back(
          fmt::format("{} rows are missing and {} are new: {}", count.only_a, count.only_b, printable(others.words())));
  if (rows > 0 || !section.details.empty())
    section.head = fmt::format("the same bits in {} of {} rows", static_cast<std::size_t>(rows) - changed, rows);
  if (changed > 0)
    findings.push_back(fmt::format("accuracy differs in {} of {} rows", changed, rows));
  else if (!section.details.empty())
    findings.emplace_back("rows are missing or new");
  sections.push_back(std::move(section));
}

void Report::add_times(std::vector<PairedTime> times, int pairs, bool all) {
  const auto count = [&](Verdict verdict) { return std::ranges::count(times, verdict, &PairedTime::verdict); };
  const auto slower = count(Verdict::slower);
  const bool wrong = std::ranges::count(times, false, &PairedTime::right) > 0;
  Section section{"  times", fmt::format("{} slower, {} faster, {} same, {} unresolved of {}; now over before, {} "
                                         "pairs of runs",
                                         slower, count(Verdict::faster), count(Verdict::same),
                                         count(Verdict::unresolved), times.size(), pairs)};
  if (slower > 0) findings.push_back(fmt::format("slower in {} of {} races", slower, times.size()));
  if (wrong) findings.emplace_back("timed results differ from the judged ones");
  if (slower == 0 && !wrong && count(Verdict::faster) == 0) section.most = 1;  // nothing is decided
  std::erase_if(times, [&](const PairedTime& time) { return !all && time.right && time.verdict == Verdict::same; });
  std::ranges::stable_sort(times, std::greater(), [](const PairedTime& time) { return time.ratio.median; });
  for (const auto& time : times)
    section.details.push_back(fmt::format("{:.3f} [{:.3f}, {:.3f}] {:<10}  {:.4g} -> {:.4g} ns  {}{}",
                                          time.ratio.median, time.ratio.low, time.ratio.high,
                                          metric::name(time.verdict), time.before.median, time.after.median,
                                          row_words(time.inputs), time.right ? "" : ", wrong results"));
  sections.push_back(std::move(section));
}

std::string Report::text(bool all) const {
  constexpr std::size_t indent = 12;
  const auto line = [](const std::string& label, const std::string& text) {
    return wrapped(padded(label, indent), text, indent);
  };
  auto text = line("verdict",
                   fmt::format("{}: {}", method,
                               findings.empty() ? "no problem was found" : fmt::to_string(fmt::join(findings, "; "))));
  for (const auto& section : sections) {
    const auto shown = all ? section.details.size() : std::min(section.most, section.details.size());
    const auto left = section.details.size() - shown;
    text += line(section.label, left > 0 ? fmt::format("{}; {} more with --all", section.head, left) : section.head);
    for (std::size_t k = 0; k < shown; ++k) text += line("", section.details[k]);
  }
  return text;
}

}  // namespace bezierbench::cli
