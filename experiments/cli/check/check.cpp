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
#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/check/report.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/comparison_text.hpp"
#include "experiments/cli/external/external_options.hpp"
#include "experiments/cli/startup/callgrind.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/race/race.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/reader.hpp"
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
  std::string format = "text";
  GateOptions gates{compare::gates()};
};

/// The method that is checked.
struct Checked {
  std::string id;
  external::Methods external;                     ///< those of this command
  const suite::ExternalMethod* record = nullptr;  ///< its own, if it is external
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

/// Whether the study names the method, or all that apply, which peers are not among. External ones are in every study
/// that they can be in.
bool names(const suite::Study& study, const Checked& checked) {
  if (checked.record != nullptr) return true;
  const auto& id = checked.id;
  if (study.methods.empty()) return !suite::is_peer(id);
  return std::ranges::any_of(study.methods, [&](const auto& pattern) { return suite::means(pattern, id); });
}

/// Whether the method takes the curves of the study and solves its problem.
bool applies(const suite::Study& study, const Checked& checked) {
  if (checked.record != nullptr) return studies::why_unasked(study, *checked.record).empty();
  const auto& id = checked.id;
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

/// The method with this id. Throws Failure(Exit::usage) where there is none.
Checked find_method(const std::string& id, const ExternalOptions& external) {
  Checked checked{id, external.methods()};
  if (suite::is_external(id)) {
    const auto* method = external::find(checked.external, id);
    if (method == nullptr)
      throw Failure(Exit::usage,
                    "{}: is external and was not given; give it with --plugin or --program, or check it with the "
                    "program that has it compiled in",
                    echo(id));
    checked.record = &method->record();
    return checked;
  }
  std::vector<std::string> known;
  for (const auto* info : every_method()) known.emplace_back(info->id);
  if (std::ranges::find(known, id) == known.end())
    throw Failure(Exit::usage, "{}: no such method{}; see `list methods`", echo(id), suite::suggestion(id, known));
  return checked;
}

/// The studies of errors that have the method, with no other methods in them; suites without one are left out. A cell's
/// inputs do not depend on its methods, so these give the rows that the whole suite gives.
Suites studies_that_judge(const Suites& suites, const Checked& checked) {
  return only(suites, checked.id, [&](const suite::Study& study) {
    return !suite::kind_of(study).timed && names(study, checked) && applies(study, checked);
  });
}

/// The timing studies that name the method or, where none does, all of its problem, with this method instead.
Suites studies_that_time(const Suites& suites, const Checked& checked) {
  const auto times = [&](const suite::Study& study) {
    return studies::is_kind(study, studies::timing_kind) && applies(study, checked);
  };
  auto naming =
      only(suites, checked.id, [&](const suite::Study& study) { return times(study) && names(study, checked); });
  return naming.empty() ? only(suites, checked.id, times) : naming;
}

/// The folder of the bundles of a check: the user's, or a temporary one. It is removed at the end unless it is kept, so
/// that after a failure the same command can be given again.
class Workplace {
 public:
  explicit Workplace(const std::optional<std::string>& out) {
    std::string name = out ? *out : (fs::temp_directory_path() / "bezierbench-check-XXXXXX").string();
    if (out && fs::exists(name)) throw Failure(Exit::usage, "--out {}: exists; choose another folder", name);
    if (out ? !fs::create_directories(name) : mkdtemp(name.data()) == nullptr)
      throw Failure(Exit::input_output, "{}: cannot be created; see --out", name);
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

run::Outcome judge(const Suites& suites, const external::Methods& external, const fs::path& out) {
  auto request = request_of_this_build(external);
  request.suites = suites;
  request.out = out;
  request.quiet = true;
  return run::run(request);
}

/// A row of times that were taken in pairs.
compare::Row row_of(const compare::Inputs& inputs, const PairedTimes& times) {
  compare::Row row{.file = compare::timing_file, .inputs = inputs, .column = "median_ns", .a = "", .b = ""};
  row.ratio = times.ratio();
  row.verdict = metric::name(times.verdict());
  row.timed = compare::Timed{.a = row.ratio, .b = row.ratio, .judged = row.ratio, .quality = times.quality()};
  return row;
}

/// What of two runs is of one method.
void keep_only(const std::string& id, compare::Comparison& comparison) {
  for (auto* rows : {&comparison.results, &comparison.times, &comparison.costs})
    std::erase_if(*rows, [&](const compare::Row& row) { return row.inputs.field("method") != id; });
}

/// Both states of a method: the bundles of its results, and the rows of its times and counts.
struct States {
  compare::Side before;
  compare::Side after;
  std::vector<compare::Side> counted = {};  ///< what the counts refer to
};

/// Adds the instructions that both programs take, and their times in turn.
void compare_speed(const CheckOptions& options, const Programs& programs, const Suites& timed, States& states,
                   compare::Comparison& comparison, Report& report) {
  if (timed.empty()) return report.add("  times", "none: no study of suite quick times such methods");
  bundle::write_file(programs.suite, suite::to_toml(timed));
  if (const auto why = why_uncounted(); !why.empty()) {
    report.add("  counts", "none: " + why);
  } else {
    for (const auto* program : {&programs.before, &programs.after}) {
      const auto out = programs.scratch / fmt::format("counts-{}", states.counted.size());
      run_suite(*program, programs.suite, out, {"--counts", "--no-timing"});
      states.counted.push_back(compare::read_side(out));
      fs::remove_all(out);
    }
    comparison.costs = compare::compare_sides(states.counted[0], states.counted[1]).costs;
    keep_only(options.method, comparison);
    report.add_counts(comparison.costs);
  }
  if (options.pairs == 0) return report.add("  times", "none: --pairs 0 leaves them out");
  if (!options.quiet) say(fmt::format("times both programs in turn, {} times each", options.pairs));
  const auto times = paired_times(programs, options.method, options.pairs);
  comparison.times.clear();
  for (const auto& [inputs, time] : times) comparison.times.push_back(row_of(inputs, time));
  report.add_times(times, options.pairs);
}

Exit tell(const CheckOptions& options, Report& report, const std::vector<compare::GateReport>& gates) {
  const auto others = report.findings;
  for (const auto& gate : gates)
    if (auto finding = gate.brief(); !finding.empty()) report.findings.push_back(std::move(finding));
  if (options.format == junit_format)
    fmt::print("{}", junit(gates, others));
  else if (options.format == markdown_format)
    fmt::print("{}\n```text\n{}```\n", markdown(gates, others), report.text());
  else
    fmt::print("{}", report.text());
  if (report.findings.empty()) return Exit::fine;
  say(fmt::format("{}: {}; see the lines below the verdict", options.method, fmt::join(report.findings, "; ")));
  return Exit::finding;
}

Suites suites_of_bundle(const fs::path& path) {
  const auto bundle = bundle::BundleDirectory::open(path);
  constexpr const char* file = "suite.toml";
  auto suites = suite::parse_suites(bundle.read_listed(file), bundle.place(file), vocabulary_of_all_builds());
  load_curves(suites);
  return suites;
}

Exit check(const CheckOptions& options, const ExternalOptions& external) {
  const auto checked = find_method(options.method, external);  // before anything is built
  const TestedProgram now{fs::read_symlink("/proc/self/exe"), external.arguments()};
  std::optional<Against> against;
  if (options.against) against = find_against(*options.against, now, checked.record, options.quiet);
  const bool has_bundle = against && against->is_bundle;
  const auto quick = suite::read_suites(suite_file("quick"), vocabulary());
  const auto judged = studies_that_judge(has_bundle ? suites_of_bundle(against->bundle) : quick, checked);
  if (judged.empty())
    throw Failure(
        Exit::usage,
        has_bundle ? fmt::format("{}: does not have errors of {}; name another bundle", against->name, options.method)
                   : fmt::format("{}: {}; see --against BUNDLE", options.method,
                                 checked.record != nullptr ? "no study of suite quick has curves that it takes"
                                                           : "is a method of another library, which suites judge only "
                                                             "where they name it"));
  std::optional<compare::Side> before;
  if (has_bundle) before = compare::read_side(against->bundle);  // a damaged one is refused before anything is judged
  Workplace place(options.out);
  if (!options.quiet && has_bundle)
    say(fmt::format("judges the cells that {} has of {} again", against->name, options.method));
  Report report{.method = options.method, .all = options.all};
  report.add_properties();
  const auto after = place.folder / "after";
  const auto outcome = judge(judged, checked.external, after);
  report.add_errors(after, has_bundle ? against->name : "suite quick", outcome);
  if (against && !has_bundle) {
    bundle::write_file(place.folder / "cells.toml", suite::to_toml(judged));
    run_suite(against->program, place.folder / "cells.toml", place.folder / "before", {});
    before = compare::read_side(place.folder / "before");
  }
  std::vector<compare::GateReport> gates;
  std::vector<compare::Comparison> comparisons;
  std::optional<States> states;
  if (before) {
    states = States{std::move(*before), compare::read_side(after)};
    auto& comparison = comparisons.emplace_back(compare::compare_sides(states->before, states->after));
    keep_only(options.method, comparison);
    report.add_changes(against->name, comparison);
    if (!has_bundle)
      compare_speed(options, {against->program, now, place.folder / "times.toml", place.folder},
                    studies_that_time(quick, checked), *states, comparison, report);
    gates = options.gates.reports(comparisons);
  }
  place.is_kept = options.out.has_value();
  return tell(options, report, gates);
}

}  // namespace

void add_check(Command program, Exit& exit, std::span<const external::OwnMethod> own) {
  auto options = std::make_shared<CheckOptions>();
  auto external = std::make_shared<ExternalOptions>(own);
  auto command = program.command(
      "check", "check a changed method: properties, bound and errors; compare it with a previous state");
  command.option("METHOD", options->method, "its id; see list methods").required().takes("METHOD", all_methods());
  command
      .option(
          "--against", options->against,
          "a program, a commit, which is built, or the external method before the change: errors, counts and times; "
          "or a bundle: errors")
      .takes(against_value);
  options->gates.add(command);
  command.option("--format", options->format, "markdown and junit have the gates")
      .one_of({"text", std::string(markdown_format), std::string(junit_format)});
  command
      .option("--pairs", options->pairs, "runs of both programs for the times; from 8 on with a verdict; 0: no times")
      .within(0, 1000);
  command.option("--out", options->out, "new folder, to keep the bundles before and after").takes(folder_value);
  command.flag("--all", options->all, "every row that changed and every time, not only the worst");
  command.flag("--quiet", options->quiet, "print no progress");
  external->add(command);
  command.action([options, external, &exit] { exit = check(*options, *external); });
}

}  // namespace bezierbench::cli
