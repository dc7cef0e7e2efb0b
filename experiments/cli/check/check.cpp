// SPDX-License-Identifier: MIT
// `check`: what somebody who changed a method wants to know before the change is sent.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/check/against.hpp"
#include "experiments/cli/check/method_studies.hpp"
#include "experiments/cli/check/paired_times.hpp"
#include "experiments/cli/check/program_run.hpp"
#include "experiments/cli/check/report.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/row_words.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/known_values.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/compare/changes.hpp"
#include "experiments/race/repetition.hpp"
#include "experiments/requirements/requirements.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/text/writer.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
  std::string method;
  std::optional<std::string> against;
  std::optional<std::string> out;
  int pairs = static_cast<int>(race::repetitions_per_race);
  bool all = false;
  bool quiet = false;
};

/// The folder of the bundles of a check: the user's, or one that is removed in the end. Also the user's is removed
/// where the check fails, so that the same command can be given again.
class Workplace {
 public:
  explicit Workplace(const std::optional<std::string>& out) : is_users_(out.has_value()) {
    if (out) {
      if (fs::exists(*out)) throw Failure(Exit::usage, fmt::format("--out {}: exists; choose another folder", *out));
      fs::create_directories(*out);
      folder_ = *out;
      return;
    }
    std::string name = (fs::temp_directory_path() / "bezierbench-check-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Failure(Exit::input_output, fmt::format("{}: cannot be created; see --out", name));
    folder_ = name;
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(is_whole_ && is_users_ ? folder_ / "times" : folder_, ignored);
  }

  void is_whole() { is_whole_ = true; }

  [[nodiscard]] fs::path operator/(const char* name) const { return folder_ / name; }
  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  bool is_users_;
  bool is_whole_ = false;
};

CheckedProperties checked_properties(const std::string& id) {
  CheckedProperties all;
  for (const auto& method : requirements::evaluators()) {
    if (method.info().id != id) continue;
    for (const auto& property : requirements::properties()) {
      if (!property.concerns(method.info())) continue;
      const auto outcome = property.decide(method);
      ++all.count;
      all.cases += outcome.cases();
      if (outcome.broken() > 0)
        all.lost.push_back({std::string(property.id), std::string(property.statement),
                            fmt::format("{} form, {}", name(method.info().form), outcome.first()), outcome.broken(),
                            outcome.cases()});
    }
  }
  return all;
}

run::Outcome judge(const std::vector<suite::Suite>& suites, const fs::path& out) {
  auto request = request_of_this_build();
  request.suites = suites;
  request.out = out;
  request.telling = run::Telling::nothing;
  return run::run(request);
}

/// The accuracy of the method in two bundles of the same cells.
void compare_accuracy(const std::string& method, const compare::Side& a, const compare::Side& b,
                      Comparison& comparison) {
  const auto accuracy = compare::compare_accuracy(a, b);
  for (const auto& row : accuracy.rows) comparison.rows += row.inputs.field("method") == method ? 1 : 0;
  for (const auto& change : compare::method_changes(accuracy)) {
    if (change.method != method) continue;
    for (const auto* row : change.differing) {
      const auto result = compare::shown_change(*row);
      comparison.changed.push_back({row_words(row->inputs), result.column, result.a, result.b});
    }
  }
  for (const auto* rows : {&accuracy.methods.other_rows, &accuracy.methods.only_a, &accuracy.methods.only_b})
    for (const auto& one : *rows)
      if (one.method == method) comparison.other.push_back(one);
  for (const std::string fact : {"build.compiler", "build.flags"})
    if (a.fact(fact) != b.fact(fact)) comparison.builds.push_back({fact, a.fact(fact), b.fact(fact)});
}

void compare_with_program(const CheckOptions& options, const fs::path& program, const Workplace& place,
                          const std::vector<suite::Suite>& judged, Comparison& comparison) {
  bundle::write_file(place / "cells.toml", suite::to_toml(judged));
  run_suite(program, place / "cells.toml", place / "before");
  compare_accuracy(options.method, compare::read_side(place / "before"), compare::read_side(place / "after"),
                   comparison);
  const auto timed = studies_that_time(quick_suite(), options.method);
  if (options.pairs == 0 || timed.empty()) {
    comparison.not_timed = timed.empty() ? "no study of suite quick times such methods" : "not asked for";
    return;
  }
  if (!options.quiet) say(fmt::format("times it in both programs in turn, {} times each", options.pairs));
  bundle::write_file(place / "times.toml", suite::to_toml(timed));
  comparison.times = paired_times({program, fs::read_symlink("/proc/self/exe"), place / "times.toml", place.folder()},
                                  options.method, options.pairs);
  comparison.pairs = options.pairs;
}

/// The suites whose cells a bundle has, as far as they judge the method.
std::vector<suite::Suite> judged_in_bundle(const fs::path& path, const std::string& method) {
  bundle::CheckedReader reader(path, bundle::Damage::refused);
  constexpr const char* file = "suite.toml";
  const auto suites = suite::parse_suites(reader.read(file), reader.place(file), vocabulary_of_all_builds());
  auto judged = studies_that_judge(suites, method);
  if (judged.empty())
    throw Failure(Exit::usage, fmt::format("{}: has no errors of {}; name another bundle", path.string(), method));
  return judged;
}

Exit check(const CheckOptions& options) {
  methods_named(options.method);  // before anything is built
  std::optional<Against> against;
  if (options.against) against = find_against(*options.against, options.quiet);
  const bool has_bundle = against && against->kind == Against::Kind::bundle;
  const auto judged =
      has_bundle ? judged_in_bundle(against->path, options.method) : studies_that_judge(quick_suite(), options.method);
  if (judged.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: is of another library, which no suite judges unless it names the method; "
                              "see --against BUNDLE",
                              options.method));
  std::optional<compare::Side> before;
  if (has_bundle) before = compare::read_side(against->path);  // its faults are told before anything is judged
  Workplace place(options.out);
  if (!options.quiet && has_bundle) say(fmt::format("judges again what {} has of {}", against->name, options.method));
  CheckReport report{.method = options.method,
                     .judged_in = has_bundle ? against->name : "suite quick",
                     .properties = checked_properties(options.method),
                     .cells = {},
                     .judged = {},
                     .against = {}};
  report.judged = judge(judged, place / "after");
  report.cells = judged_cells(place / "after", options.method);
  if (against) {
    auto& comparison = report.against.emplace();
    comparison.name = against->name;
    if (before)
      compare_accuracy(options.method, *before, compare::read_side(place / "after"), comparison);
    else
      compare_with_program(options, against->path, place, judged, comparison);
  }
  place.is_whole();
  fmt::print("{}", report.text(options.all));
  const auto found = report.findings();
  if (found.empty()) return Exit::fine;
  say(fmt::format("{}: {}; see the lines below the verdict", options.method, fmt::join(found, "; ")));
  return Exit::finding;
}

}  // namespace

void add_check(Command program, Exit& exit) {
  auto options = std::make_shared<CheckOptions>();
  auto command = program.command("check", "a method that was changed: properties, bound, errors; against what it was");
  command.option("METHOD", options->method, "its id; see list methods").required().takes("METHOD", all_methods());
  command
      .option("--against", options->against,
              "a program or a commit, which is built: errors and times; or a bundle: errors")
      .takes(against_value);
  command
      .option("--pairs", options->pairs, "runs of both programs for the times; from 8 on with a verdict; 0: no times")
      .within(0, 1000);
  command.option("--out", options->out, "new folder, to keep the bundles before and after").takes(folder_value);
  command.flag("--all", options->all, "every row that changed and every time, not only the worst");
  command.flag("--quiet", options->quiet, "say nothing of what takes long");
  command.action([options, &exit] { exit = check(*options); });
}

}  // namespace bezierbench::cli
