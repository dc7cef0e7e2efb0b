// SPDX-License-Identifier: MIT
// A table as people read it.
#pragma once

#include <string>

#include "experiments/bundle/csv.hpp"

namespace bezierbench::cli {

/// The table in aligned columns, one line per row, the header first.
std::string aligned(const bundle::CsvDocument& table);

}  // namespace bezierbench::cli
