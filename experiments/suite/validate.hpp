// SPDX-License-Identifier: MIT
// Checks of a study, whether it comes from a file or from the command line.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "experiments/suite/fault.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

/// The first fault of `study`; empty where it can be run: its ids are known, its values are in range, its axes fit one
/// another and the kind, and no axis has a value twice.
Finding validate(const Study& study, const Vocabulary& known);

/// Why `seed` is not a valid seed, else empty. Seeds are 0 to 2^63-1, which TOML can hold.
std::string seed_problem(std::uint64_t seed);

/// Why `id` cannot be the id of a study or suite, else empty. Ids are used in CSV fields, globs and file names.
std::string id_problem(std::string_view id);

/// Throws Failure(Exit::usage), naming the file that was read last, where two suites of a bundle, or two studies of all
/// its suites, have the same id.
void check_unique_ids(std::span<const Suite> suites, std::string_view last_file);

}  // namespace bezierbench::suite
