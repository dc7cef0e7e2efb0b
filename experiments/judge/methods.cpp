// SPDX-License-Identifier: MIT
#include "experiments/judge/methods.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "experiments/peers/peers.hpp"

namespace bezierbench::judge {
namespace {

constexpr int max_dimension = 3;

/// A table for each dimension, our own first.
template <class K>
class Tables {
 public:
  Tables(std::span<const K> (*ours)(int), std::span<const K> (*peers::Peer::*theirs)(int)) {
    for (int dimension = 1; dimension <= max_dimension; ++dimension) {
      auto& table = tables_[static_cast<std::size_t>(dimension - 1)];
      const auto append = [&](std::span<const K> kernels) {
        table.insert(table.end(), kernels.begin(), kernels.end());
      };
      append(ours(dimension));
      for (const auto& peer : peers::present()) append((peer.*theirs)(dimension));
    }
  }
  [[nodiscard]] std::span<const K> of(int dimension) const {
    if (dimension < 1 || dimension > max_dimension) return {};
    return tables_[static_cast<std::size_t>(dimension - 1)];
  }

 private:
  std::array<std::vector<K>, max_dimension> tables_;
};

template <class K>
void add_infos(std::span<const K> kernels, std::vector<const MethodInfo*>& infos) {
  for (const auto& kernel : kernels)
    if (std::ranges::count(infos, kernel.info) == 0) infos.push_back(kernel.info);
}

}  // namespace

template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension) {
  if constexpr (std::is_same_v<Scalar, double>) {
    static const Tables<Kernel<double>> tables(kernels<double>, &peers::Peer::kernels);
    return tables.of(dimension);
  } else {
    return kernels<Scalar>(dimension);
  }
}

template std::span<const Kernel<float>> methods<float>(int dimension);
template std::span<const Kernel<double>> methods<double>(int dimension);

std::span<const ArcLengthKernel> arc_length_methods(int dimension) {
  static const Tables<ArcLengthKernel> tables(arc_length_kernels, &peers::Peer::arc_length_kernels);
  return tables.of(dimension);
}

std::span<const ProjectionKernel> projection_methods(int dimension) {
  static const Tables<ProjectionKernel> tables(projection_kernels, &peers::Peer::projection_kernels);
  return tables.of(dimension);
}

std::span<const MethodInfo* const> companion_peer_infos() {
  static const std::vector<const MethodInfo*> infos = [] {
    std::vector<const MethodInfo*> all;
    for (const auto& peer : peers::present())
      for (int dimension = 1; dimension <= max_dimension; ++dimension) {
        add_infos(peer.arc_length_kernels(dimension), all);
        add_infos(peer.projection_kernels(dimension), all);
      }
    return all;
  }();
  return infos;
}

}  // namespace bezierbench::judge
