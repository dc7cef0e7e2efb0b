// SPDX-License-Identifier: MIT
// `check`: what somebody who changed a method wants to know before the change is sent.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/check/programs.hpp"
#include "experiments/cli/check/report.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/curve_sets.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/race/race.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/nearest.hpp"
#include "experiments/suite/pattern.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/text/writer.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {
namespace {

namespace fs = std::filesystem;
using Suites = std::vector<suite::Suite>;

struct CheckOptions {
  std::string method;
  std::optional<std::string> against;
  std::optional<std::string> out;
  int pairs = static_cast<int>(race::repetitions_per_race);
  bool all = false;
  bool quiet = false;
};

/// The problem that the methods of a study solve; empty for a study without methods.
std::optional<Problem> problem_of(const suite::Study& study) {
  const auto& kind = suite::kind_of(study);
  if (suite::find_field(kind, "methods") == nullptr) return std::nullopt;
  if (kind.chains) return Problem::conversion;
  if (kind.problem) return kind.problem;
  if (!kind.timed || study.methods.empty()) return Problem::evaluation;
  for (const auto* info : every_method())
    if (info->problem != Problem::conversion && suite::means(study.methods.front(), info->id)) return info->problem;
  return std::nullopt;
}

/// Whether the study names the method, or all that apply, which peers are not among.
bool names(const suite::Study& study, const std::string& id) {
  if (study.methods.empty()) return !suite::is_peer(id);
  return std::ranges::any_of(study.methods, [&](const auto& pattern) { return suite::means(pattern, id); });
}

/// Whether the method takes the curves of the study and solves its problem.
bool applies(const suite::Study& study, const std::string& id) {
  const auto problem = problem_of(study);
  return std::ranges::any_of(every_method(), [&](const MethodInfo* info) {
    return info->id == id && problem == info->problem && study.form == info->form;
  });
}

/// The studies that `keep` keeps, with no other method.
template <class Keep>
Suites only(Suites suites, const std::string& id, const Keep& keep) {
  for (auto& one : suites) {
    std::erase_if(one.studies, [&](const suite::Study& study) { return !keep(study); });
    for (auto& study : one.studies) study.methods = {id};
  }
  std::erase_if(suites, [](const suite::Suite& one) { return one.studies.empty(); });
  return suites;
}

/// Throws Failure(Exit::usage) where there is no method with this id.
void require_method(const std::string& id) {
  std::vector<std::string> known;
  for (const auto* info : every_method()) known.emplace_back(info->id);
  if (std::ranges::find(known, id) == known.end())
    throw Failure(Exit::usage,
                  fmt::format("{}: no such method{}; see `list methods`", echo(id), suite::suggestion(id, known)));
}

/// The studies of errors that have the method, with no other methods in them; suites without one are left out. A cell's
/// inputs do not depend on its methods, so these give the rows that the whole suite gives.
Suites studies_that_judge(const Suites& suites, const std::string& id) {
  return only(suites, id, [&](const suite::Study& study) {
    return !suite::kind_of(study).timed && names(study, id) && applies(study, id);
  });
}

/// The timing studies that name the method or, where none does, all of its problem, with this method instead.
Suites studies_that_time(const Suites& suites, const std::string& id) {
  const auto times = [&](const suite::Study& study) {
    return studies::is_kind(study, studies::timing_kind) && applies(study, id);
  };
  auto naming = only(suites, id, [&](const suite::Study& study) { return times(study) && names(study, id); });
  return naming.empty() ? only(suites, id, times) : naming;
}

/// The folder of the bundles of a check: the user's, or a temporary one. It is removed at the end unless it is kept, so
/// that after a failure the same command can be given again.
class Workplace {
 public:
  explicit Workplace(const std::optional<std::string>& out) {
    std::string name = out ? *out : (fs::temp_directory_path() / "bezierbench-check-XXXXXX").string();
    if (out && fs::exists(name))
      throw Failure(Exit::usage, fmt::format("--out {}: exists; choose another folder", name));
    if (out ? !fs::create_directories(name) : mkdtemp(name.data()) == nullptr)
      throw Failure(Exit::input_output, fmt::format("{}: cannot be created; see --out", name));
    folder = name;
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(is_kept ? folder / "times" : folder, ignored);
  }

