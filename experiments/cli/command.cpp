// SPDX-License-Identifier: MIT
#include "experiments/cli/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <type_traits>
#include <utility>

#include "experiments/cli/terminal/help.hpp"
#include "experiments/echo.hpp"
#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/nearest.hpp"

namespace bezierbench::cli {
namespace {

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

/// Option groups are commands without a name; hidden commands have no group.
bool is_group(const CLI::App* app) { return app->get_name().empty(); }
bool is_shown(const CLI::App* app) { return !is_group(app) && !app->get_group().empty(); }

std::vector<std::string> shown_commands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* subcommand : command.get_subcommands(is_shown)) names.push_back(subcommand->get_name());
  return names;
}

/// The name of a command with those of its parents.
std::string full_name(const CLI::App& command) {
  const auto* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + ' ' + command.get_name();
}

/// The options that `command` takes, with those of its groups and parents.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> known;
  const auto add = [&known](const CLI::App& app) {
    for (const auto* option : app.get_options())
      if (option->nonpositional()) known.push_back(option->get_name());
  };
  for (const auto* app = &command; app != nullptr; app = app->get_parent()) add(*app);
  for (const auto* group : command.get_subcommands(is_group)) add(*group);
  return known;
}

/// The message about the first word that the parser did not recognise, or about a command that is missing. Empty where
/// neither is the case. The parser itself reports only what is missing, not that a word is mistyped.
std::string misplaced_word(const CLI::App& app) {
  const auto words = app.remaining(true);
  const auto& command = chosen_command(app);
  const bool lacks_command = command.get_require_subcommand_min() > 0;
  if (lacks_command && !words.empty() &&
      !words.front().starts_with('-'))  // what follows belongs to the mistyped command
    return fmt::format("{}: unknown command{}", words.front(),
                       suite::suggestion(words.front(), shown_commands(command)));
  const auto option = std::ranges::find_if(words, [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) {
    const auto name = option->substr(0, option->find('='));
    return fmt::format("{}: unknown option{}", name, suite::suggestion(name, options_of(command)));
  }
  if (lacks_command)
    return fmt::format("{}: must be followed by a subcommand: {}", command.get_name(),
                       fmt::join(shown_commands(command), ", "));
  return words.empty() ? "" : fmt::format("{}: is one argument too many", words.front());
}

OptionNode node_of(const CLI::Option& option, const ValueNotes& notes, int alternative) {
  OptionNode node;
  if (option.nonpositional()) node.name = option.get_name();
  const bool is_flag = option.get_expected_max() == 0;
  if (const auto note = notes.find(&option); note != notes.end()) {
    node.value = note->second.name;
    node.values = note->second.values;
  } else if (!is_flag) {
    for (const char c : option.get_name().substr(option.nonpositional() ? 2 : 0))  // --degree takes a DEGREE
      node.value += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  node.help = option.get_description();
  node.required = option.get_required();
  const auto& left_out = option.get_default_str();
  const bool says_it = node.help.find("default") != std::string::npos;
  if (!node.required && !says_it && !left_out.empty()) node.help += "; default " + left_out;
  node.several = !is_flag && option.get_items_expected_max() > 1;
  node.alternative = alternative;
  return node;
}

void add_options(const CLI::App& app, const ValueNotes& notes, int alternative, std::vector<OptionNode>& options) {
  const bool is_command = alternative < 0;  // a group has the help option of its command once more
  for (const auto* option : app.get_options())
    if (is_command || option != app.get_help_ptr()) options.push_back(node_of(*option, notes, alternative));
}

CommandNode tree_of(const CLI::App& app, const ValueNotes& notes) {
  CommandNode node{full_name(app), app.get_description(), app.get_footer(), {}, {}};
  add_options(app, notes, -1, node.options);
  int alternative = 0;
  for (const auto* group : app.get_subcommands(is_group)) add_options(*group, notes, alternative++, node.options);
  if (app.get_fallthrough())
    for (const auto* option : app.get_parent()->get_options())
      if (option != app.get_parent()->get_help_ptr()) node.options.push_back(node_of(*option, notes, -1));
  for (const auto* command : app.get_subcommands(is_shown)) node.commands.push_back(tree_of(*command, notes));
  return node;
}

/// What the chosen command needs and did not get: "choose needs BUNDLE, --degree DEGREE". Empty where it has all.
std::string missing_words(const CLI::App& command, const ValueNotes& notes) {
  std::vector<std::string> missing;
  for (const auto* option : command.get_options())
    if (option->get_required() && option->count() == 0) missing.push_back(spelling(node_of(*option, notes, -1)));
  return missing.empty() ? "" : fmt::format("{} needs {}", command.get_name(), fmt::join(missing, ", "));
}

[[noreturn]] void refuse(const CLI::App& app, const std::string& what) {
  throw Failure(Exit::usage, fmt::format("{}; see {} --help", what, full_name(chosen_command(app))));
}

/// Help is given for commands that exist, not for a mistyped one.
void refuse_mistyped(const CLI::App& app) {
  if (app.remaining(true).empty()) return;
  if (const auto what = misplaced_word(app); !what.empty()) refuse(app, what);
}

}  // namespace

Option Option::takes(const std::string& name, KnownValues values) {
  (*notes_)[option_] = {name, std::move(values)};
  return *this;
}

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
  option_->check([words](const std::string& word) {
    if (std::ranges::find(words, word) != words.end()) return std::string();
    return fmt::format("{} must be one of {}{}", echo(word), fmt::join(words, ", "),
                       suite::nearest(word, words).empty() ? "" : suite::suggestion(word, words));
  });
  return takes(fmt::format("{}", fmt::join(words, "|")), [words] { return words; });
}

