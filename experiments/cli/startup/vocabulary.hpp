// SPDX-License-Identifier: MIT
// What the program knows by name, gathered from the rosters; the suite reader is handed it.
#pragma once

#include <string>

#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::cli {

/// Ids of all methods, conversions, generators and published files.
suite::Vocabulary vocabulary();

/// The same with the methods that other builds have, too: what a shipped suite may say.
suite::Vocabulary vocabulary_of_all_builds();

/// The table of `list methods --format csv`, which also travels in every bundle.
std::string methods_csv();

/// The table of `list generators --format csv`, likewise.
std::string generators_csv();

/// Version, commit and compiler in one line.
std::string version_line();

}  // namespace bezierbench::cli
