// SPDX-License-Identifier: MIT
// The keys of the kinds of studies, for people and for editors, from what the kinds say of themselves.
#pragma once

#include <string>

#include "experiments/suite/kinds.hpp"

namespace bezierbench::cli {

/// The keys that every kind has, then those of each kind, in lines of at most 80 characters.
std::string kinds_text();

/// All keys of one kind, with an example. Throws Failure(Exit::usage) for an id that is none.
std::string kind_text(const std::string& id);

/// A [[study]] with the keys that the kind needs, as TOML.
std::string example_study(const suite::Kind& kind);

/// A JSON Schema of suite files, draft 7, which editors know.
std::string suite_schema();

}  // namespace bezierbench::cli
