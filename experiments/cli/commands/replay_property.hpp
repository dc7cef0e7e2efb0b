// SPDX-License-Identifier: MIT
// `replay` of a row of guarantees.csv.
#pragma once

#include <string>

#include "experiments/cli/commands/worst_record.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

/// Asks the method for the points of the recorded input again, prints them and by how much they break the property.
/// `fine` where the input breaks it, as recorded, or where none was found, is as far from that as recorded; else
/// `finding`. Throws Failure(usage) for a row without an input, Failure(input_output) for a field that is malformed.
Exit replay_property(const std::string& id, const WorstRecord& record, const sample::Cell& cell);

}  // namespace bezierbench::cli
