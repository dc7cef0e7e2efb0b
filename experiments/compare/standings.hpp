// SPDX-License-Identifier: MIT
// The ranks of methods in each bundle, and the place of each bundle among several.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/compare/comparison.hpp"

namespace bezierbench::compare {

/// Ranks the methods of each race among the timings that all bundles have in common, and finds those that changed their
/// place; all other rows and sentinels keep rank 0. A method is certainly faster than another where its interval ends
/// before the other's begins. A bundle that has no timing in common with the first is not counted.
void rank(std::vector<Comparison>& comparisons);

/// The place of one bundle, over the timings that all bundles have in common.
struct Standing {
  std::optional<std::ptrdiff_t> rank = {};  ///< by mean_ratio; empty without a mean
  const Side* side;
  bool same_machine = true;                                      ///< whether its machine is that of the first bundle
  std::size_t differing = 0;                                     ///< results that differ from the first bundle's
  std::size_t timings = 0;                                       ///< the number of common timings; 0 means no mean
  double mean_ratio = std::numeric_limits<double>::quiet_NaN();  ///< geometric mean of times over the first bundle's
  double mean_normalised = std::numeric_limits<double>::quiet_NaN();  ///< the same in units of the sentinel
};

/// The standing of every bundle, the fastest first and those without times last. The means are geometric: only then
/// does the order not depend on the bundle that the times are divided by (Fleming and Wallace 1986, Communications of
/// the ACM 29:218).
[[nodiscard]] std::vector<Standing> standings(const std::vector<Comparison>& comparisons);

[[nodiscard]] bundle::CsvTable standings_table(const std::vector<Standing>& standings);

}  // namespace bezierbench::compare
