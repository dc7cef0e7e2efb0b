// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/diagnostics.hpp"

#include <cstddef>
#include <string_view>

#include "experiments/echo.hpp"
#include "experiments/run/notes.hpp"

namespace bezierbench::cli {

void say(const std::string& text) {
  constexpr std::size_t longest = 2000;  // in bytes; a file may have a field of megabytes
  const auto end = text.find_last_not_of(" \n") + 1;
  run::note(shortened(std::string_view(text).substr(0, end), longest), "bezierbench: ");
}

Exit say_findings(std::span<const std::string> findings) {
  for (const auto& finding : findings) say(finding);
  return findings.empty() ? Exit::fine : Exit::finding;
}

}  // namespace bezierbench::cli
