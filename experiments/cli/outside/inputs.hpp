// SPDX-License-Identifier: MIT
// The table that `inputs` writes and `judge` reads.
#pragma once

#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// The suites that a table of inputs is of, with one replicate of each study and `method` as its only method. Throws
/// Failure(input_output) for another table.
std::vector<suite::Suite> suites_of(const bundle::CsvDocument& table, const std::string& method);

/// A line for each study of the suites with rows of the table whose inputs are not those that the study draws.
std::vector<std::string> foreign_inputs(const bundle::CsvDocument& table, const std::vector<suite::Suite>& suites);

}  // namespace bezierbench::cli
