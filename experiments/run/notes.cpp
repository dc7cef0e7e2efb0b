// SPDX-License-Identifier: MIT
#include "experiments/run/notes.hpp"

#include <unistd.h>

#include <cstdio>

#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::run {
void note(const std::string& line, std::string_view head) {
  const auto shown = head.empty() ? std::string() : styled(STDERR_FILENO, fmt::fg(fmt::terminal_color::red), head);
  std::fputs((shown + printable(line) + '\n').c_str(), stderr);
}

}  // namespace bezierbench::run
