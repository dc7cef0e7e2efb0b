// SPDX-License-Identifier: MIT
#include "experiments/race/operation_times.hpp"

#include <algorithm>
#include <limits>

#include "core/batch/batch.hpp"
#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::race {
namespace {

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
