// SPDX-License-Identifier: MIT
// How progress and the end of a run are told: to people in a line, to programs as JSON, one object per line.
// docs/terminal.md describes the objects.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/progress.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// A time for people: "48 s", "3 min 20 s", "2 h 05 min".
std::string duration(double seconds);

/// " 43 %, about 48 s left, 2.3.1-bezier (4 of 11 studies done)", without an end of line.
std::string progress_line(const ProgressView& view);
std::string progress_json(const ProgressView& view);

/// "complete in 48 s: 154 cells, no bound violated, 3 of 120 times noisy (2.5 %)"; without cells where `outcome` has
/// none to tell of.
std::string ending_line(const Outcome& outcome);
/// `next` are commands that can follow.
std::string ending_json(const Outcome& outcome, const std::string& out, const std::vector<std::string>& next);

/// What is to be done before the first block.
std::string beginning_json(std::size_t studies, std::size_t cells, std::uint64_t blocks, std::uint64_t blocks_done);

std::string message_json(std::string_view text);

}  // namespace bezierbench::run
