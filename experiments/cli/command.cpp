// SPDX-License-Identifier: MIT
#include "experiments/cli/command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "experiments/cli/terminal/text.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/ids.hpp"
#include "experiments/terminal.hpp"
#include "reference/number/echo.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

/// Option groups are commands without a name.
bool is_group(const CLI::App* app) { return app->get_name().empty(); }
bool is_command(const CLI::App* app) { return !is_group(app); }

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* subcommand : command.get_subcommands(is_command)) names.push_back(subcommand->get_name());
  return names;
}

/// The name of a command with those of its parents.
std::string full_name(const CLI::App& command) {
  const auto* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + ' ' + command.get_name();
}

/// The options that `command` takes, with those of its groups, which have the help option of their command once more.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  auto all = command.get_options();
  for (const auto* group : command.get_subcommands(is_group))
    for (const auto* option : group->get_options())
      if (option != command.get_help_ptr()) all.push_back(option);
  return {all.begin(), all.end()};
}

/// The message about the first word that the parser did not recognise, or about a command that is missing. Empty where
/// neither is the case. The parser itself reports only what is missing, not that a word is mistyped.
std::string misplaced_word(const CLI::App& app) {
  const auto words = app.remaining(true);
  const auto& command = chosen_command(app);
  const bool lacks_command = command.get_require_subcommand_min() > 0;
  if (lacks_command && !words.empty() &&
      !words.front().starts_with('-'))  // what follows belongs to the mistyped command
    return fmt::format("{}: unknown command{}", words.front(), suite::suggestion(words.front(), commands_of(command)));
  const auto option = std::ranges::find_if(words, [](const auto& word) { return word.starts_with('-'); });
  if (option != words.end()) {
    const auto name = option->substr(0, option->find('='));
    std::vector<std::string> known;
    for (const auto* one : options_of(command))
      if (one->nonpositional()) known.push_back(one->get_name());
    if (std::ranges::find(known, name) != known.end())  // of the command, but written before it
      return fmt::format("{}: stands before its command; write it after `{}`", name, full_name(command));
    return fmt::format("{}: unknown option{}", name, suite::suggestion(name, known));
  }
  if (lacks_command)
    return fmt::format("{}: must be followed by a subcommand: {}", command.get_name(),
                       fmt::join(commands_of(command), ", "));
  return words.empty() ? "" : fmt::format("{}: is one argument too many", words.front());
}

/// CLI11's help, with descriptions broken at the width of the terminal.
class Help : public CLI::Formatter {
 public:
  Help() {
    constexpr std::size_t indent = 24;  // of descriptions
    column_width(indent);
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
  }

 protected:
  std::string make_option_opts(const CLI::Option* option) const override {
    const auto name = option->get_positional() ? "" : ' ' + option->get_type_name();
    const bool several = option->get_type_size() > 0 && option->get_items_expected_max() > 1;
    return (name == " " ? "" : name) + (several ? "..." : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    auto text = option->get_description();
    const bool has_default = !option->get_required() && !option->get_default_str().empty();
    if (has_default && text.find("default") == std::string::npos) text += "; default " + option->get_default_str();
    return in_column(text + (option->get_required() ? " (required)" : ""));
  }

  std::string make_subcommand(const CLI::App* command) const override {
    std::ostringstream text;
    CLI::detail::format_help(text, command->get_name(), in_column(command->get_description()), get_column_width());
    return text.str();
  }

 private:
  [[nodiscard]] std::string in_column(const std::string& text) const {
    const auto taken = get_column_width() + 2;  // CLI11 indents the options of a group by 2
    const auto width = reading_width();
    return fmt::format("{}", fmt::join(lines_of(text, width - std::min(width, taken)), "\n"));
  }
};

/// The whole help, with those lines broken that Help leaves as they are, such as the description.
std::string help_of(const CLI::App& app) {
  std::istringstream lines(app.help());
  std::string text;
  for (std::string line; std::getline(lines, line);)
    text += length_of(line) <= reading_width() ? line + '\n'
                                               : wrapped("", line, line.starts_with(' ') ? 6 : 0, reading_width());
  return text;
}

[[noreturn]] void refuse(const CLI::App& app, const std::string& what) {
  throw Failure(Exit::usage, "{}; see `{} --help`", what, full_name(chosen_command(app)));
}

/// Help is given for commands that exist, not for a mistyped one.
void refuse_mistyped(const CLI::App& app) {
  if (app.remaining(true).empty()) return;
  if (const auto what = misplaced_word(app); !what.empty()) refuse(app, what);
}

}  // namespace

