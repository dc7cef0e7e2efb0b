// SPDX-License-Identifier: MIT
#include "experiments/timing/sentinel.hpp"

#include <memory>
#include <utility>

namespace bezierbench::timing {
namespace {

constexpr std::size_t steps_per_batch = 1024;  // even: x is where it began
constexpr double start = 0.25;

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

}  // namespace bezierbench::timing
