// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/kernel_share.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/diagnostics.hpp"

namespace bezierbench::cli {
namespace {

void print_fine(const std::string& path) {
  const auto share = bundle::kernel_share(path);
  fmt::print("{}: fine\n", path);
  if (share)
    fmt::print(
        "of {} evaluations that accuracy studies judged, {} went through the kernels that are timed, the others "
        "through kernels for many curves at once\n",
        share->judged, share->own);
}

}  // namespace

void add_verify(Command program, Exit& exit) {
  auto path = std::make_shared<std::string>();
  auto command = program.command("verify", "check a bundle: checksums, schema, digest");
  command.option("bundle", *path, "folder of the bundle").required();
  command.action([path, &exit] {
    const auto findings = bundle::verify(*path);
    for (const auto& finding : findings) say(finding);
    if (findings.empty()) print_fine(*path);
    exit = findings.empty() ? Exit::fine : Exit::finding;
  });
}

}  // namespace bezierbench::cli
