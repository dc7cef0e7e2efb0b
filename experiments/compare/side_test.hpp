// SPDX-License-Identifier: MIT
// Sides made of text, for this folder's tests only.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::compare {

/// A side with these tables, as pairs of file name and text.
inline Side side_of(const std::string& name, const std::vector<std::pair<std::string, std::string>>& tables) {
  Side side{.name = name};
  side.manifest.seed = 1;
  for (const auto& [file, text] : tables) side.tables.emplace(file, bundle::parse_csv(text, name + "/" + file));
  return side;
}

/// What a row of times has beside its method and median.
struct TimingFields {
  double spread = 0.001;  ///< of the interval, to either side of the median
  std::string quality = "ok";
  std::string checked = "yes";
  std::string units = "";  ///< the time in units of the sentinel
};

inline std::string timing_row(const std::string& method, double ns, const TimingFields& fields = {}) {
  return fmt::format("s,{},{},{},{},{},{},{},{},{}\n", method, ns, ns / (1 + fields.spread), ns * (1 + fields.spread),
                     fields.quality, fields.checked, fields.units, fields.units, fields.units);
}

inline Side timed(const std::string& name, const std::string& rows) {
  return side_of(name, {{timing_file,
                         "study,method,median_ns,low_ns,high_ns,quality,checked,sentinel_units,sentinel_units_low,"
                         "sentinel_units_high\n" +
                             rows}});
}

/// The row of two sides with one time each.
inline Row only_row(const std::string& a, const std::string& b) {
  const auto side_a = timed("a", a);
  const auto side_b = timed("b", b);
  return compare_sides(side_a, side_b).times.at(0);
}

}  // namespace bezierbench::compare
