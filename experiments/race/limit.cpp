// SPDX-License-Identifier: MIT
#include "experiments/race/limit.hpp"

#include <algorithm>
#include <limits>

namespace bezierbench::race {
namespace {

/// The narrowest vectors that hold `numbers`, or the widest.
const OperationTimes& narrowest(const ProcessorTimes& times, std::size_t numbers) {
  const auto found = std::ranges::find_if(times, [&](const auto& one) { return one.lanes >= numbers; });
  return found == times.end() ? times.back() : *found;
}

std::optional<Limit> limit_of_batch(const TimedWork& work, const ProcessorTimes& times) {
  const auto count = point_operations(*work.evaluator, work.degree, work.dimension, Layout::points);
  if (!count) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& width : times) least = std::min(least, least_ns(*count, width) / static_cast<double>(width.lanes));
  return Limit{least, std::nullopt};
}

}  // namespace

double least_ns(const ByOperation& count, const OperationTimes& times) {
  using enum Operation;
  const double added = count[add] * times.apart[add];
  const double multiplied = count[multiply] * times.apart[multiply] + count[fused] * times.apart[fused];
  const double any = std::min({times.mixed, times.apart[add], times.apart[multiply], times.apart[fused]});
  const double together = (count[add] + count[multiply] + count[fused]) * any;
  const double divided = count[divide] * times.apart[divide] + count[square_root] * times.apart[square_root];
  return std::max({added, multiplied, together, divided});
}

std::optional<Limit> limit(const TimedWork& work, suite::Mode mode, const ProcessorTimes& times) {
  if (times.empty()) return std::nullopt;
  if (mode == suite::Mode::batch) return limit_of_batch(work, times);
  auto count = point_operations(*work.evaluator, work.degree, work.dimension, Layout::axes);
  if (!count) return std::nullopt;
  const auto numbers = static_cast<std::size_t>(side_by_side(*work.evaluator, work.dimension));
  const auto& width = narrowest(times, numbers);
  const auto vectors = static_cast<double>((numbers + width.lanes - 1) / width.lanes);
  if (mode == suite::Mode::one_shot) {
    const auto prepared = curve_operations(*work.evaluator, work.conversion, work.degree, work.dimension, Layout::axes);
    if (!prepared) return std::nullopt;
    return Limit{vectors * least_ns(*count += *prepared, width), std::nullopt};
  }
  const double least = vectors * least_ns(*count, width);
  const double chain = *point_chain(*work.evaluator, work.degree, width.latency);
  return Limit{mode == suite::Mode::latency ? std::max(least, chain) : least, chain};
}

double share_of_limit(double limit_ns, double ns, double call_ns) {
  return ns > call_ns ? limit_ns / (ns - call_ns) : std::numeric_limits<double>::infinity();
}

}  // namespace bezierbench::race
