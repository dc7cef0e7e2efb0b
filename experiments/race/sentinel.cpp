// SPDX-License-Identifier: MIT
#include "experiments/race/sentinel.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "experiments/race/page_vector.hpp"

namespace bezierbench::race {
namespace {

constexpr std::size_t steps_per_batch = 1024;  // even: x is where it began
constexpr double start = 0.25;
constexpr std::size_t numbers_of_sweep = 256;  // two kilobytes, as the parameters of methods
constexpr std::size_t sweeps_per_batch = 16;   // even

/// Not a constant for the compiler, which would otherwise remove the product.
double one() {
  volatile double hidden = 1;
  return hidden;
}

}  // namespace

Rival chain_sentinel() {
  auto x = std::make_shared<double>(0);
  const auto run = [x] {
    const double factor = one();
    double value = start;
    for (std::size_t k = 0; k < steps_per_batch; ++k) value = factor - factor * value;
    *x = value;
  };
  return {std::string(sentinel_name), steps_per_batch, run, [x] { return std::exchange(*x, 0) == start; }};
}

Rival sweep_sentinel() {
  auto numbers = std::make_shared<PageVector<double, 0>>(numbers_of_sweep, 0);
  const auto run = [numbers] {
    std::ranges::fill(*numbers, start);
    const double factor = one();
    for (std::size_t sweep = 0; sweep < sweeps_per_batch; ++sweep)
      for (double& x : *numbers) x = factor - factor * x;
  };
  const auto check = [numbers] {
    const bool right = std::ranges::all_of(*numbers, [](double x) { return x == start; });
    std::ranges::fill(*numbers, 0);
    return right;
  };
  return {"sweep", numbers_of_sweep * sweeps_per_batch, run, check};
}

std::array<Rival, 2> sentinels() { return {sweep_sentinel(), chain_sentinel()}; }

}  // namespace bezierbench::race
