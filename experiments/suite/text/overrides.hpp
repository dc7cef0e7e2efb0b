// SPDX-License-Identifier: MIT
// What the command line changes about suites that were read from files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

struct Overrides {
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> trials;
  std::vector<std::string> set;        ///< "axis=v1,v2", intervals as 0:0.2
  std::optional<std::string> only;     ///< a glob over study ids; empty: all studies
  std::string only_option = "--only";  ///< the name of the option that set `only`, for messages
  bool no_timing = false;
  bool counts = false;  ///< timing studies count instructions, with no_timing only that
};

/// Applies `overrides`: drops the studies that `only` does not match, and with `no_timing` those of times that do not
/// count; then suites that are empty. Sets seed, trials and keys in every study that remains; a key that one of them
/// does not have is refused. The result passes the same checks as a suite file. Throws Failure(Exit::usage) with `--set
/// degree=x: what; what to do`; the suites are then unchanged.
void apply(const Overrides& overrides, std::vector<Suite>& suites, const Vocabulary& known);

}  // namespace bezierbench::suite
