// SPDX-License-Identifier: MIT
#include "experiments/run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/kinds.hpp"
#include "experiments/cli/commands/run_ending.hpp"
#include "experiments/cli/commands/shard.hpp"
#include "experiments/cli/outside/outside_options.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/known_values.hpp"
#include "experiments/cli/startup/suites_folder.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/cli/terminal/whole_number.hpp"
#include "experiments/number/number.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/suite/overrides.hpp"
#include "experiments/suite/reader.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::cli {
namespace {

struct RunOptions {
  std::vector<std::string> suites;
  std::string out;
  int jobs = 0;
  std::optional<std::string> seed;
  std::optional<std::string> trials;
  std::string reference = "certified";
  std::optional<std::string> shard;
  std::optional<std::string> checkpoint;
  bool dry_run = false;
  bool quiet = false;
  std::optional<std::string> progress;
  bool host_name = false;
  suite::Overrides overrides;
};

std::chrono::milliseconds pause(const std::string& text) {
  constexpr double day = 86400;
  constexpr double milliseconds = 1000;
  const auto seconds = number::parse_number(text);
  if (!seconds || !(*seconds >= 0 && *seconds <= day))
    throw Failure(Exit::usage, fmt::format("--checkpoint {}: must be seconds, a number from 0 to {}", text, day));
  return std::chrono::milliseconds(std::llround(*seconds * milliseconds));
}

run::Telling telling_of(const RunOptions& options) {
  if (options.quiet && options.progress)
    throw Failure(Exit::usage, fmt::format("--progress {}: must not stand beside --quiet", *options.progress));
  if (options.quiet) return run::Telling::nothing;
  return options.progress == "json" ? run::Telling::json : run::Telling::text;
}

Exit run(const RunOptions& options, const OutsideOptions& outside) {
  const auto methods = outside.methods();
  auto request = request_of_this_build(methods);
  auto known = vocabulary();
  for (const auto& method : request.outside) known.methods.push_back(method.id);
  if (options.out.empty()) throw Failure(Exit::usage, "--out: is empty; name a folder");
  request.telling = telling_of(options);
  if (request.telling == run::Telling::json) run::write_notes_as_json();
  for (const auto& word : options.suites) {
    const auto file = suite_file(word).string();
    for (auto& one : suite::read_suites(file, known)) request.suites.push_back(std::move(one));
    require_recorded(file, methods);
    suite::check_unique_ids(request.suites, file);
  }
  suite::apply(options.overrides, request.suites, known);
  request.out = options.out;
  request.jobs = options.jobs;
  request.tier = options.reference == "exact" ? reference::Tier::exact : reference::Tier::certified;
  if (options.shard) request.shard = shard_of(*options.shard, [](const char* name) { return std::getenv(name); });
  if (options.checkpoint) request.checkpoint = pause(*options.checkpoint);
  request.dry_run = options.dry_run;
  if (options.host_name) request.host_name = bundle::HostName::told;
  run::watch_for_interruption();
  const auto outcome = run::run(request);
  for (const auto& finding : outcome.findings) say(finding);
  if (!options.dry_run) tell_ending(outcome, options.out, request.telling);
  return outcome.findings.empty() ? Exit::fine : Exit::finding;
}

}  // namespace

void add_run(Command program, Exit& exit, std::span<const outside::OwnMethod> own) {
  auto options = std::make_shared<RunOptions>();
  auto outside = std::make_shared<OutsideOptions>(own);
  auto command = program.command("run", "run suites into a bundle");
  command
      .option("suites", options->suites, "ids of suites that come with the program, or files: words with a / or .toml")
      .required()
      .takes(suite_value, shipped_suites);
  command.option("--out", options->out, "folder of the bundle").required().takes(folder_value);
  command.option("--jobs", options->jobs, "threads; default: all cores").within(1, 4096);
  command.option("--seed", options->seed, "another seed than the suite's");
  command.option("--trials", options->trials, "trials per cell and replicate").takes("N");
  command
      .option("--set", options->overrides.set,
              "for every study; intervals as 0:0.2; a key that one of them does not have is refused")
      .takes("KEY=V1,V2", known_settings);
  command.option("--only", options->overrides.only, "only studies whose id matches this glob").takes("GLOB");
  command.option("--reference", options->reference, "how the truth is computed").one_of({"certified", "exact"});
  command.option("--shard", options->shard, "do one part of N; auto: ask Open MPI, PMI or Slurm which")
      .takes("I/N|auto", [] { return std::vector<std::string>{"auto"}; });
  command
      .option("--checkpoint", options->checkpoint, "between two files of finished blocks; default: by cost, 2 at most")
      .takes("SECONDS");
  command.flag("--dry-run", options->dry_run, "say what would be done");
  command.flag("--no-timing", options->overrides.no_timing, "leave timing studies out");
  command.flag("--host-name", options->host_name, "let machine.json say the host's name");
  command.flag("--quiet", options->quiet, "say nothing but what is wrong");
  command.option("--progress", options->progress, "on standard error: lines for people, or JSON, an object per line")
      .one_of({"text", "json"});
  command.footer("\nWhat a [[study]] of a suite file says:\n\n" + kinds_text());
  outside->add(command);
  command.action([options, outside, &exit] {
    if (options->seed) options->overrides.seed = static_cast<std::uint64_t>(whole_number("--seed", *options->seed));
    if (options->trials) options->overrides.trials = whole_number("--trials", *options->trials);
    exit = run(*options, *outside);
  });
}

}  // namespace bezierbench::cli
