// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::compare {
namespace {

std::set<Inputs> timed_methods(const TimingComparison& timing) {
  std::set<Inputs> methods;
  for (const auto& row : timing.rows)
    if (!row.is_sentinel()) methods.insert(row.inputs);
  return methods;
}

/// The timings that every bundle has.
std::set<Inputs> common_timings(const std::vector<Pair>& pairs) {
  std::set<Inputs> common = timed_methods(pairs.front().timing);
  for (const auto& pair : pairs) {
    const auto here = timed_methods(pair.timing);
    std::erase_if(common, [&](const Inputs& inputs) { return !here.contains(inputs); });
  }
  return common;
}

class GeometricMean {
 public:
  void add(double ratio) {
    sum_ += std::log(ratio);
    ++count_;
  }
  [[nodiscard]] double value() const { return count_ == 0 ? 1 : std::exp(sum_ / count_); }

 private:
  double sum_ = 0;
  double count_ = 0;
};

Standing standing(const Side& side, std::size_t timings) {
  return {.bundle = side.name,
          .cpu = side.fact("cpu.model_name"),
          .compiler = side.fact("build.compiler"),
          .timings = timings};
}

Standing standing(const Side& side, const Pair& pair, const std::set<Inputs>& common) {
  GeometricMean raw;
  GeometricMean normalised;
  for (const auto& row : pair.timing.rows) {
    if (!common.contains(row.inputs)) continue;
    raw.add(row.raw.ratio.median);
    normalised.add(row.normalised ? row.normalised->ratio.median : std::numeric_limits<double>::quiet_NaN());
  }
  Standing one = standing(side, common.size());
  one.same_machine = pair.same_machine;
  one.differing = pair.accuracy.differing;
  one.mean_ratio = raw.value();
  one.mean_normalised = normalised.value();
  return one;
}

}  // namespace

std::vector<Standing> standings(const Side& base, const std::vector<Side>& others, const std::vector<Pair>& pairs) {
  const auto common = common_timings(pairs);
  std::vector<Standing> all{standing(base, common.size())};
  for (std::size_t k = 0; k < others.size(); ++k) all.push_back(standing(others[k], pairs[k], common));
  std::ranges::stable_sort(all, {}, &Standing::mean_ratio);
  for (auto& one : all)
    one.rank = 1 + static_cast<int>(std::ranges::count_if(
                       all, [&](const Standing& rival) { return rival.mean_ratio < one.mean_ratio; }));
  return all;
}

}  // namespace bezierbench::compare
