// SPDX-License-Identifier: MIT
// The interface of the subcommands to the command line. Only command.cpp includes CLI11, whose header takes 4 s to
// compile.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cli/terminal/command_tree.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bezierbench::cli {

/// What help and completions say of the value of an option, beside what the parser knows.
struct ValueNote {
  std::string name;
  KnownValues values;
};
using ValueNotes = std::map<const CLI::Option*, ValueNote>;

/// An option or argument of a command, with the checks of its value.
class Option {
 public:
  Option(CLI::Option& option, ValueNotes& notes) : option_(&option), notes_(&notes) {}

  /// Names the value, for help (`--out FOLDER`), and says which values there are, for completions.
  Option takes(const std::string& name, KnownValues values = {});
  Option required();
  Option once();           ///< one value only, of an option that could take several
  Option one_each_time();  ///< one value each time that it is given, as often as one likes
  Option one_of(const std::vector<std::string>& words);
  Option within(int least, int most = std::numeric_limits<int>::max());

 private:
  CLI::Option* option_;
  ValueNotes* notes_;
};

/// A command, to which options and commands can be added. The program owns it.
class Command {
 public:
  Command(CLI::App& app, ValueNotes& notes) : app_(&app), notes_(&notes) {}

  Command command(const std::string& name, const std::string& help);

  /// Adds a command for other programs, which no help shows. `action` gets all words that follow its name.
  void hidden_command(const std::string& name, std::function<void(const std::vector<std::string>&)> action);

  /// Adds an option. Its value is written to `value` before the action runs; the value before that is the default. A
  /// name without -- is that of a positional argument. All numbers except small integers are read as text, for
  /// experiments/number to parse, because the parser would accept nan, and 1e-999 as 0.
  template <class Value>
  Option option(const std::string& name, Value& value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  /// A group of options of this command, exactly one of which must be given.
  Command alternatives(const std::string& name, const std::string& help);

  /// Text below the options in the help of this command.
  void footer(const std::string& text);
  void needs_command();
  void takes_options_of_its_parent();
  void action(std::function<void()> what);  ///< runs when the command is chosen

 private:
  CLI::App* app_;
  ValueNotes* notes_;
};

extern template Option Command::option(const std::string&, std::string&, const std::string&);
extern template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&);
extern template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);
extern template Option Command::option(const std::string&, int&, const std::string&);

/// The whole command line.
class Program {
 public:
  Program(const std::string& name, const std::string& help, const std::string& version);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] Command command() { return {*app_, notes_}; }
  [[nodiscard]] CommandNode tree() const;

  /// Runs the action of the chosen command, or prints help or version to standard output. Throws Failure(Exit::usage)
  /// for a wrong command line, and whatever the action throws.
  void run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
  ValueNotes notes_;
};

}  // namespace bezierbench::cli
