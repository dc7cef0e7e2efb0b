// SPDX-License-Identifier: MIT
// Suite files: TOML to values, with messages that name file, line and column; and resolved suites as TOML: what was
// run, with nothing left to defaults.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

/// Reads every suite of a TOML document: one in a file that people write (`[suite]`, `[[study]]`), several in the
/// resolved file of a bundle (`[[suites]]`, `[[suites.study]]`; see to_toml()). A key that is left out has the default
/// of suite.hpp; a rational study without `generator` gets the first one that draws weights. Numbers may also be
/// strings in decimal or hexadecimal floating point. A key that the kind of the study does not have is refused at its
/// place. Throws Failure(Exit::usage) with the one line `FILE:LINE:COLUMN: what; what to do`.
std::vector<Suite> parse_suites(std::string_view text, std::string_view file_name, const Vocabulary& known);

/// Reads a file as parse_suites does. Throws Failure(Exit::usage) also where the file cannot be read.
std::vector<Suite> read_suites(const std::filesystem::path& file, const Vocabulary& known);

/// What a document with one suite states for those who choose a suite. It does not describe what a run does, so a Suite
/// has no such members, and a resolved suite no such keys.
struct Declared {
  std::string question;                 ///< that it answers; empty where it is left out
  std::optional<std::int64_t> seconds;  ///< of processor time for all its studies, as its author measured it
};

/// The text must be one that parse_suites reads.
Declared declared(std::string_view text);

/// Suites as TOML that parse_suites reads back to equal values, every key explicit, in a fixed order, doubles in
/// shortest decimal. Empty values are left out (methods: all that apply; title, modes, published: none). One suite is
/// written as people write it, with [suite] and [[study]], so that `run BUNDLE/suite.toml` repeats it; several are
/// written as [[suites]], each with its [[suites.study]].
std::string to_toml(std::span<const Suite> suites);

}  // namespace bezierbench::suite
