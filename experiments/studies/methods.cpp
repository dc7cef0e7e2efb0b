// SPDX-License-Identifier: MIT
#include "experiments/studies/methods.hpp"

#include <array>
#include <type_traits>
#include <vector>

#include "experiments/peers/peers.hpp"

namespace bezierbench::studies {
namespace {

constexpr int max_dimension = 3;

using Kernels = std::vector<Kernel<double>>;

Kernels with_peers(int dimension) {
  const auto ours = kernels<double>(dimension);
  Kernels all(ours.begin(), ours.end());
  for (const auto& peer : peers::present()) {
    const auto theirs = peer.kernels(dimension);
    all.insert(all.end(), theirs.begin(), theirs.end());
  }
  return all;
}

}  // namespace

template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension) {
  if constexpr (std::is_same_v<Scalar, double>) {
    static const std::array<Kernels, max_dimension> tables{with_peers(1), with_peers(2), with_peers(3)};
    if (dimension < 1 || dimension > max_dimension) return {};
    return tables[static_cast<std::size_t>(dimension - 1)];
  } else {
    return kernels<Scalar>(dimension);
  }
}

template std::span<const Kernel<float>> methods<float>(int dimension);
template std::span<const Kernel<double>> methods<double>(int dimension);

}  // namespace bezierbench::studies
