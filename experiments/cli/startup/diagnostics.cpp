// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/diagnostics.hpp"

#include <cstddef>
#include <string_view>

#include "experiments/run/notes.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

void say(const std::string& text) {
  constexpr std::size_t longest = 1000;  // in bytes; an option may have megabytes
  run::note(shortened(std::string_view(text).substr(0, text.find_last_not_of(" \n") + 1), longest), "bezierbench: ");
}

Exit say_findings(std::span<const std::string> findings) {
  for (const auto& finding : findings) say(finding);
  return findings.empty() ? Exit::fine : Exit::finding;
}

}  // namespace bezierbench::cli
