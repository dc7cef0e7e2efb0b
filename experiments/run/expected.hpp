// SPDX-License-Identifier: MIT
// The contents that `verify` expects in a bundle of some suites.
#pragma once

#include <vector>

#include "experiments/bundle/check/verify.hpp"
#include "experiments/run/kinds.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::run {

/// The contents that `verify` expects in a bundle of these suites. For a study with methods that this build lacks it
/// expects no table, because this build does not know which rows they write.
[[nodiscard]] bundle::Expected expected_of(const std::vector<suite::Suite>& suites, const Kinds& kinds);

}  // namespace bezierbench::run
