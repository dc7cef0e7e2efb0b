// SPDX-License-Identifier: MIT
// The table that `inputs` writes and `judge` reads.
#pragma once

#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// The suites of a table of inputs, with one replicate of each study and `method` as its only method. Throws
/// Failure(input_output) for another table.
std::vector<suite::Suite> suites_of(const bundle::CsvDocument& table, const std::string& method);

/// A line for each study of which the table has inputs that the study does not draw.
std::vector<std::string> foreign_inputs(const bundle::CsvDocument& table, const std::vector<suite::Suite>& suites);

}  // namespace bezierbench::cli
