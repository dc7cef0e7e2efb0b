// SPDX-License-Identifier: MIT
#include "experiments/cli/check/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>

#include "experiments/cli/commands/row_words.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {
namespace {

using metric::Verdict;

constexpr std::size_t most_shown = 3;  // of changes of one sort, unless all are asked for

std::size_t shown_of(std::size_t count, bool all) { return all ? count : std::min(count, most_shown); }

std::size_t count_of(const Comparison& against, Verdict verdict) {
  return static_cast<std::size_t>(std::ranges::count(against.times, verdict, &PairedTime::verdict));
}

std::size_t count_wrong(const Comparison& against) {
  return static_cast<std::size_t>(std::ranges::count(against.times, false, &PairedTime::right));
}

std::string line(std::string_view label, const std::string& text) {
  constexpr std::size_t indent = 12;
  return wrapped(padded(label, indent), text, indent);
}

std::string more(std::size_t left) { return left > 0 ? line("", fmt::format("and {} more; see --all", left)) : ""; }

std::string more(std::size_t count, bool all) { return more(count - shown_of(count, all)); }

std::string properties_text(const CheckedProperties& properties) {
  if (properties.count == 0) return line("properties", "of evaluators only; the tests of this method have others");
  std::string text =
      line("properties", fmt::format("{} of {} hold, in {} cases", properties.count - properties.lost.size(),
                                     properties.count, properties.cases));
  for (const auto& lost : properties.lost)
    text += line("", fmt::format("{}: {}; broken in {} of {} cases, first at {}", lost.name, lost.statement,
                                 lost.broken, lost.cases, lost.first));
  return text;
}

std::string accuracy_text(const JudgedCells& cells, const std::string& judged_in) {
  std::string text =
      fmt::format("{} rows of {}, {} trials", cells.cells, printable(judged_in), number::decimal(cells.trials));
  if (cells.worst)
    text += fmt::format("; largest error {:.4g} {}", *cells.worst, cells.in_u ? "u p~" : "coordinate units");
  if (cells.non_finite > 0) text += fmt::format("; {} not finite", number::decimal(cells.non_finite));
  text = line("accuracy", text);
  return cells.worst ? text + line("", "at " + cells.where) : text;
}

std::string bound_text(const JudgedCells& cells, std::uint64_t violations) {
  constexpr double percent = 100;
  if (cells.violations > 0)
    return line("bound", fmt::format("violated in {} trials", number::decimal(cells.violations)));
  if (violations > 0) return line("bound", fmt::format("violated {} times", violations));
  if (!cells.bound_used) return line("bound", "none is stated in units of u p~");
  return line("bound",
              fmt::format("kept in every trial; the largest error is {:.2g} % of it", percent * *cells.bound_used));
}

std::string same_accuracy_text(const Comparison& against, bool all) {
  if (against.rows == 0 && against.other.empty()) return line("  accuracy", "no rows to compare");
  std::string text = line(
      "  accuracy", fmt::format("the same bits in {} of {} rows", against.rows - against.changed.size(), against.rows));
  for (std::size_t k = 0; k < shown_of(against.changed.size(), all); ++k) {
    const auto& row = against.changed[k];
    text += line("", fmt::format("{} {} -> {}", row.column, printable(row.before), printable(row.after)));
    text += line("", "  at " + row.where);
  }
  text += more(against.changed.size(), all);
  for (std::size_t k = 0; k < shown_of(against.other.size(), all); ++k)
    text += line("", fmt::format("other rows: {}", printable(against.other[k].words())));
  return text + more(against.other.size(), all);
}

std::string time_line(const PairedTime& time) {
  return line("", fmt::format("{:.3f} [{:.3f}, {:.3f}] {:<10}  {:.4g} -> {:.4g} ns  {}{}", time.ratio.median,
                              time.ratio.low, time.ratio.high, metric::name(time.verdict), time.before.median,
                              time.after.median, row_words(time.inputs), time.right ? "" : ", wrong results"));
}

/// Whether a time is a finding by itself.
bool is_decided(const PairedTime& time) {
  return !time.right || time.verdict == Verdict::slower || time.verdict == Verdict::faster;
}

/// The times that are not certainly the same, or all, the slowest first; where none is decided, the first alone.
std::string times_text(const Comparison& against, bool all) {
  if (against.pairs == 0) return against.not_timed.empty() ? "" : line("  times", "none: " + against.not_timed);
  std::string text = line(
      "  times", fmt::format("{} slower, {} faster, {} same, {} unresolved of {}; now over before, {} pairs of runs",
                             count_of(against, Verdict::slower), count_of(against, Verdict::faster),
                             count_of(against, Verdict::same), count_of(against, Verdict::unresolved),
                             against.times.size(), against.pairs));
  auto times = against.times;
  std::erase_if(times, [&](const PairedTime& time) { return !all && time.right && time.verdict == Verdict::same; });
  std::ranges::stable_sort(times, std::greater(), [](const PairedTime& time) { return time.ratio.median; });
  const std::size_t most = std::ranges::any_of(times, is_decided) ? most_shown : 1;
  const std::size_t shown = all ? times.size() : std::min(times.size(), most);
  for (std::size_t k = 0; k < shown; ++k) text += time_line(times[k]);
  return text + more(times.size() - shown);
}

std::string against_text(const Comparison& against, bool all) {
  std::string text = line("against", printable(against.name));
  for (const auto& build : against.builds)
    text += line("", fmt::format("{} differs: {} before, {} now", build.name, printable(build.a), printable(build.b)));
  return text + same_accuracy_text(against, all) + times_text(against, all);
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
  return line("verdict",
              fmt::format("{}: {}", method,
                          found.empty() ? "nothing wrong was found" : fmt::format("{}", fmt::join(found, "; ")))) +
         properties_text(properties) + accuracy_text(cells, judged_in) + bound_text(cells, judged.violations) +
         (against ? against_text(*against, all) : "");
}

}  // namespace bezierbench::cli
