// SPDX-License-Identifier: MIT
// The concept of a method for roots: `info`, and one function from the coefficients of a polynomial in Bernstein form
// to its roots in [0, 1]. The polynomial is a coordinate of a curve minus a value; coefficients are differences, so
// that each is off by u of itself and by underflow, and 0 only where the difference is.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include "core/method.hpp"

namespace bezierbench {

/// If `certain`, low < high and there is one distinct root between them, or low = high is the root itself. Otherwise it
/// is not known how many roots there are in [low, high].
struct RootEnclosure {
  double low;
  double high;
  bool certain;
};

struct FoundRoots {
  std::vector<double> t;                  ///< in [0, 1], ascending
  std::vector<RootEnclosure> enclosures;  ///< ascending, of a method with a promise: every root is in one of them
  std::int64_t evaluations = 0;           ///< triangles of de Casteljau: values and subdivisions
};

/// `find(b)` takes at least one coefficient, none of them above 2 in magnitude. It is pure, and neither prints nor
/// throws. A polynomial that is 0 everywhere has no answer that means anything.
template <class M>
concept RootsMethod = requires(const std::vector<double>& b) {
  requires M::info.problem == Problem::roots;
  { M::find(b) } -> std::same_as<FoundRoots>;
};

}  // namespace bezierbench
