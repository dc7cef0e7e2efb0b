// SPDX-License-Identifier: MIT
// The errors of one method in a bundle, in a few numbers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace bezierbench::cli {

/// Over all rows against the exact value.
struct JudgedCells {
  std::size_t cells = 0;
  double trials = 0;
  double violations = 0;             ///< trials whose error is beyond the bound
  double non_finite = 0;             ///< trials whose result is
  std::optional<double> worst;       ///< the largest error; empty where no row has one
  bool in_u = false;                 ///< whether `worst` is in units of u p~, else in coordinate units
  std::string where;                 ///< the row with that error
  std::optional<double> bound_used;  ///< the largest share of its bound that an error is; empty without a bound
};

/// Throws Failure(Exit::input_output) for a bundle that cannot be read.
JudgedCells judged_cells(const std::filesystem::path& bundle, const std::string& method);

}  // namespace bezierbench::cli
