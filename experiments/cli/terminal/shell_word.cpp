// SPDX-License-Identifier: MIT
#include "experiments/cli/terminal/shell_word.hpp"

#include <errno.h>

namespace bezierbench::cli {

std::string shell_word(const std::string& text) {
  constexpr const char* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789%+,-./:=@_";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + '\'';
}

std::string this_program() { return shell_word(program_invocation_name); }

}  // namespace bezierbench::cli
