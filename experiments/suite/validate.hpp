// SPDX-License-Identifier: MIT
// What a study may say, whether it comes from a file or from the command line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "experiments/suite/fault.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

/// Whether `study` can be run: known ids, values in range, axes that fit one another and the
/// kind, nothing twice on an axis.
Finding validate(const Study& study, const Vocabulary& known);

/// Why `seed` is none, else empty: seeds are 0 to 2^63-1, what TOML can hold.
std::string seed_problem(std::uint64_t seed);

/// Why `id` cannot name a study or suite, else empty: ids are used in CSV fields, globs and file names.
std::string id_problem(std::string_view id);

/// Throws Failure(Exit::usage), naming the file that was read last, where two suites of a bundle have one id, or two
/// studies of all its suites.
void check_unique_ids(std::span<const Suite> suites, std::string_view last_file);

}  // namespace bezierbench::suite
