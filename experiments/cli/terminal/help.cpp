// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/help.hpp"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::size_t usual_width = 80;
constexpr std::size_t most_readable = 100;  // longer lines of text are hard to read
constexpr std::size_t indent = 24;          // of what an option means

using Lines = std::vector<std::pair<std::string, std::string>>;

std::string section(const std::string& title, const Lines& lines, std::size_t width) {
  if (lines.empty()) return "";
  std::string text = '\n' + styled(STDOUT_FILENO, fmt::emphasis::bold, title) + '\n';
  for (const auto& [head, meaning] : lines) {
    const auto shown = "  " + head;
    const bool fits = length_of(shown) + 2 <= indent;
    if (!fits) text += shown + '\n';
    text += wrapped(padded(fits ? shown : "", indent), meaning, indent, width);
  }
  return text;
}

std::string meaning(const OptionNode& option) {
  if (option.required) return option.help + " (needed)";
  return option.alternative < 0 ? option.help : option.help + " (this or another is needed)";
}

}  // namespace

std::string spelling(const OptionNode& option) {
  if (option.name.empty()) return option.value + (option.several ? "..." : "");
  return option.value.empty() ? option.name : option.name + ' ' + option.value;
}

std::string synopsis(const CommandNode& command) {
  std::string text = command.name;
  std::map<int, std::string> alternatives;
  bool has_more = false;
  for (const auto& option : command.options) {
    const auto one = spelling(option) + (option.several && !option.name.empty() ? " ..." : "");
    if (option.alternative >= 0) {
      auto& group = alternatives[option.alternative];
      group += (group.empty() ? "" : " | ") + one;
    } else if (option.required) {
      text += ' ' + one;
    } else if (option.name.empty()) {
      text += " [" + one + ']';
    } else {
      has_more = true;
    }
  }
  for (const auto& [number, group] : alternatives) text += " (" + group + ')';
  if (!command.commands.empty()) text += " COMMAND";
  return has_more ? text + " [OPTION...]" : text;
}

std::string help_text(const CommandNode& command) {
  const auto width = std::min(terminal_width(STDOUT_FILENO).value_or(usual_width), most_readable);
  std::string text = wrapped("", command.help, 0, width) + '\n';
  text += wrapped("usage: ", synopsis(command), 7, width);
  Lines arguments, options, commands;
  for (const auto& option : command.options)
    (option.name.empty() ? arguments : options).emplace_back(spelling(option), meaning(option));
  for (const auto& one : command.commands) commands.emplace_back(one.name.substr(command.name.size() + 1), one.help);
  text += section("arguments", arguments, width) + section("options", options, width) +
          section("commands", commands, width);
  return text + command.footer + (command.footer.empty() || command.footer.ends_with('\n') ? "" : "\n");
}

}  // namespace bezierbench::cli