Option Option::takes(const std::string& name, KnownValues values) {
  if (option_->nonpositional()) option_->type_name(name);
  if (values) (*values_)[option_] = std::move(values);
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
  constexpr std::size_t longest = 30;  // of words that name the value in help
  auto name = fmt::format("{}", fmt::join(words, "|"));
  if (name.size() > longest) {
    option_->description(fmt::format("{}: {}", option_->get_description(), fmt::join(words, ", ")));
    name = option_->get_type_name();
  }
  return takes(name, [words] { return words; });
}

Option Option::within(int least, int most) {
  const auto otherwise = number::parse_integer(option_->get_default_str());
  if (otherwise && (*otherwise < least || *otherwise > most)) option_->default_str("");  // stands for "not given"
  option_->check([least, most](const std::string& word) {
    const auto number = number::parse_integer(word);
    return number && *number >= least && *number <= most
               ? std::string()
               : fmt::format("{} must be from {} to {}", echo(word), least, most);
  });
  return takes("N");
}

Command Command::command(const std::string& name, const std::string& help) {
  return {*app_->add_subcommand(name, help), *values_};
}

template <class Value>
Option Command::option(const std::string& name, Value& value, const std::string& help) {
  auto* option = app_->add_option(name, value, help);
  std::string type;
  for (const char c : name.substr(option->nonpositional() ? 2 : 0))  // --degree takes a DEGREE
    type += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  option->type_name(type);
  if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::string>) option->capture_default_str();
  if constexpr (std::is_same_v<Value, int>)
    option->check([](const std::string& word) {
      return number::parse_integer(word) ? std::string() : fmt::format("{} must be a whole number", echo(word));
    });
  return {*option, *values_};
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return {*app_->add_flag(name, value, help), *values_};
}

Command Command::alternatives(const std::string& name, const std::string& help) {
  auto* group = app_->add_option_group(name, help);
  group->require_option(1);
  return {*group, *values_};
}

void Command::footer(const std::string& text) { app_->footer(text); }
void Command::needs_command() { app_->require_subcommand(1); }
void Command::action(std::function<void()> what) { app_->callback(std::move(what)); }

Program::Program(const std::string& name, const std::string& help, const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)) {
  app_->formatter(std::make_shared<Help>());
  app_->set_help_flag("--help,-h", "print this help and exit");
  app_->set_version_flag("--version", version, "print version, compiler and commit, and exit");
}

Program::~Program() = default;

std::vector<std::string> Program::completions(std::span<const std::string> words) const {
  std::vector<std::string> lines;
  if (words.empty()) return lines;
  const auto& begun = words.back();
  const auto add = [&](const std::string& word, const std::string& meaning) {
    if (word.starts_with(begun)) lines.push_back(meaning.empty() ? word : word + '\t' + meaning);
  };
  const auto add_values = [&](const CLI::Option* option, const std::string& before) {
    if (const auto known = values_.find(option); known != values_.end())
      for (const auto& value : known->second()) add(before + value, "");
  };
  const CLI::App* command = app_.get();
  const CLI::Option* open = nullptr;  // the option whose value comes next
  for (const auto& word : words.first(words.size() - 1)) {
    const auto* option = open == nullptr && word.starts_with('-') ? command->get_option_no_throw(word) : nullptr;
    const auto next =
        command->get_subcommands([&](const CLI::App* one) { return is_command(one) && one->get_name() == word; });
    if (open == nullptr && !next.empty()) command = next.front();
    open = option != nullptr && option->get_type_size() > 0 ? option : nullptr;
  }
  const auto equals = begun.find('=');
  if (open != nullptr) {
    add_values(open, "");
  } else if (begun.starts_with("--") && equals != std::string::npos) {
    add_values(command->get_option_no_throw(begun.substr(0, equals)), begun.substr(0, equals + 1));
  } else if (begun.starts_with('-')) {
    for (const auto* option : options_of(*command))
      if (option->nonpositional()) add(option->get_name(), option->get_description());
  } else {
    for (const auto* one : command->get_subcommands(is_command)) add(one->get_name(), one->get_description());
    for (const auto* option : command->get_options())
      if (option->get_positional()) add_values(option, "");
  }
  return lines;
}

void Program::run(int argc, const char* const* argv) {
  if (argc > 1 && argv[1] == std::string_view("complete")) {
    const std::vector<std::string> words(argv + 2, argv + argc);
    for (const auto& line : completions(words)) fmt::print("{}\n", line);
    return;
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    refuse_mistyped(*app_);
    fmt::print("{}", help_of(*app_));
  } catch (const CLI::CallForVersion& version) {
    refuse_mistyped(*app_);
    fmt::print("{}\n", version.what());
  } catch (const CLI::ParseError& error) {
    const auto what = misplaced_word(*app_);
    refuse(*app_, what.empty() ? error.what() : what);
  }
}

}  // namespace bezierbench::cli
