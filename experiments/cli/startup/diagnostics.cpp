// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/diagnostics.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "experiments/run/notes.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

void say(const std::string& text) {
  constexpr std::size_t longest_word = 400;  // in bytes; an option or a field of a file may have megabytes
  constexpr std::size_t longest_line = 1000;
  std::string_view rest = std::string_view(text).substr(0, text.find_last_not_of(" \n") + 1);
  std::string line;
  while (!rest.empty()) {
    const auto word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    line += shortened(word, longest_word) + (rest.empty() ? "" : " ");
  }
  run::note(shortened(line, longest_line), "bezierbench: ");
}

Exit say_findings(std::span<const std::string> findings) {
  for (const auto& finding : findings) say(finding);
  return findings.empty() ? Exit::fine : Exit::finding;
}

}  // namespace bezierbench::cli
