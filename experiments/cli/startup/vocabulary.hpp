// SPDX-License-Identifier: MIT
// The ids that suites may use, from the rosters; the suite reader takes them.
#pragma once

#include <string>

#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::cli {

/// Ids of all methods, conversions, generators and published files.
suite::Vocabulary vocabulary();

/// The same with the methods that only other builds have. Shipped suites may name them.
suite::Vocabulary vocabulary_of_all_builds();

/// The table of `list methods --format csv`, which every bundle contains.
std::string methods_csv();

/// The table of `list generators --format csv`, likewise.
std::string generators_csv();

/// Version, commit and compiler in one line.
std::string version_line();

}  // namespace bezierbench::cli
