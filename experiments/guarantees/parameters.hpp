// SPDX-License-Identifier: MIT
// Parameters that statements speak of.
#pragma once

#include "core/error_free.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
bool in_unit_interval(Scalar t) {
  return t >= 0 && t <= 1;
}

/// t, or the nearer end of [0,1].
template <class Scalar>
Scalar into_unit_interval(Scalar t) {
  return t < 0 ? Scalar(0) : t > 1 ? Scalar(1) : t;
}

/// Whether 1-t is a number.
template <class Scalar>
bool has_exact_complement(Scalar t) {
  return two_sum(Scalar(1), -t).error == 0;
}

}  // namespace bezierbench::guarantees
