// SPDX-License-Identifier: MIT
#include "experiments/cli/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <utility>

#include "experiments/failure.hpp"
#include "experiments/suite/nearest.hpp"

namespace bezierbench::cli {
namespace {

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

/// The options that `command` takes, with those of its groups and parents.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> known;
  const auto add = [&known](const CLI::App& app) {
    for (const auto* option : app.get_options())
      if (option->nonpositional()) known.push_back(option->get_name());
  };
  for (const auto* app = &command; app != nullptr; app = app->get_parent()) add(*app);
  for (const auto* group : command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); }))
    add(*group);
  return known;
}

/// The message about the first word that the parser did not recognise. Empty where it recognised all words, or where
/// the word is one argument too many. The parser itself reports only what is missing, not that a word is mistyped.
std::string misplaced_word(const CLI::App& app) {
  const auto words = app.remaining(true);
  const auto& command = chosen_command(app);
  const auto option = std::ranges::find_if(words, [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) {
    const auto name = option->substr(0, option->find('='));
    return fmt::format("{}: unknown option{}", name, suite::suggestion(name, options_of(command)));
  }
  if (command.get_require_subcommand_min() == 0 || words.empty()) return "";
  std::vector<std::string> known;
  for (const auto* subcommand : command.get_subcommands({})) known.push_back(subcommand->get_name());
  return fmt::format("{}: unknown{}", words.front(), suite::suggestion(words.front(), known));
}

[[noreturn]] void refuse(const std::string& what) { throw Failure(Exit::usage, what + "; see --help"); }

}  // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::once() {
  option_->expected(1);
  return *this;
}

Option Option::one_each_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

Option Option::within(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Command Command::command(const std::string& name, const std::string& help) {
  return Command(*app_->add_subcommand(name, help));
}

template <class Value>
Option Command::option(const std::string& name, Value& value, const std::string& help) {
  return Option(*app_->add_option(name, value, help));
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(*app_->add_flag(name, value, help));
}

Command Command::alternatives(const std::string& name, const std::string& help) {
  auto* group = app_->add_option_group(name, help);
  group->require_option(1);
  return Command(*group);
}

void Command::footer(const std::string& text) { app_->footer(text); }
void Command::needs_command() { app_->require_subcommand(1); }
void Command::takes_options_of_its_parent() { app_->fallthrough(); }
void Command::action(std::function<void()> what) { app_->callback(std::move(what)); }

Program::Program(const std::string& name, const std::string& help, const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)) {
  app_->set_version_flag("--version", version);
}

Program::~Program() = default;

void Program::run(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {  // the user asked for help or version
    if (const auto what = misplaced_word(*app_); !what.empty()) refuse(what);
    app_->exit(asked, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    const auto what = misplaced_word(*app_);
    refuse(what.empty() ? error.what() : what);
  }
}

}  // namespace bezierbench::cli
