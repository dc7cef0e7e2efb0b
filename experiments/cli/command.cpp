// SPDX-License-Identifier: MIT
#include "experiments/cli/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <utility>

#include "experiments/failure.hpp"
#include "experiments/suite/nearest.hpp"

namespace bezierbench::cli {
namespace {

/// What is wrong with the command line. The parser says only that a subcommand is missing where one is unknown.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const auto words = app.remaining(true);
  if (command->get_require_subcommand_min() == 0 || words.empty()) return error.what();
  std::vector<std::string> known;
  for (const auto* subcommand : command->get_subcommands({})) known.push_back(subcommand->get_name());
  return fmt::format("{}: unknown{}", words.front(), suite::suggestion(words.front(), known));
}

}  // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::once() {
  option_->expected(1);
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

Option Option::within(double least, double most) {
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
template Option Command::option(const std::string&, std::optional<double>&, const std::string&);

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(*app_->add_flag(name, value, help));
}

Command Command::alternatives(const std::string& name, const std::string& help) {
  auto* group = app_->add_option_group(name, help);
  group->require_option(1);
  return Command(*group);
}

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
  } catch (const CLI::Success& asked) {
    app_->exit(asked, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    throw Failure(Exit::usage, fmt::format("{}; see --help", complaint(*app_, error)));
  }
}

}  // namespace bezierbench::cli
