// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/gate_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/nearest.hpp"
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
      throw Failure(Exit::usage, fmt::format("--fail-on {}: is not a gate{}; choose from {}", echo(word),
                                             suite::suggestion(word, words()), fmt::join(words(), ", ")));
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
    throw Failure(Exit::usage,
                  fmt::format("--threshold {}: must be a share from 0 on, for example 5% or 0.05", echo(text)));
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
        throw Failure(Exit::usage, fmt::format("--fail-on {}: {} and {} do not have {}", name(gate), one.a->name,
                                               one.b->name, rows_missing(gate)));
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

}  // namespace bezierbench::cli
