// SPDX-License-Identifier: MIT
#include "experiments/bundle/check/verify.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/kernel_share.hpp"
#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/startup/this_build.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/echo.hpp"
#include "experiments/run/plan.hpp"
#include "experiments/suite/text/reader.hpp"

namespace bezierbench::cli {
namespace {

void print_fine(const std::string& path) {
  const auto share = bundle::kernel_share(path);
  fmt::print("{}: fine\n", printable(path));
  if (share)
    fmt::print(
        "of {} evaluations that accuracy studies judged, {} went through the kernels that are timed, the others "
        "through kernels for many curves at once\n",
        share->judged, share->own);
  if (const auto bundle = bundle::BundleDirectory::open(path); bundle.has(bundle::digests_name))
    fmt::print("{} digests by table, study and method, each that of its rows\n",
               bundle::parse_csv(bundle.read(bundle::digests_name), bundle::digests_name).row_count());
}

/// What a bundle must contain. Its build may have had other libraries than this one, so all known methods are allowed.
bundle::Expected expected_of(const std::string& suite_text, const std::string& file_name) {
  auto request = request_of_this_build();
  request.suites = suite::parse_suites(suite_text, file_name, vocabulary_of_all_builds());
  record_external(request, suite::parse_external(suite_text, file_name));
  return run::expected_of(request);
}

}  // namespace

void add_verify(Command program, Exit& exit) {
  auto path = std::make_shared<std::string>();
  auto command = program.command("verify", "check a bundle: checksums, schema, digest");
  command.option("BUNDLE", *path, "folder of the bundle").required();
  command.action([path, &exit] {
    const auto findings = bundle::verify(*path, expected_of);
    if (findings.empty()) print_fine(*path);
    exit = say_findings(findings);
  });
}

}  // namespace bezierbench::cli
