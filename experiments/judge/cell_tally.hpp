// SPDX-License-Identifier: MIT
// The results of blocks of trials of one cell of an accuracy study. The order in which they are merged changes nothing.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "experiments/judge/error_sources.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/metric/tally.hpp"

namespace bezierbench::judge {

/// The trial with a method's largest error in units of u p~; of equal ones the first.
struct Worst {
  double error_u = 0;
  double error = 0;
  std::uint64_t trial = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error_u, self.error, self.trial);
  }

  void merge(const Worst& other) {
    if (other.error_u > error_u || (other.error_u == error_u && other.trial < trial)) *this = other;
  }
};

/// The errors of one method, measured from one baseline.
struct Judgement {
  metric::Tally error;
  metric::Tally error_u;
  metric::Tally error_ulp;  ///< against the exact reference only, like all below
  metric::Tally relative;
  metric::Tally error_size;  ///< over the size of the curve, of trials whose curve has one
  std::optional<Worst> worst;
  std::uint64_t coordinates = 0;  ///< of trials whose error is finite
  std::uint64_t misrounded = 0;   ///< those of them that are not the nearest number
  SourceTallies sources;
  std::uint64_t non_finite = 0;
  std::uint64_t own_kernel = 0;  ///< trials whose point was computed by the method's own kernel, the one that is timed
  std::uint64_t bounded = 0;     ///< trials for which a bound is proved
  metric::TrialCount violations;
  metric::Largest<double> bound;    ///< in coordinate units
  metric::Largest<double> bound_u;  ///< bound / (u p~)

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.error_ulp, self.relative, self.error_size, self.worst, self.coordinates,
                 self.misrounded, self.sources, self.non_finite, self.own_kernel, self.bounded, self.violations,
                 self.bound, self.bound_u);
  }
};

/// The errors of one replicate, per judgement, until all of its blocks are merged.
struct OpenReplicate {
  std::vector<metric::Tally> errors;
  std::uint64_t blocks = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.errors, self.blocks);
  }
};

/// The statistics of one replicate for one judgement. NaN where no trial was finite.
struct ReplicateStatistic {
  double mean = 0;
  double max = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.mean, self.max);
  }
};

/// The statistics of each replicate, per judgement. The tallies of a replicate are dropped with its last block.
struct Replicates {
  std::uint64_t blocks_of_each = 1;
  std::map<std::int64_t, OpenReplicate> open;
  std::map<std::int64_t, std::vector<ReplicateStatistic>> closed;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.blocks_of_each, self.open, self.closed);
  }

  void merge(const Replicates& other) {
    metric::merge_fields(open, other.open);
    closed.insert(other.closed.begin(), other.closed.end());
    close();
  }

  /// Replaces the tallies of replicates whose blocks are all merged by their statistics.
  void close() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (auto& [replicate, sum] : open) {
      if (sum.blocks < blocks_of_each) continue;
      for (const metric::Tally& errors : sum.errors)
        closed[replicate].push_back(errors.count() == 0 ? ReplicateStatistic{none, none}
                                                        : ReplicateStatistic{errors.mean(), errors.max()});
    }
    std::erase_if(open, [this](const auto& entry) { return entry.second.blocks >= blocks_of_each; });
  }
};

struct CellTally {
  std::vector<Judgement> judgements;
  metric::Tally audit;          ///< of the long double tier: the largest error of an axis, in ulp of that axis
  metric::Tally condition;      ///< p~ over |p|
  std::uint64_t escalated = 0;  ///< trials decided by big integers, because no certificate decided them
  Replicates replicates;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.judgements, self.audit, self.condition, self.escalated, self.replicates);
  }

  /// Records that the judgements so far are those of one block of this replicate.
  void end_block(std::int64_t replicate) {
    auto& block = replicates.open[replicate];
    for (const Judgement& judgement : judgements) block.errors.push_back(judgement.error);
    block.blocks = 1;
    replicates.close();
  }

  void merge(const CellTally& other) { metric::merge_each_field(*this, other); }
};

}  // namespace bezierbench::judge
