// SPDX-License-Identifier: MIT
// Descriptions of the kinds of studies and their keys, for people and editors, from what the kinds declare.
#pragma once

#include <string>

#include "experiments/suite/kind.hpp"

namespace bezierbench::cli {

/// The keys that every kind has, then those of each kind, in lines of at most 80 characters.
std::string kinds_text();

/// All keys of one kind, with an example. Throws Failure(Exit::usage) for an id of no kind.
std::string kind_text(const std::string& id);

/// A [[study]] with the keys that the kind needs, as TOML.
std::string example_study(const suite::Kind& kind);

/// A JSON Schema of suite files, draft 7, the one that editors support.
std::string suite_schema();

}  // namespace bezierbench::cli
