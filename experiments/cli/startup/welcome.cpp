// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/welcome.hpp"

#include <unistd.h>

#include <array>
#include <string_view>

#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/terminal.hpp"

namespace bezierbench::cli {
namespace {

struct Deed {
  std::string_view command;
  std::string_view meaning;
};

constexpr std::array<Deed, 5> deeds{{
    {"bezierbench list suites", "what can be run, and its cost"},
    {"bezierbench run report --out b", "repeat the source report"},
    {"bezierbench choose b --degree 4 --tolerance 10", "the best methods of it"},
    {"bezierbench curve eval --curve c.csv --t 0.5", "one curve and its true errors"},
    {"bezierbench --help", "all commands"},
}};

}  // namespace

std::string welcome() {
  constexpr std::size_t indent = 48;  // of what they mean
  constexpr std::size_t narrow = 80;  // in less, that is below them
  const bool below = output_width() < narrow;
  std::string text;
  for (const auto& [command, meaning] : deeds)
    text += styled(STDOUT_FILENO, fmt::emphasis::bold, command) +
            (below ? "\n    " : std::string(indent - command.size(), ' ')) + std::string(meaning) + '\n';
  return text;
}

}  // namespace bezierbench::cli
