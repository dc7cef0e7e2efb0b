// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "experiments/bundle/bundle.hpp"
#include "experiments/cli/commands.hpp"
#include "experiments/cli/diagnostics.hpp"
#include "experiments/echo.hpp"

namespace bezierbench::cli {

void add_verify(Command program, Exit& exit) {
  auto path = std::make_shared<std::string>();
  auto command = program.command("verify", "check a bundle: checksums, schema, digest");
  command.option("bundle", *path, "folder of the bundle").required();
  command.action([path, &exit] {
    const auto findings = bundle::verify(*path);
    for (const auto& finding : findings) say(finding);
    if (findings.empty()) fmt::print("{}: fine\n", printable(*path));
    exit = findings.empty() ? Exit::fine : Exit::finding;
  });
}

}  // namespace bezierbench::cli