  fs::path folder;
  bool is_kept = false;
};

run::Outcome judge(const Suites& suites, const fs::path& out) {
  auto request = request_of_this_build();
  request.suites = suites;
  request.out = out;
  request.telling = run::Telling::nothing;
  return run::run(request);
}

/// The times of both programs, in turn.
void compare_times(const CheckOptions& options, const fs::path& program, const fs::path& folder, const Suites& quick,
                   Report& report) {
  const auto timed = studies_that_time(quick, options.method);
  if (options.pairs == 0 || timed.empty()) {
    report.add("  times",
               timed.empty() ? "none: no study of suite quick times such methods" : "none: --pairs 0 leaves them out");
    return;
  }
  if (!options.quiet) say(fmt::format("times both programs in turn, {} times each", options.pairs));
  bundle::write_file(folder / "times.toml", suite::to_toml(timed));
  report.add_times(paired_times({program, fs::read_symlink("/proc/self/exe"), folder / "times.toml", folder},
                                options.method, options.pairs),
                   options.pairs);
}

Suites suites_of_bundle(const fs::path& path) {
  const bundle::CheckedReader reader(path);
  constexpr const char* file = "suite.toml";
  auto suites = suite::parse_suites(reader.read(file), reader.place(file), vocabulary_of_all_builds());
  load_curves(suites);
  return suites;
}

Exit check(const CheckOptions& options) {
  require_method(options.method);  // before anything is built
  std::optional<Against> against;
  if (options.against) against = find_against(*options.against, options.quiet);
  const bool has_bundle = against && against->is_bundle;
  const auto quick = suite::read_suites(suite_file("quick"), vocabulary());
  const auto judged = studies_that_judge(has_bundle ? suites_of_bundle(against->path) : quick, options.method);
  if (judged.empty())
    throw Failure(Exit::usage, has_bundle ? fmt::format("{}: does not have errors of {}; name another bundle",
                                                        against->path.string(), options.method)
                                          : fmt::format("{}: is a method of another library, which suites judge only "
                                                        "where they name it; see --against BUNDLE",
                                                        options.method));
  std::optional<compare::Side> before;
  if (has_bundle) before = compare::read_side(against->path);  // a damaged bundle is refused before anything is judged
  Workplace place(options.out);
  if (!options.quiet && has_bundle)
    say(fmt::format("judges the cells that {} has of {} again", against->name, options.method));
  Report report{.method = options.method, .all = options.all};
  report.add_properties();
  const auto after = place.folder / "after";
  const auto outcome = judge(judged, after);
  report.add_errors(after, has_bundle ? against->name : "suite quick", outcome);
  if (against && !has_bundle) {
    bundle::write_file(place.folder / "cells.toml", suite::to_toml(judged));
    run_suite(against->path, place.folder / "cells.toml", place.folder / "before");
    before = compare::read_side(place.folder / "before");
  }
  if (before) report.add_changes(against->name, *before, compare::read_side(after));
  if (against && !has_bundle) compare_times(options, against->path, place.folder, quick, report);
  place.is_kept = options.out.has_value();
  fmt::print("{}", report.text());
  if (report.findings.empty()) return Exit::fine;
  say(fmt::format("{}: {}; see the lines below the verdict", options.method, fmt::join(report.findings, "; ")));
  return Exit::finding;
}

}  // namespace

void add_check(Command program, Exit& exit) {
  auto options = std::make_shared<CheckOptions>();
  auto command = program.command(
      "check", "check a changed method: properties, bound and errors; compare it with a previous state");
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
  command.flag("--quiet", options->quiet, "print no progress");
  command.action([options, &exit] { exit = check(*options); });
}

}  // namespace bezierbench::cli
