// SPDX-License-Identifier: MIT
// The interface of the subcommands to the command line. Only command.cpp includes CLI11, whose header takes 4 s to
// compile. Help and completions come from CLI11's tree of commands.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bezierbench::cli {

/// The values that an option can take, where they can be listed, for completions. Called only when a shell asks.
using KnownValues = std::function<std::vector<std::string>()>;
using ValuesOfOptions = std::map<const CLI::Option*, KnownValues>;

/// Names of values in help.
inline constexpr const char* file_value = "FILE";
inline constexpr const char* folder_value = "FOLDER";
inline constexpr const char* bundle_value = "BUNDLE";    ///< the folder of one
inline constexpr const char* suite_value = "SUITE";      ///< an id or a file
inline constexpr const char* command_value = "COMMAND";  ///< a program, with arguments
inline constexpr const char* against_value = "PROGRAM|COMMIT|BUNDLE";

/// An option or argument of a command, with the checks of its value.
class Option {
 public:
  Option(CLI::Option& option, ValuesOfOptions& values) : option_(&option), values_(&values) {}

  /// Names the value, for help (`--out FOLDER`), and lists the values, for completions. A positional argument is named
  /// by Command::option.
  Option takes(const std::string& name, KnownValues values = {});
  Option required();
  Option once();           ///< one value only, of an option that could take several
  Option one_each_time();  ///< one value each time that it is given, as often as one likes
  Option one_of(const std::vector<std::string>& words);
  Option within(int least, int most = std::numeric_limits<int>::max());

 private:
  CLI::Option* option_;
  ValuesOfOptions* values_;
};

/// A command, to which options and commands can be added. The program owns it.
class Command {
 public:
  Command(CLI::App& app, ValuesOfOptions& values) : app_(&app), values_(&values) {}

  Command command(const std::string& name, const std::string& help);

  /// Adds an option. Its value is written to `value` before the action runs; the value before that is the default. A
  /// name without -- is that of a positional argument, as help prints it. All numbers except small integers are read as
  /// text, for reference/number to parse, because the parser would accept nan, and 1e-999 as 0.
  template <class Value>
  Option option(const std::string& name, Value& value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  /// A group of options of this command, exactly one of which must be given.
  Command alternatives(const std::string& name, const std::string& help);

  /// Text below the options in the help of this command.
  void footer(const std::string& text);
  void needs_command();
  void action(std::function<void()> what);  ///< runs when the command is chosen

 private:
  CLI::App* app_;
  ValuesOfOptions* values_;
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

  [[nodiscard]] Command command() { return {*app_, values_}; }

  /// What can stand in place of the last of `words`, which may be empty; the words before it are complete, and the name
  /// of the program is not among them. Each entry is `WORD` or `WORD<tab>MEANING`. Where there is none, shells offer
  /// files.
  [[nodiscard]] std::vector<std::string> completions(std::span<const std::string> words) const;

  /// Runs the action of the chosen command, or prints help or version to standard output. `complete WORDS...`, which
  /// the functions of the shells call, prints completions(). Throws Failure(Exit::usage) for a wrong command line, and
  /// whatever the action throws.
  void run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
  ValuesOfOptions values_;
};

}  // namespace bezierbench::cli
