// SPDX-License-Identifier: MIT
// The command line as the subcommands see it. CLI11 is behind it, in command.cpp alone: its one header takes 4 s to
// compile, wherever it is included.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace bezierbench::cli {

/// An option or argument that a command has; what is asked of its value.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  Option once();  ///< of several values
  Option one_of(const std::vector<std::string>& words);
  Option within(int least, int most = std::numeric_limits<int>::max());

 private:
  CLI::Option* option_;
};

/// A command, to which options and commands can be added. The program owns it.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command command(const std::string& name, const std::string& help);

  /// Its value is written to `value` before the action; what was there is the default. A name without -- is that of an
  /// argument, which is told by its place. Numbers but small whole ones are read as text, for experiments/number to
  /// parse: the parser's own reading takes nan for a number and 1e-999 for 0.
  template <class Value>
  Option option(const std::string& name, Value& value, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);

  /// What is added to the result are options of this command, exactly one of which must be there.
  Command alternatives(const std::string& name, const std::string& help);

  /// Text below the options in the help of this command.
  void footer(const std::string& text);
  void needs_command();
  void takes_options_of_its_parent();
  void action(std::function<void()> what);  ///< when the command is chosen

 private:
  CLI::App* app_;
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

  [[nodiscard]] Command command() { return Command(*app_); }

  /// Does what the chosen command is for, or prints help or version to std::cout. Throws Failure(Exit::usage) for a
  /// command line that makes no sense, and whatever the action throws.
  void run(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace bezierbench::cli
