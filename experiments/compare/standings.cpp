// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "experiments/compare/comparison.hpp"

namespace bezierbench::compare {
namespace {

/// The timings that all bundles have in common; a bundle that has none in common with the first is not counted.
std::set<Inputs> common_timings(const std::vector<Pair>& pairs) {
  std::optional<std::set<Inputs>> common;
  for (const auto& pair : pairs) {
    const auto here = timed_methods(pair.timing);
    if (here.empty()) continue;
    if (!common) common = here;
    std::erase_if(*common, [&](const Inputs& inputs) { return !here.contains(inputs); });
  }
  return common.value_or(std::set<Inputs>{});
}

class GeometricMean {
 public:
  void add(double ratio) {
    sum_ += std::log(ratio);
    ++count_;
  }
  [[nodiscard]] double value() const { return std::exp(sum_ / count_); }

 private:
  double sum_ = 0;
  double count_ = 0;
};

Standing standing(const Side& side) {
  Standing standing;
  standing.bundle = side.name;
  standing.cpu = side.fact("cpu.model_name");
  standing.compiler = side.fact("build.compiler");
  return standing;
}

/// The standing of the first bundle. Its mean is 1, since its times are divided by themselves.
Standing first_standing(const Side& side, const std::set<Inputs>& common) {
  Standing one = standing(side);
  one.timings = common.size();
  if (one.timings > 0) one.mean_ratio = one.mean_normalised = 1;
  return one;
}

Standing standing(const Side& side, const Pair& pair, const std::set<Inputs>& common) {
  Standing one = standing(side);
  GeometricMean raw;
  GeometricMean normalised;
  for (const auto& row : pair.timing.rows) {
    if (!common.contains(row.inputs)) continue;
    ++one.timings;
    raw.add(row.raw.ratio.median);
    normalised.add(row.normalised ? row.normalised->ratio.median : std::numeric_limits<double>::quiet_NaN());
  }
  one.same_machine = pair.same_machine;
  one.differing = pair.accuracy.differing;
  if (one.timings > 0) {
    one.mean_ratio = raw.value();
    one.mean_normalised = normalised.value();
  }
  return one;
}

/// The mean ratio, or infinity without one, so that bundles without a mean come last.
double mean_ratio_or_last(const Standing& one) {
  return one.timings > 0 ? one.mean_ratio : std::numeric_limits<double>::infinity();
}

}  // namespace

void rank_in_all(std::vector<Pair>& pairs) {
  const auto common = common_timings(pairs);
  for (auto& pair : pairs) rank(pair.timing, common);
}

std::vector<Standing> standings(const Side& base, const std::vector<Side>& others, const std::vector<Pair>& pairs) {
  const auto common = common_timings(pairs);
  std::vector<Standing> all{first_standing(base, common)};
  for (std::size_t k = 0; k < others.size(); ++k) all.push_back(standing(others[k], pairs[k], common));
  std::ranges::stable_sort(all, {}, mean_ratio_or_last);
  for (auto& one : all)
    if (one.timings > 0)
      one.rank = 1 + static_cast<int>(std::ranges::count_if(all, [&](const Standing& rival) {
                   return mean_ratio_or_last(rival) < mean_ratio_or_last(one);
                 }));
  return all;
}

}  // namespace bezierbench::compare
