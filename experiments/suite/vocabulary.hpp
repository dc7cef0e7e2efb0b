// SPDX-License-Identifier: MIT
// The ids that a suite may name. Handed in by the caller, so that suites never see a roster.
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/generator_limits.hpp"

namespace bezierbench::suite {

struct KnownGenerator {
  std::string id;
  GeneratorLimits limits;
};

/// A method that some builds have.
struct AbsentMethod {
  std::string id;
  std::string remedy;  ///< what to do to have it
};

struct Vocabulary {
  std::vector<std::string> methods;      ///< evaluators, paths and the methods of the other kinds of study
  std::vector<std::string> conversions;  ///< parts of conversion chains such as `factorial+positive_sum`
  std::vector<KnownGenerator> generators;
  std::vector<std::string> published_files;  ///< names in reference/published
  std::vector<AbsentMethod> absent_methods;
};

}  // namespace bezierbench::suite
