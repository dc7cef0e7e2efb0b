// SPDX-License-Identifier: MIT
// `choose --problem`: the methods of a companion problem, such as arc length or flattening, ranked by a bundle.
#pragma once

#include <string>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

struct CompanionWish {
  std::string bundle;
  std::string problem;    ///< a kind of study whose methods are timed
  std::string degree;     ///< of the curves
  std::string tolerance;  ///< one that the bundle has; empty where the problem has none
  std::string form;
  std::string scalar;
  std::string dimension;
  std::string study;           ///< of the times; empty for any
  std::string accuracy_study;  ///< of the errors and faults; empty for all
  std::string format;
};

/// The problems that can be asked for: the kinds of studies whose table declares faults.
std::vector<std::string> companion_problems();

/// Prints the methods that were timed and judged, those without a fault first, each part the fastest first. Returns `finding`
/// where every method has a fault. Throws Failure(usage) where the bundle has no such rows, with the available values.
Exit choose_companion(const CompanionWish& wish);

}  // namespace bezierbench::cli
