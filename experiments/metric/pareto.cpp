// SPDX-License-Identifier: MIT
#include "experiments/metric/pareto.hpp"

namespace bezierbench::metric {
namespace {

Front against(const Tradeoff& method, const Tradeoff& rival) {
  if (!(rival.largest_error <= method.largest_error)) return Front::on;
  if (rival.time.high < method.time.low) return Front::off;
  const bool seems_better = rival.time.median < method.time.median ||
                            (rival.time.median == method.time.median && rival.largest_error < method.largest_error);
  return seems_better ? Front::unresolved : Front::on;
}

}  // namespace

std::vector<Front> pareto_front(std::span<const Tradeoff> methods) {
  std::vector<Front> fronts;
  for (const auto& method : methods) {
    Front front = Front::on;
    for (const auto& rival : methods) {
      const Front one = against(method, rival);
      if (one == Front::off || (one == Front::unresolved && front == Front::on)) front = one;
    }
    fronts.push_back(front);
  }
  return fronts;
}

}  // namespace bezierbench::metric
