// SPDX-License-Identifier: MIT
// What a bb_curves is: the curves of a file, or the spans of a B-spline curve.
#pragma once

#include "reference/curves/read.hpp"

struct bb_curves {
  bezierbench::curves::CurveSet set;
};
