// SPDX-License-Identifier: MIT
#include <memory>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/commands/run_ending.hpp"
#include "experiments/cli/startup/curve_sets.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/text/reader.hpp"

namespace bezierbench::cli {
namespace {

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
  request.telling = options.quiet ? run::Telling::nothing : run::Telling::text;
  const auto telling = request.telling;
  const auto outcome = run::merge(std::move(request), bundles);
  const auto exit = say_findings(outcome.findings);
  tell_ending(outcome, options.out, telling);
  return exit;
}

}  // namespace

void add_merge(Command program, Exit& exit) {
  auto options = std::make_shared<MergeOptions>();
  auto command = program.command("merge", "join the shards of a run");
  command.option("BUNDLE", options->bundles, "bundles that run --shard wrote").required().takes(bundle_value);
  command.option("--out", options->out, "folder of the complete bundle").required().takes(folder_value);
  command.flag("--quiet", options->quiet, "print errors only");
  command.action([options, &exit] { exit = merge(*options); });
}

}  // namespace bezierbench::cli
