// SPDX-License-Identifier: MIT
// The least number of chords, with ends on the curve and ascending parameters, whose pieces are all within a tolerance.
//
// From below: no k chords reach beyond R_k, where R_0 = 0 and R_(k+1) is an upper bound of the b for which some a <=
// R_k has a chord (a, b) within the tolerance. Chords with a <= R_(k-1) end before R_k. The rest is a search over boxes
// of a and b, farthest b first: a box is excluded if for one t between its a and b and one unit vector v, v.C(t) is
// above v.X by more than the tolerance for all X of the hulls of both pieces, over the box's a and over its b. A chord
// of the box is inside the hull of these two.
// From above: a flattening that is proved to be within the tolerance.
#pragma once

#include "reference/companion/chord_distance.hpp"

namespace bezierbench::reference {

struct LeastChords {
  int low;
  int high;
};

/// Tolerance above 0, in coordinate units. Both numbers are at most `most_counted`, which stands for more, too.
inline constexpr int most_counted = 4096;
LeastChords least_chords(const ScaledCurve& curve, double tolerance);

}  // namespace bezierbench::reference
