// SPDX-License-Identifier: MIT
// What a bundle of some suites has, for whoever verifies one.
#pragma once

#include <vector>

#include "experiments/bundle/check/verify.hpp"
#include "experiments/run/kinds.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::run {

/// What `verify` is to find in a bundle of these suites. A study with methods that this build does not have asks for no
/// table: which rows it gives is known where they are.
[[nodiscard]] bundle::Expected expected_of(const std::vector<suite::Suite>& suites, const Kinds& kinds);

}  // namespace bezierbench::run