Option Option::within(int least, int most) {
  option_->check([least, most](const std::string& word) {
    const auto number = number::parse_integer(word);
    return number && *number >= least && *number <= most
               ? std::string()
               : fmt::format("{} must be from {} to {}", echo(word), least, most);
  });
  return takes("N");
}

Command Command::command(const std::string& name, const std::string& help) {
  return {*app_->add_subcommand(name, help), *notes_};
}

void Command::hidden_command(const std::string& name, std::function<void(const std::vector<std::string>&)> action) {
  auto* command = app_->add_subcommand(name)->group("")->prefix_command();
  command->set_help_flag();  // --help is one of its words
  command->callback([command, run = std::move(action)] { run(command->remaining()); });
}

template <class Value>
Option Command::option(const std::string& name, Value& value, const std::string& help) {
  auto* option = app_->add_option(name, value, help);
  if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::string>) option->capture_default_str();
  if constexpr (std::is_same_v<Value, int>)
    option->check([](const std::string& word) {
      return number::parse_integer(word) ? std::string() : fmt::format("{} must be a whole number", echo(word));
    });
  return {*option, *notes_};
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return {*app_->add_flag(name, value, help), *notes_};
}

Command Command::alternatives(const std::string& name, const std::string& help) {
  auto* group = app_->add_option_group(name, help);
  group->require_option(1);
  return {*group, *notes_};
}

void Command::footer(const std::string& text) { app_->footer(text); }
void Command::needs_command() { app_->require_subcommand(1); }
void Command::takes_options_of_its_parent() { app_->fallthrough(); }
void Command::action(std::function<void()> what) { app_->callback(std::move(what)); }

Program::Program(const std::string& name, const std::string& help, const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)) {
  app_->set_help_flag("--help,-h", "say what the command does and takes");
  app_->set_version_flag("--version", version, "say version, compiler and commit");
}

Program::~Program() = default;

CommandNode Program::tree() const { return tree_of(*app_, notes_); }

void Program::run(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    refuse_mistyped(*app_);
    fmt::print("{}", help_text(tree_of(chosen_command(*app_), notes_)));
  } catch (const CLI::CallForVersion& version) {
    refuse_mistyped(*app_);
    fmt::print("{}\n", version.what());
  } catch (const CLI::RequiredError& error) {
    auto what = misplaced_word(*app_);
    if (what.empty()) what = missing_words(chosen_command(*app_), notes_);
    refuse(*app_, what.empty() ? error.what() : what);
  } catch (const CLI::ParseError& error) {
    const auto what = misplaced_word(*app_);
    refuse(*app_, what.empty() ? error.what() : what);
  }
}

}  // namespace bezierbench::cli
