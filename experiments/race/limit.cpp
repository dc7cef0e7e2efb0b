// SPDX-License-Identifier: MIT
#include "experiments/race/limit.hpp"

#include <algorithm>
#include <limits>

#include "core/batch/batch.hpp"
#include "experiments/metric/order_statistics.hpp"

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

/// Nanoseconds per operation.
template <class Scalar>
double fastest_turn(const batch::OperationWork<Scalar>& work, Clock clock) {
  constexpr double turn_ns = 2000;  // about a hundred steps of a clock
  constexpr int turns = 9;
  std::vector<Scalar> values;
  const auto turn = [&](std::size_t runs) {
    values.assign(work.chains[0].values, work.chains[0].first);
    values.resize(work.chains[0].values + work.chains[1].values, work.chains[1].first);
    const auto start = clock();
    for (std::size_t k = 0; k < runs; ++k) work.run(work.operand, values.data());
    return static_cast<double>(clock() - start);
  };
  constexpr std::size_t most_runs = 1 << 16;
  std::size_t runs = 1;
  while (turn(runs) < turn_ns && runs < most_runs) runs *= 2;
  double fastest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < turns; ++k) fastest = std::min(fastest, turn(runs));
  return fastest / (static_cast<double>(runs) * work.operations);
}

template <class Scalar>
OperationTimes measured_width(const batch::OperationWorks<Scalar>& works, Clock clock) {
  OperationTimes times{.lanes = works.lanes, .apart = {}, .latency = {}};
  for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
    times.apart.values[kind] = fastest_turn(works.side_by_side[kind], clock);
    times.latency.values[kind] = fastest_turn(works.one_by_one[kind], clock);
  }
  times.mixed = fastest_turn(works.multiply_add_and_add, clock);
  return times;
}

/// The median of one of the numbers.
template <class Of>
double median_over(const std::vector<ProcessorTimes>& measurements, const Of& of) {
  std::vector<double> values;
  for (const auto& one : measurements) values.push_back(of(one));
  return metric::median(values);
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

template <class Scalar>
ProcessorTimes measured_operations(Clock clock) {
  ProcessorTimes times;
  const auto targets = batch::usable_targets();
  if (targets.empty()) return times;
  for (const auto& works : batch::works_of<Scalar>(*targets.front())) times.push_back(measured_width(works, clock));
  return times;
}

template ProcessorTimes measured_operations<float>(Clock);
template ProcessorTimes measured_operations<double>(Clock);

ProcessorTimes median_of(const std::vector<ProcessorTimes>& measurements) {
  if (measurements.empty()) return {};
  ProcessorTimes medians = measurements.front();
  for (std::size_t width = 0; width < medians.size(); ++width) {
    const auto take = [&](auto& place, const auto& of) {
      place = median_over(measurements, [&](const ProcessorTimes& one) { return of(one.at(width)); });
    };
    for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
      take(medians[width].apart.values[kind], [kind](const OperationTimes& times) { return times.apart.values[kind]; });
      take(medians[width].latency.values[kind],
           [kind](const OperationTimes& times) { return times.latency.values[kind]; });
    }
    take(medians[width].mixed, [](const OperationTimes& times) { return times.mixed; });
  }
  return medians;
}

}  // namespace bezierbench::race
