// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>

#include "experiments/cli/check/sections.hpp"
#include "experiments/cli/commands/row_words.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

using metric::Verdict;

constexpr std::size_t most_lines = 10;

std::size_t count_of(const Comparison& against, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(against.times, verdict, &PairedTime::verdict));
}

std::size_t count_wrong(const Comparison& against) {
  return static_cast<std::size_t>(std::ranges::count(against.times, false, &PairedTime::right));
}

Section properties_section(const CheckedProperties& properties) {
  if (properties.count == 0)
    return {.label = "properties", .head = "of evaluators only; the tests of this method have others", .details = {}};
  Section section{.label = "properties",
                  .head = fmt::format("{} of {} hold, in {} cases", properties.count - properties.lost.size(),
                                      properties.count, properties.cases),
                  .details = {},
                  .is_finding = !properties.lost.empty()};
  for (const auto& lost : properties.lost)
    section.details.push_back(fmt::format("{}: {}; broken in {} of {} cases, first at {}", lost.name, lost.statement,
                                          lost.broken, lost.cases, lost.first));
  return section;
}

Section accuracy_section(const JudgedCells& cells, const std::string& judged_in) {
  std::string head =
      fmt::format("{} rows of {}, {} trials", cells.cells, printable(judged_in), number::decimal(cells.trials));
  if (cells.worst)
    head += fmt::format("; largest error {:.4g} {} at {}", *cells.worst, cells.in_u ? "u p~" : "coordinate units",
                        cells.where);
  if (cells.non_finite > 0) head += fmt::format("; {} not finite", number::decimal(cells.non_finite));
  return {.label = "accuracy", .head = head, .details = {}};
}

std::string bound_words(const JudgedCells& cells, std::uint64_t violations) {
  constexpr double percent = 100;
  if (cells.violations > 0) return fmt::format("violated in {} trials", number::decimal(cells.violations));
  if (violations > 0) return fmt::format("violated {} times", violations);
  if (!cells.bound_used) return "none is stated in units of u p~";
  return fmt::format("kept in every trial; the largest error is {:.2g} % of it", percent * *cells.bound_used);
}

/// What differs between the two sides and is no result.
Section against_section(const Comparison& against) {
  Section section{.label = "against", .head = printable(against.name), .details = {}};
  for (const auto& build : against.builds)
    section.details.push_back(
        fmt::format("{} differs: {} before, {} now", build.name, printable(build.a), printable(build.b)));
  return section;
}

Section same_accuracy_section(const Comparison& against) {
  if (against.rows == 0 && against.other.empty())
    return {.label = "  accuracy", .head = "no rows to compare", .details = {}};
  Section section{
      .label = "  accuracy",
      .head = fmt::format("the same bits in {} of {} rows", against.rows - against.changed.size(), against.rows),
      .details = {},
      .is_finding = !against.changed.empty() || !against.other.empty()};
  for (const auto& row : against.changed)
    section.details.push_back(
        fmt::format("{} {} -> {} at {}", row.column, printable(row.before), printable(row.after), row.where));
  for (const auto& rows : against.other)
    section.details.push_back(fmt::format("other rows: {}", printable(rows.words())));
  return section;
}

std::string time_words(const PairedTime& time) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}] {:<10}  {:.4g} -> {:.4g} ns  {}{}", time.ratio.median, time.ratio.low,
                     time.ratio.high, metric::name(time.verdict), time.before.median, time.after.median,
                     row_words(time.inputs), time.right ? "" : ", wrong results");
}

/// Whether a time is a finding by itself.
bool is_decided(const PairedTime& time) {
  return !time.right || time.verdict == Verdict::slower || time.verdict == Verdict::faster;
}

/// Lists times by descending ratio. Without `all` the verdict `same` is left out, and if no verdict is slower or faster,
/// one time at most is shown.
Section times_section(const Comparison& against, bool all) {
  Section section{
      .label = "  times",
      .head = fmt::format("{} slower, {} faster, {} same, {} unresolved of {}; now over before, {} pairs of runs",
                          count_of(against, Verdict::slower), count_of(against, Verdict::faster),
                          count_of(against, Verdict::same), count_of(against, Verdict::unresolved),
                          against.times.size(), against.pairs),
      .details = {},
      .is_finding = count_of(against, Verdict::slower) > 0 || count_wrong(against) > 0};
  auto times = against.times;
  std::erase_if(times, [&](const PairedTime& time) { return !all && time.right && time.verdict == Verdict::same; });
  std::ranges::stable_sort(times, std::greater(), [](const PairedTime& time) { return time.ratio.median; });
  if (std::ranges::none_of(times, is_decided)) section.most = 1;
  for (const auto& time : times) section.details.push_back(time_words(time));
  return section;
}

void add_comparison(const Comparison& against, bool all, std::vector<Section>& sections) {
  sections.push_back(against_section(against));
  sections.push_back(same_accuracy_section(against));
  if (against.pairs > 0)
    sections.push_back(times_section(against, all));
  else if (!against.not_timed.empty())
    sections.push_back({.label = "  times", .head = "none: " + against.not_timed, .details = {}});
}

}  // namespace

std::vector<std::string> CheckReport::findings() const {
  std::vector<std::string> all;
  for (const auto& lost : properties.lost) all.push_back(fmt::format("property {} is lost", lost.name));
  if (judged.violations > 0) all.emplace_back("the bound is violated");
  if (judged.broken_promises > 0)
    all.push_back(fmt::format("what it promises does not hold in {} trials", judged.broken_promises));
  if (judged.refuted_proofs > 0) all.push_back(fmt::format("proofs refuted: {}", judged.refuted_proofs));
  if (!against) return all;
  if (const auto changed = against->changed.size(); changed > 0)
    all.push_back(fmt::format("accuracy differs in {} of {} rows", changed, against->rows));
  if (against->changed.empty() && !against->other.empty()) all.emplace_back("results are missing or new");
  if (const auto slower = count_of(*against, Verdict::slower); slower > 0)
    all.push_back(fmt::format("slower in {} of {} races", slower, against->times.size()));
  if (count_wrong(*against) > 0) all.emplace_back("timed results are not the judged ones");
  return all;
}

std::string CheckReport::text(bool all) const {
  const auto found = findings();
  const auto verdict = found.empty() ? "nothing wrong was found" : fmt::format("{}", fmt::join(found, "; "));
  std::vector<Section> sections{{.label = "verdict", .head = fmt::format("{}: {}", method, verdict), .details = {}},
                                properties_section(properties),
                                accuracy_section(cells, judged_in),
                                {.label = "bound", .head = bound_words(cells, judged.violations), .details = {}}};
  if (against) add_comparison(*against, all, sections);
  return all ? whole_text_of(sections, output_width()) : text_of(sections, most_lines, output_width());
}

}  // namespace bezierbench::cli
