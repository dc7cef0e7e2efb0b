// SPDX-License-Identifier: MIT
#include "experiments/run/notes.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdio>

#include "experiments/run/progress.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::run {
namespace {

std::atomic<bool> as_json{false};

}  // namespace

void write_notes_as_json() { as_json = true; }

void note_event(const std::string& json) { std::fputs((json + '\n').c_str(), stderr); }

void note(const std::string& line, std::string_view head) {
  if (as_json) return note_event(message_json(std::string(head) + line));
  const auto shown = head.empty() ? std::string() : styled(STDERR_FILENO, fmt::fg(fmt::terminal_color::red), head);
  std::fputs((shown + printable(line) + '\n').c_str(), stderr);
}

}  // namespace bezierbench::run
