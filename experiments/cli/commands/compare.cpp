// SPDX-License-Identifier: MIT
// `compare`: the differences between bundles in machine, build, accuracy and time.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/suite/ids.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

using compare::Comparison;

struct CompareOptions {
  std::vector<std::string> bundles;
  std::string format = "text";
  std::string out;
  std::string method = "*";
  bool all = false;
  GateOptions gates{{compare::Gate::any_change}};
};

/// Leaves the rows of the methods that the glob matches.
void keep_methods(const std::string& glob, std::vector<Comparison>& comparisons) {
  bool found = false;
  const auto keep = [&](auto& rows) {
    std::erase_if(rows, [&](const auto& row) { return !suite::matches(glob, row.inputs.field("method")); });
  };
  for (auto& one : comparisons) {
    keep(one.results);
    keep(one.times);
    keep(one.costs);
    keep(one.only_a);
    keep(one.only_b);
    found = found || !one.results.empty() || !one.times.empty();
  }
  if (!found)
    throw Failure(Exit::usage, "--method {}: no method that the bundles have in common matches; see `list methods`",
                  echo(glob));
}

/// Every side with the first; the sides must outlive the comparisons.
std::vector<Comparison> compared(const std::vector<compare::Side>& sides) {
  std::vector<Comparison> comparisons;
  for (std::size_t k = 1; k < sides.size(); ++k) {
    const auto& one = comparisons.emplace_back(compare::compare_sides(sides.front(), sides[k]));
    if (one.results.empty() && one.times.empty() && one.costs.empty())
      throw Failure(Exit::usage,
                    "{}: does not have a row in common with {}; compare bundles of the same studies and seed",
                    sides[k].name, sides.front().name);
  }
  compare::rank(comparisons);
  return comparisons;
}

void print_text(const std::vector<Comparison>& comparisons, bool all) {
  const bool two = comparisons.size() == 1;
  for (const auto& one : comparisons) fmt::print("{}{}", comparison_text(one, two, all), two ? "" : "\n");
  if (!two || (!comparisons.front().same_machine && !comparisons.front().times.empty()))
    fmt::print("{}", standings_text(compare::standings(comparisons)));
}

/// against,bundle,fact,a,b: every fact in which a bundle differs from the first.
bundle::CsvTable facts_table(const std::vector<Comparison>& comparisons) {
  bundle::CsvTable table({"against", "bundle", "fact", "a", "b"});
  for (const auto& one : comparisons)
    for (const auto& fact : compare::fact_differences(*one.a, *one.b))
      table.add_row({one.a->name, one.b->name, fact.name, fact.a, fact.b});
  return table;
}

void write_files(const std::vector<Comparison>& comparisons, const std::filesystem::path& out) {
  if (std::filesystem::exists(out / bundle::manifest_name))
    throw Failure(Exit::usage, "{}: is a bundle itself; choose another --out", out.string());
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error)
    throw Failure(Exit::input_output, "{}: cannot be created: {}; choose another --out", out.string(), error.message());
  bundle::write_file(out / "facts.csv", facts_table(comparisons).text());
  bundle::write_file(out / "comparison.csv", compare::comparison_table(comparisons).text());
  bundle::write_file(out / "standings.csv", compare::standings_table(compare::standings(comparisons)).text());
}

Exit run_compare(const CompareOptions& options) {
  if (options.bundles.size() < 2)
    throw Failure(Exit::usage, "compare: takes two bundles or more; name first the one to compare with");
  std::vector<compare::Side> sides;
  for (const auto& bundle : options.bundles) sides.push_back(compare::read_side(bundle));
  auto comparisons = compared(sides);
  if (options.method != "*") keep_methods(options.method, comparisons);
  if (!options.out.empty()) write_files(comparisons, options.out);
  const auto reports = options.gates.reports(comparisons);
  if (options.format == markdown_format)
    fmt::print("{}", markdown(reports));
  else if (options.format == junit_format)
    fmt::print("{}", junit(reports));
  else if (options.format == "csv")
    fmt::print("{}", compare::comparison_table(comparisons).text());
  else
    print_text(comparisons, options.all);
  return say_findings(findings_of(reports));
}

}  // namespace

void add_compare(Command program, Exit& exit) {
  auto options = std::make_shared<CompareOptions>();
  auto command = program.command("compare", "compare machines, accuracy and times of bundles with the first");
  command.option("BUNDLE", options->bundles, "folders that run wrote; two or more").required().takes(bundle_value);
  command.option("--format", options->format, "csv has every row; markdown and junit have the gates")
      .one_of({"text", "csv", std::string(markdown_format), std::string(junit_format)});
  options->gates.add(command);
  command.option("--out", options->out, "folder for the tables that report --comparison renders").takes(folder_value);
  command.option("--method", options->method, "only methods whose id matches this glob").takes("GLOB", all_methods());
  command.flag("--all", options->all, "every row, not only what changed");
  command.action([options, &exit] { exit = run_compare(*options); });
}

}  // namespace bezierbench::cli
