// SPDX-License-Identifier: MIT
// The commands of the program with their options, as data. Help, man pages and completions are made from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bezierbench::cli {

/// The values that an option can take, where they can be listed. Called only when somebody asks for them.
using KnownValues = std::function<std::vector<std::string>()>;

/// Names of values that the shells complete by themselves.
inline constexpr const char* file_value = "FILE";
inline constexpr const char* folder_value = "FOLDER";
inline constexpr const char* bundle_value = "BUNDLE";    ///< the folder of one
inline constexpr const char* suite_value = "SUITE";      ///< an id or a file
inline constexpr const char* command_value = "COMMAND";  ///< a program, with arguments
inline constexpr const char* against_value = "PROGRAM|COMMIT|BUNDLE";

struct OptionNode {
  std::string name;   ///< with its dashes; empty for a positional argument
  std::string value;  ///< what its value is called; empty for a flag
  std::string help;
  bool required = false;
  bool several = false;  ///< takes several values, or may be repeated
  int alternative = -1;  ///< number of the group of options of which exactly one is given; -1: in none
  KnownValues values;
};

struct CommandNode {
  std::string name;  ///< with those of its parents: "bezierbench curve eval"
  std::string help;
  std::string footer;  ///< preformatted text
  std::vector<OptionNode> options;
  std::vector<CommandNode> commands;  ///< without those that people do not type
};

}  // namespace bezierbench::cli
