// SPDX-License-Identifier: MIT
// What a companion problem is asked besides its curves: the columns that tell its rows apart, empty for other problems.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

struct Asked {
  std::optional<int> order = std::nullopt;         ///< of a derivative
  std::optional<double> tolerance = std::nullopt;  ///< relative for lengths, a distance for fits
  std::optional<int> points = std::nullopt;        ///< number of data points
  std::string_view data = {};                      ///< id of a sample::DataKind
  friend bool operator==(const Asked&, const Asked&) = default;
};

/// Which of these a problem has.
struct Asks {
  bool degree = true;  ///< of curves; else the points are all that is given
  bool order = false;
  bool tolerance = false;
  bool points = false;
  bool data = false;  ///< every kind of data is a case of its own
};

/// order,tolerance,points,data
const std::vector<std::string>& asked_columns();

/// The fields of those columns.
std::vector<std::string> asked_fields(const Asked& asked);

/// The cross product of what the study asks, order outermost; one that asks nothing where `asks` has nothing. Throws
/// Failure(usage), which names `problem`, for a key that is missing or that the problem has not.
std::vector<Asked> asked_of(const suite::Study& study, const Asks& asks, std::string_view problem);

}  // namespace bezierbench::studies
