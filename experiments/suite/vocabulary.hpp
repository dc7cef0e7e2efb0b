// SPDX-License-Identifier: MIT
// The ids that a suite may name. The caller passes them in, so that this folder requires no roster.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/suite/generator_limits.hpp"

namespace bezierbench::suite {

struct Kind;

struct KnownGenerator {
  std::string id;
  GeneratorLimits limits;
};

/// A method that only some builds have.
struct AbsentMethod {
  std::string id;
  std::string remedy;  ///< how to get it
};

struct Vocabulary {
  std::span<const Kind* const> kinds;
  std::vector<std::string> methods;      ///< evaluators, paths and the methods of companion problems
  std::vector<std::string> conversions;  ///< parts of conversion chains such as `factorial+positive_sum`
  std::vector<KnownGenerator> generators;
  std::vector<std::string> published_files;  ///< names in reference/published
  std::vector<AbsentMethod> absent_methods;
};

}  // namespace bezierbench::suite
