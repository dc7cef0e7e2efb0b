// SPDX-License-Identifier: MIT
// What a machine.json says against timing on that machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// The aspect of a Concern about the clock.
inline constexpr std::string_view clock_aspect = "clock";

/// One thing to know before times are believed.
struct Concern {
  std::string aspect;  ///< clock, governor, boost, load, virtualised, counters
  std::string text;    ///< what is the matter and what to do
  bool warning;        ///< false: all is well, and `text` says with what
};

/// Every aspect once, in a fixed order. What could not be read is a warning: unknown is not fine. Throws
/// Failure(Exit::input_output) where the text is not that of a machine.json.
[[nodiscard]] std::vector<Concern> timing_fitness(std::string_view machine_json);

}  // namespace bezierbench::bundle
