// SPDX-License-Identifier: MIT
// `run`, and `merge`, which ends what `run --shard` began.
#include "experiments/run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/external/external_options.hpp"
#include "experiments/cli/startup/callgrind.hpp"
#include "experiments/cli/startup/suite_options.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/terminal/text.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/blocks/share.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/text/reader.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// Says what the run gave, where it is and what can be done with it.
void tell_ending(const run::Outcome& outcome, const std::string& out, bool quiet) {
  if (quiet || outcome.ending != run::Ending::complete) return;
  run::note(fmt::format("{}: {}", out, run::ending_line(outcome)));
  run::note(fmt::format("next: `{} report {}`", this_program(), shell_word(out)));
}

struct RunOptions {
  SuiteOptions suites;
  std::string out;
  int jobs = 0;
  std::string reference = "certified";
  std::optional<std::string> shard;
  std::optional<std::string> checkpoint;
  bool dry_run = false;
  bool quiet = false;
  bool host_name = false;
};

std::chrono::milliseconds pause(const std::string& text) {
  constexpr double day = 86400;
  constexpr double milliseconds = 1000;
  const auto seconds = number::parse_number(text);
  if (!seconds || !(*seconds >= 0 && *seconds <= day))
    throw Failure(Exit::usage, "--checkpoint {}: must be a number of seconds from 0 to {}", text, day);
  return std::chrono::milliseconds(std::llround(*seconds * milliseconds));
}

/// Studies that ask for counts get none where Valgrind is missing; one line says so.
void leave_out_counts_without_valgrind(run::RunRequest& request) {
  const auto why = why_uncounted();
  bool is_said = why.empty();
  for (auto& one : request.suites)
    for (auto& study : one.studies) {
      if (study.counts == suite::Counting::none || why.empty()) continue;
      if (study.counts == suite::Counting::only)
        throw Failure(Exit::environment, "{}: counts instructions only, but {}, or leave --counts out", study.id, why);
      study.counts = suite::Counting::none;
      if (!std::exchange(is_said, true)) say(fmt::format("no counts: {}", why));
    }
}

Exit run(const RunOptions& options, const ExternalOptions& external) {
  const auto methods = external.methods();
  auto request = request_of_this_build(methods);
  auto known = vocabulary();
  for (const auto& method : request.external) known.methods.push_back(method.id);
  if (options.out.empty()) throw Failure(Exit::usage, "--out: is empty; name a folder");
  request.quiet = options.quiet;
  request.suites = options.suites.read(known);
  request.curve_files = curves_beside(request.suites);
  for (const auto& file : options.suites.files()) require_recorded(file.string(), methods);
  request.out = options.out;
  request.jobs = options.jobs;
  request.tier = options.reference == "exact" ? reference::Tier::exact : reference::Tier::certified;
  if (options.shard) request.shard = run::shard_of(*options.shard, [](const char* name) { return std::getenv(name); });
  if (options.checkpoint) request.checkpoint = pause(*options.checkpoint);
  request.dry_run = options.dry_run;
  if (options.host_name) request.host_name = bundle::HostName::told;
  leave_out_counts_without_valgrind(request);
  request.count_jobs = [files = std::make_shared<std::vector<std::string>>()] {
    if (files->empty()) *files = counts_by_callgrind();
    return *files;
  };
  if (is_to_count()) {
    run::count(request);
    return Exit::fine;
  }
  const auto outcome = run::run(request);
  const auto exit = say_findings(outcome.findings);
  if (!options.dry_run) tell_ending(outcome, options.out, options.quiet);
  return exit;
}

struct MergeOptions {
  std::vector<std::string> bundles;
  std::string out;
  bool quiet = false;
};

Exit merge(const MergeOptions& options) {
  if (options.out.empty()) throw Failure(Exit::usage, "--out: is empty; name a folder");
  const std::vector<std::filesystem::path> bundles(options.bundles.begin(), options.bundles.end());
  auto request = request_of_this_build();
  const auto first = bundle::BundleDirectory::open(bundles.front());
  constexpr const char* name = "suite.toml";
  const auto text = first.read_listed(name);
  const auto place = (first.path() / name).string();
  request.suites = suite::parse_suites(text, place, vocabulary());
  load_curves(request.suites);
  request.curve_files = curves_beside(request.suites);
  record_external(request, suite::parse_external(text, place));
  request.out = options.out;
  request.quiet = options.quiet;
  const auto outcome = run::merge(std::move(request), bundles);
  const auto exit = say_findings(outcome.findings);
  tell_ending(outcome, options.out, options.quiet);
  return exit;
}

}  // namespace

void add_run(Command program, Exit& exit, std::span<const external::OwnMethod> own) {
  auto options = std::make_shared<RunOptions>();
  auto external = std::make_shared<ExternalOptions>(own);
  auto command = program.command("run", "run suites into a bundle");
  options->suites.add_suites(command);
  command.option("--out", options->out, "folder of the bundle").required().takes(folder_value);
  command.option("--jobs", options->jobs, "number of threads; default: all cores").within(1, 4096);
  options->suites.add_curves(command);
  options->suites.add_changes(command);
  command.option("--reference", options->reference, "how the exact values are computed").one_of({"certified", "exact"});
  command.option("--shard", options->shard, "run part I of N; auto: taken from Open MPI, PMI or Slurm")
      .takes("I/N|auto", [] { return std::vector<std::string>{"auto"}; });
  command.option("--checkpoint", options->checkpoint, "time between two checkpoints; default: 2 % of the time so far")
      .takes("SECONDS");
  command.flag("--dry-run", options->dry_run, "print what would be done, with a rough estimate");
  options->suites.add_no_timing(command);
  options->suites.add_counts(command);
  command.flag("--host-name", options->host_name, "record the name of the host in machine.json");
  command.flag("--quiet", options->quiet, "print errors only");
  command.footer("The keys of a [[study]] in a suite file:\n\n" + kinds_text());
  external->add(command);
  command.action([options, external, &exit] { exit = run(*options, *external); });
}

void add_merge(Command program, Exit& exit) {
  auto options = std::make_shared<MergeOptions>();
  auto command = program.command("merge", "join the shards of a run");
  command.option("BUNDLE", options->bundles, "bundles that run --shard wrote").required().takes(bundle_value);
  command.option("--out", options->out, "folder of the complete bundle").required().takes(folder_value);
  command.flag("--quiet", options->quiet, "print errors only");
  command.action([options, &exit] { exit = merge(*options); });
}

}  // namespace bezierbench::cli
