// SPDX-License-Identifier: MIT
#include "experiments/timing/sentinel.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"

namespace bezierbench::timing {
namespace {

constexpr std::size_t steps_per_batch = 1024;  // even: x is where it began
constexpr double start = 0.25;

double median(std::span<const double> values) {
  return metric::median_interval(values, metric::timing_confidence).median;
}

}  // namespace

Rival sentinel() {
  auto x = std::make_shared<double>(0);
  const auto run = [x] {
    volatile double hidden = 1;  // a compiler that knew the factor would do without the product
    const double one = hidden;
    double value = start;
    for (std::size_t k = 0; k < steps_per_batch; ++k) value = one - one * value;
    *x = value;
  };
  return {std::string(sentinel_name), steps_per_batch, run, [x] { return std::exchange(*x, 0) == start; }};
}

HalfMedians half_medians(std::span<const double> ns_per_point) {
  const std::size_t half = ns_per_point.size() / 2;
  if (half == 0) return {ns_per_point.front(), ns_per_point.front()};
  const double first = median(ns_per_point.first(half));
  const double second = median(ns_per_point.subspan(half));
  return {std::min(first, second), std::max(first, second)};
}

}  // namespace bezierbench::timing
