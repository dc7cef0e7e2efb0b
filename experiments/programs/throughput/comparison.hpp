// SPDX-License-Identifier: MIT
// Two costs of one run, with the goal for their ratio.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/race/race.hpp"

namespace bezierbench::throughput {

struct Comparison {
  std::string what;
  std::string than;
  double ns = 0;       ///< of `what`, per point, median
  double than_ns = 0;  ///< of `than`
  double ratio = 0;    ///< than / what, median over rounds
  double goal = 0;
  bool at_least = true;  ///< the goal is a lower limit of the ratio, else of its reciprocal an upper one

  [[nodiscard]] bool met() const { return at_least ? ratio >= goal : 1 / ratio <= goal; }
};

/// How the first lap compares with another.
Comparison compare(const race::Rival& what, const race::Lap& lap, const race::Rival& than, const race::Lap& other);

}  // namespace bezierbench::throughput
