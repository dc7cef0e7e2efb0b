// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

#include "build_facts.hpp"
#include "experiments/bundle/atomic_file.hpp"
#include "experiments/cli/terminal/exit_codes.hpp"
#include "experiments/cli/terminal/help.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {
namespace {

/// `text` with what roff would act on escaped.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-' || c == '\'' || c == '`' || c == '^' || c == '~')
      out += std::string("\\") + (c == '-' ? "-" : c == '\'' ? "(aq" : c == '`' ? "(ga" : c == '^' ? "(ha" : "(ti");
    else
      out += c;
  }
  return out;
}

/// A line of text: a dot at its beginning would be a request.
std::string text_line(std::string_view text) { return (text.starts_with('.') ? "\\&" : "") + escaped(text) + '\n'; }

std::string page_name(const CommandNode& command) {
  auto name = command.name;
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string term(const std::string& bold, const std::string& meaning) {
  return ".TP\n.B \"" + escaped(bold) + "\"\n" + text_line(meaning);
}

std::string terms(const std::string& title, const std::string& entries) {
  return entries.empty() ? "" : ".SH " + title + '\n' + entries;
}

std::string options_of(const CommandNode& command, bool positional) {
  std::string text;
  for (const auto& option : command.options)
    if (option.name.empty() == positional)
      text += term(spelling(option), option.help + (option.required ? " (needed)" : ""));
  return text;
}

std::string commands_of(const CommandNode& command) {
  std::string text;
  for (const auto& one : command.commands) text += term(one.name, one.help);
  return text;
}

/// Preformatted text, line by line.
std::string preformatted(std::string_view text) {
  std::string out = ".nf\n";
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    out += line.empty() ? ".sp\n" : text_line(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return out + ".fi\n";
}

std::string exit_status() {
  std::string text;
  for (const auto& [code, meaning] : exit_meanings)
    text += term(std::to_string(static_cast<int>(code)), std::string(meaning));
  return text;
}

constexpr std::string_view environment =
    ".SH ENVIRONMENT\n"
    ".TP\n.B COLUMNS\nThe width of help and tables for people, where it is not that of the terminal.\n"
    ".TP\n.B NO_COLOR\nNo colours, where it is not empty.\n";

std::string see_also(const CommandNode& program, const CommandNode& command) {
  std::string text = ".SH SEE ALSO\n";
  if (&program != &command) text += ".BR " + escaped(page_name(program)) + " (1)\n";
  for (const auto& one : command.commands) text += ".BR " + escaped(page_name(one)) + " (1)\n";
  return text;
}

void write_pages(const CommandNode& program, const CommandNode& command, const std::filesystem::path& folder) {
  bundle::write_file(folder / (page_name(command) + ".1"), manual_page(program, command));
  for (const auto& one : command.commands) write_pages(program, one, folder);
}

}  // namespace

std::string manual_page(const CommandNode& program, const CommandNode& command) {
  auto title = page_name(command);
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string page =
      fmt::format(".TH \"{}\" 1 \"\" \"{} {}\" \"User Commands\"\n", escaped(title), program.name, program_version);
  page += ".SH NAME\n" + escaped(page_name(command)) + " \\- " + text_line(command.help);
  page += ".SH SYNOPSIS\n.B \"" + escaped(synopsis(command)) + "\"\n";
  page += terms("ARGUMENTS", options_of(command, true)) + terms("OPTIONS", options_of(command, false)) +
          terms("COMMANDS", commands_of(command));
  if (!command.footer.empty()) page += ".SH DESCRIPTION\n" + preformatted(command.footer);
  return page + terms("EXIT STATUS", exit_status()) + std::string(environment) + see_also(program, command);
}

void write_manual(const CommandNode& program, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Failure(Exit::input_output,
                  fmt::format("{}: cannot be created: {}; choose another folder", folder.string(), error.message()));
  write_pages(program, program, folder);
}

}  // namespace bezierbench::cli
