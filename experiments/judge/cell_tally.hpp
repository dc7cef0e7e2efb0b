// SPDX-License-Identifier: MIT
// The results of blocks of trials of one cell of an accuracy study. The order in which they are merged changes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "experiments/judge/judgement.hpp"
#include "experiments/metric/tally.hpp"

namespace bezierbench::judge {

/// The errors of one replicate, per judgement, until all of its blocks are merged.
struct OpenReplicate {
  std::vector<metric::Tally> errors;
  std::int64_t blocks = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.errors, self.blocks);
  }
};

/// The statistics of one replicate, per judgement. NaN where no trial was finite.
struct ReplicateStatistic {
  double mean = 0;
  double max = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.mean, self.max);
  }
};

struct CellTally {
  std::int64_t blocks_per_replicate = 1;
  std::vector<Judgement> judgements;
  metric::Tally audit;          ///< of the long double tier: the largest error of an axis, in ulp of that axis
  metric::Tally condition;      ///< p~ over |p|
  std::uint64_t escalated = 0;  ///< trials that needed big integers, because no certificate decided them
  std::map<std::int64_t, OpenReplicate> open;
  std::map<std::int64_t, std::vector<ReplicateStatistic>> closed;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.blocks_per_replicate, self.judgements, self.audit, self.condition, self.escalated, self.open,
          self.closed);
  }

  /// Adds the judgements of one block of this replicate.
  void end_block(std::int64_t replicate) {
    OpenReplicate block;
    for (const Judgement& judgement : judgements) block.errors.push_back(judgement.error);
    block.blocks = 1;
    add(replicate, block);
  }

  void merge(const CellTally& other) {
    if (other.judgements.size() != judgements.size()) throw std::invalid_argument("tallies of different cells");
    for (std::size_t k = 0; k < judgements.size(); ++k) judgements[k].merge(other.judgements[k]);
    audit.merge(other.audit);
    condition.merge(other.condition);
    escalated += other.escalated;
    for (const auto& [replicate, part] : other.open) add(replicate, part);
    closed.insert(other.closed.begin(), other.closed.end());
  }

 private:
  void add(std::int64_t replicate, const OpenReplicate& part) {
    auto [entry, fresh] = open.try_emplace(replicate, part);
    OpenReplicate& sum = entry->second;
    if (!fresh) {
      for (std::size_t k = 0; k < part.errors.size(); ++k) sum.errors.at(k).merge(part.errors[k]);
      sum.blocks += part.blocks;
    }
    if (sum.blocks < blocks_per_replicate) return;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    auto& statistics = closed[replicate];
    for (const metric::Tally& errors : sum.errors)
      statistics.push_back(errors.count() == 0 ? ReplicateStatistic{none, none}
                                               : ReplicateStatistic{errors.mean(), errors.max()});
    open.erase(entry);
  }
};

}  // namespace bezierbench::judge
