// SPDX-License-Identifier: MIT
// Bundles held against a first one: machines and builds, accuracy, times, and how all of them rank.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/compare/accuracy.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/compare/timing.hpp"

namespace bezierbench::compare {

/// One bundle against the first.
struct Pair {
  std::string against;  ///< name of a
  std::string bundle;   ///< name of b
  std::vector<FactDifference> facts;
  bool same_machine;
  AccuracyComparison accuracy;
  TimingComparison timing;

  [[nodiscard]] bool has_common_rows() const { return !accuracy.rows.empty() || !timing.rows.empty(); }
};

[[nodiscard]] Pair compare_pair(const Side& a, const Side& b);

/// Ranks the methods of each race among those that every bundle has which has any in common with the first: ranks of
/// several pairs are then ranks among the same methods.
void rank_in_all(std::vector<Pair>& pairs);

/// One bundle among all of them, over the timings that all have which have any in common with the first.
struct Standing {
  std::optional<int> rank;  ///< by mean_ratio; none without it
  std::string bundle;
  std::string cpu;
  std::string compiler;
  bool same_machine = true;                                      ///< as the first bundle's
  std::size_t differing = 0;                                     ///< accuracy rows that are not the first bundle's
  std::size_t timings = 0;                                       ///< that count; without any there is no mean
  double mean_ratio = std::numeric_limits<double>::quiet_NaN();  ///< geometric mean of times over the first bundle's
  double mean_normalised = std::numeric_limits<double>::quiet_NaN();  ///< in units of the sentinel; NaN without one
};

/// The fastest first, those without times last. `pairs` are of `base` and every other side, in order. Geometric means,
/// for ratios rank the same whichever bundle they are taken against only so (Fleming and Wallace 1986, Communications
/// of the ACM 29:218).
[[nodiscard]] std::vector<Standing> standings(const Side& base, const std::vector<Side>& others,
                                              const std::vector<Pair>& pairs);

/// Every row of every pair: kind,study,method,scalar,dimension,degree,mode,a,b,ratio,ratio_low,ratio_high,verdict, then
/// what tells rows apart and how the verdict came about. `verdict` is `identical` or `different` where kind is
/// `accuracy`; a and b are then the values in `column` of `file`.
[[nodiscard]] bundle::CsvTable comparison_table(const std::vector<Pair>& pairs);

/// against,bundle,fact,a,b: every fact in which a bundle differs from the first.
[[nodiscard]] bundle::CsvTable facts_table(const std::vector<Pair>& pairs);

/// The standings as a table.
[[nodiscard]] bundle::CsvTable standings_table(const std::vector<Standing>& standings);

}  // namespace bezierbench::compare
