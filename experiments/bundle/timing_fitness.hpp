// SPDX-License-Identifier: MIT
// Reasons in a machine.json why times taken on that machine may not be reliable.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bezierbench::bundle {

/// One aspect of a machine to know before times are relied on.
struct Concern {
  std::string aspect;  ///< clock, governor, boost, load, virtualised, counters
  std::string text;    ///< what is wrong and what to do about it
  bool warning;        ///< false: nothing is wrong, and `text` is the value found
};

/// One concern for each aspect, in a fixed order. A value that could not be read gives a warning. Throws
/// Failure(Exit::input_output) where the text is not that of a machine.json.
[[nodiscard]] std::vector<Concern> timing_fitness(std::string_view machine_json);

}  // namespace bezierbench::bundle
