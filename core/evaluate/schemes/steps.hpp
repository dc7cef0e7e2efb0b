// SPDX-License-Identifier: MIT
// The steps of a recurrence over the coefficients of a curve. A processor overlaps the steps of consecutive points only
// as far as it guesses right where the loop over them ends, and a compiler writes a loop out for small degrees only. So
// the axes of a point, whose steps are short, have the last 32 steps written out, one after the other, and enter them
// where the degree says: the same code for every degree. Other scalars have a loop.
#pragma once

#include "core/curve.hpp"

namespace bezierbench {

/// True for a scalar whose recurrences are written out.
template <class Scalar>
inline constexpr bool writes_out_steps = false;

/// Calls step(last), step(last - 1), ..., step(0) for a curve of degree `Degree`, which may be dynamic.
template <class Scalar, int Degree, class Step>
[[gnu::always_inline]] inline void count_down(int last, const Step& step) {
  if constexpr (writes_out_steps<Scalar> && Degree == dynamic) {
    for (; last > 31; --last) step(last);
    switch (last) {
      case 31: step(31); [[fallthrough]];
      case 30: step(30); [[fallthrough]];
      case 29: step(29); [[fallthrough]];
      case 28: step(28); [[fallthrough]];
      case 27: step(27); [[fallthrough]];
      case 26: step(26); [[fallthrough]];
      case 25: step(25); [[fallthrough]];
      case 24: step(24); [[fallthrough]];
      case 23: step(23); [[fallthrough]];
      case 22: step(22); [[fallthrough]];
      case 21: step(21); [[fallthrough]];
      case 20: step(20); [[fallthrough]];
      case 19: step(19); [[fallthrough]];
      case 18: step(18); [[fallthrough]];
      case 17: step(17); [[fallthrough]];
      case 16: step(16); [[fallthrough]];
      case 15: step(15); [[fallthrough]];
      case 14: step(14); [[fallthrough]];
      case 13: step(13); [[fallthrough]];
      case 12: step(12); [[fallthrough]];
      case 11: step(11); [[fallthrough]];
      case 10: step(10); [[fallthrough]];
      case 9: step(9); [[fallthrough]];
      case 8: step(8); [[fallthrough]];
      case 7: step(7); [[fallthrough]];
      case 6: step(6); [[fallthrough]];
      case 5: step(5); [[fallthrough]];
      case 4: step(4); [[fallthrough]];
      case 3: step(3); [[fallthrough]];
      case 2: step(2); [[fallthrough]];
      case 1: step(1); [[fallthrough]];
      case 0: step(0); [[fallthrough]];
      default: return;
    }
  } else {
    for (; last >= 0; --last) step(last);
  }
}

}  // namespace bezierbench
