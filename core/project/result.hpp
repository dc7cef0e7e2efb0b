// SPDX-License-Identifier: MIT
// The result of a method for point projection.
#pragma once

namespace bezierbench {

/// The parameter at which a method finds the curve nearest to the point.
struct FootPoint {
  double t = 0;
  double distance = 0;    ///< |C(t) - P|, in coordinate units
  int candidates = 0;     ///< parameters or pieces among which the nearest was sought
  bool converged = true;  ///< false where the method gave up early
};

}  // namespace bezierbench
