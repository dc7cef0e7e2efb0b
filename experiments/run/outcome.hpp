// SPDX-License-Identifier: MIT
// What a run has to say at its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bezierbench::run {

/// The findings of a run, lines for the user; any of them makes the exit code 1.
using Findings = std::vector<std::string>;

/// What this process did.
enum class Ending { complete, partial, nothing_to_do };

struct Outcome {
  Findings findings;
  Ending ending = Ending::nothing_to_do;
  std::size_t cells = 0;              ///< of the whole bundle
  std::uint64_t violations = 0;       ///< trials beyond a proved bound
  std::uint64_t broken_promises = 0;  ///< trials in which a method said what does not hold
  std::uint64_t refuted_proofs = 0;   ///< properties that are stated as proved and do not hold
  std::size_t times = 0;              ///< rows of timing.csv
  std::size_t noisy = 0;              ///< those of them that are noisy
  double seconds = 0;                 ///< since the first block
};

}  // namespace bezierbench::run
