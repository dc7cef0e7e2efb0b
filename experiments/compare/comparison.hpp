// SPDX-License-Identifier: MIT
// Bundles compared with a first one: machines and builds, accuracy, times, and the rank of each bundle.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/compare/accuracy.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/compare/timing.hpp"

namespace bezierbench::compare {

/// One bundle compared with the first.
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

/// Ranks the methods of each race among the timings that all bundles have in common, so that the ranks of all pairs are
/// ranks among the same methods. A bundle that has no timing in common with the first is not counted.
void rank_in_all(std::vector<Pair>& pairs);

/// The place of one bundle among all of them, over the timings that all bundles have in common. A bundle that has no
/// timing in common with the first is not counted.
struct Standing {
  std::optional<std::ptrdiff_t> rank;  ///< by mean_ratio; empty without a mean
  std::string bundle;
  std::string cpu;
  std::string compiler;
  bool same_machine = true;                                      ///< whether its machine is that of the first bundle
  std::size_t differing = 0;                                     ///< accuracy rows that differ from the first bundle's
  std::size_t timings = 0;                                       ///< the number of common timings; 0 means no mean
  double mean_ratio = std::numeric_limits<double>::quiet_NaN();  ///< geometric mean of times over the first bundle's
  double mean_normalised = std::numeric_limits<double>::quiet_NaN();  ///< the same in units of the sentinel
};

/// The standing of every bundle, the fastest first and those without times last. `pairs` holds the comparison of `base`
/// with each of `others`, in their order. The means are geometric: only then does the order not depend on the bundle
/// that the times are divided by (Fleming and Wallace 1986, Communications of the ACM 29:218).
[[nodiscard]] std::vector<Standing> standings(const Side& base, const std::vector<Side>& others,
                                              const std::vector<Pair>& pairs);

/// Every row of every pair: kind,study,method,scalar,dimension,degree,mode,a,b,ratio,ratio_low,ratio_high,verdict, then
/// the further inputs of the row and the columns that explain the verdict. Where `kind` is `accuracy`, `verdict` is
/// `identical` or `different`, and `a` and `b` are the values in `column` of `file`.
[[nodiscard]] bundle::CsvTable comparison_table(const std::vector<Pair>& pairs);

/// against,bundle,fact,a,b: every fact in which a bundle differs from the first.
[[nodiscard]] bundle::CsvTable facts_table(const std::vector<Pair>& pairs);

[[nodiscard]] bundle::CsvTable standings_table(const std::vector<Standing>& standings);

}  // namespace bezierbench::compare
