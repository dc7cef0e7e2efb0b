// SPDX-License-Identifier: MIT
// What the exit codes mean, for people; docs/terminal.md has the same table, as a test says.
#pragma once

#include <array>
#include <string_view>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

struct ExitMeaning {
  Exit code;
  std::string_view meaning;
};

inline constexpr std::array<ExitMeaning, 7> exit_meanings{{
    {Exit::fine, "fine"},
    {Exit::finding, "a finding: a gate failed, bytes differ, a bound was violated"},
    {Exit::usage, "usage or configuration"},
    {Exit::environment, "this machine or build is unfit"},
    {Exit::input_output, "input or output failed: no space, no permission, an unreadable or malformed file"},
    {Exit::stopped_early, "stopped early; the same command goes on"},
    {Exit::interrupted, "interrupted; the same command goes on"},
}};

}  // namespace bezierbench::cli
