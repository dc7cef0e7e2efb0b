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
#include "experiments/cli/check/report.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/race/race.hpp"
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

/// The folder of the bundles of a check: the user's, or a temporary one that is removed at the end. The user's is
/// removed as well where the check fails, so that the same command can be given again.
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
    fs::remove_all(is_kept_ && is_users_ ? folder_ / "times" : folder_, ignored);
  }

  void keep() { is_kept_ = true; }

  [[nodiscard]] fs::path operator/(const char* name) const { return folder_ / name; }
  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  bool is_users_;
  bool is_kept_ = false;
};

run::Outcome judge(const std::vector<suite::Suite>& suites, const fs::path& out) {
  auto request = request_of_this_build();
  request.suites = suites;
  request.out = out;
  request.telling = run::Telling::nothing;
  return run::run(request);
}

/// Runs the other program on the cells of the method, and both in turn for times.
void compare_with_program(const CheckOptions& options, const Against& program, const Workplace& place,
                          const std::vector<suite::Suite>& judged, Report& report) {
  bundle::write_file(place / "cells.toml", suite::to_toml(judged));
  run_suite(program.path, place / "cells.toml", place / "before");
  report.add_changes(program.name, compare::read_side(place / "before"), compare::read_side(place / "after"));
  const auto timed = studies_that_time(quick_suite(), options.method);
  if (options.pairs == 0 || timed.empty()) {
    report.sections.push_back(
        {"  times", timed.empty() ? "none: no study of suite quick times such methods" : "none: not asked for"});
    return;
  }
  if (!options.quiet) say(fmt::format("times both programs in turn, {} times each", options.pairs));
  bundle::write_file(place / "times.toml", suite::to_toml(timed));
  report.add_times(
      paired_times({program.path, fs::read_symlink("/proc/self/exe"), place / "times.toml", place.folder()},
                   options.method, options.pairs),
      options.pairs, options.all);
}

/// The suites whose cells a bundle has, as far as they judge the method.
std::vector<suite::Suite> judged_in_bundle(const fs::path& path, const std::string& method) {
  bundle::CheckedReader reader(path, bundle::Damage::refused);
  constexpr const char* file = "suite.toml";
  const auto suites = suite::parse_suites(reader.read(file), reader.place(file), vocabulary_of_all_builds());
  auto judged = studies_that_judge(suites, method);
  if (judged.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: does not have errors of {}; name another bundle", path.string(), method));
  return judged;
}

Exit check(const CheckOptions& options) {
  methods_named(options.method);  // before anything is built
  std::optional<Against> against;
  if (options.against) against = find_against(*options.against, options.quiet);
  const bool has_bundle = against && against->is_bundle;
  const auto judged =
      has_bundle ? judged_in_bundle(against->path, options.method) : studies_that_judge(quick_suite(), options.method);
  if (judged.empty())
    throw Failure(Exit::usage,
                  fmt::format("{}: is a method of another library, which suites judge only where they name "
                              "it; see --against BUNDLE",
                              options.method));
  std::optional<compare::Side> before;
  if (has_bundle) before = compare::read_side(against->path);  // a damaged bundle is refused before anything is judged
  Workplace place(options.out);
  if (!options.quiet && has_bundle)
    say(fmt::format("judges the cells that {} has of {} again", against->name, options.method));
  Report report{.method = options.method};
  report.add_properties();
  const auto outcome = judge(judged, place / "after");
  report.add_errors(place / "after", has_bundle ? against->name : "suite quick", outcome);
  if (before)
    report.add_changes(against->name, *before, compare::read_side(place / "after"));
  else if (against)
    compare_with_program(options, *against, place, judged, report);
  place.keep();
  fmt::print("{}", report.text(options.all));
  if (report.findings.empty()) return Exit::fine;
  say(fmt::format("{}: {}; see the lines below the verdict", options.method, fmt::join(report.findings, "; ")));
  return Exit::finding;
}

}  // namespace

void add_check(Command program, Exit& exit) {
  auto options = std::make_shared<CheckOptions>();
  auto command = program.command("check", "check a changed method: properties, bound, errors; against what it was");
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
