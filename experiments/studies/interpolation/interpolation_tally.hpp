// SPDX-License-Identifier: MIT
// What blocks of trials gave for every method, for one number of points in one cell of a study of interpolation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

/// Of each trial the largest over knots and axes; but for `error` in u times the largest coordinate of the axis.
struct SplineErrors {
  metric::Tally error;    ///< of the inner control points, in coordinate units
  metric::Tally error_u;  ///< of the inner control points
  metric::Tally data;     ///< residuals: |P0,i - K_i| and |P3,i - K_(i+1)|
  metric::Tally c0;       ///< gaps between segments
  metric::Tally c1;       ///< jumps of first differences
  metric::Tally c2;       ///< jumps of second differences
  metric::Tally natural;  ///< second differences at the ends
  std::uint64_t non_finite = 0;
  std::uint64_t violations = 0;                                               ///< a residual above its proved bound
  std::uint64_t first_violation = std::numeric_limits<std::uint64_t>::max();  ///< trial

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.error_u, self.data, self.c0, self.c1, self.c2, self.natural, self.non_finite,
          self.violations, self.first_violation);
  }

  void merge(const SplineErrors& other) {
    error.merge(other.error);
    error_u.merge(other.error_u);
    data.merge(other.data);
    c0.merge(other.c0);
    c1.merge(other.c1);
    c2.merge(other.c2);
    natural.merge(other.natural);
    non_finite += other.non_finite;
    violations += other.violations;
    first_violation = std::min(first_violation, other.first_violation);
  }
};

struct InterpolationTally {
  std::vector<SplineErrors> methods;  ///< as the study chose them

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.methods);
  }

  void merge(const InterpolationTally& other) {
    if (other.methods.size() != methods.size()) throw std::invalid_argument("tallies of different methods");
    for (std::size_t k = 0; k < methods.size(); ++k) methods[k].merge(other.methods[k]);
  }
};

}  // namespace bezierbench::studies
