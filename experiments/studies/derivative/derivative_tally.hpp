// SPDX-License-Identifier: MIT
// What blocks of trials gave for every method, at one order in one cell of a study of derivatives.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

struct DerivativeErrors {
  metric::Tally error;
  metric::Tally error_u;
  std::uint64_t non_finite = 0;
  std::uint64_t bounded = 0;  ///< trials for which a bound is proved
  std::uint64_t violations = 0;
  std::uint64_t first_violation = std::numeric_limits<std::uint64_t>::max();  ///< trial
  double bound_u = 0;                                                         ///< the largest of bound / (u p~)

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.error_u, self.non_finite, self.bounded, self.violations, self.first_violation, self.bound_u);
  }

  void merge(const DerivativeErrors& other) {
    error.merge(other.error);
    error_u.merge(other.error_u);
    non_finite += other.non_finite;
    bounded += other.bounded;
    violations += other.violations;
    first_violation = std::min(first_violation, other.first_violation);
    bound_u = std::max(bound_u, other.bound_u);
  }
};

struct DerivativeTally {
  std::vector<DerivativeErrors> methods;  ///< as the study chose them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.methods);
  }

  void merge(const DerivativeTally& other) {
    if (other.methods.size() != methods.size()) throw std::invalid_argument("tallies of different methods");
    for (std::size_t k = 0; k < methods.size(); ++k) methods[k].merge(other.methods[k]);
  }
};

}  // namespace bezierbench::studies
