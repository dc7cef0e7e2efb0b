// SPDX-License-Identifier: MIT
#include "experiments/metric/error_units.hpp"

#include <algorithm>

namespace bezierbench::metric {

double size_of(const CurveView<double>& curve, double scale) {
  if (curve.form == Form::power) return 0;
  double size = 0;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    double low = curve(axis, 0);
    double high = low;
    for (int i = 1; i <= curve.degree; ++i) {
      low = std::min(low, curve(axis, i));
      high = std::max(high, curve(axis, i));
    }
    size = std::max(size, scale * high - scale * low);
  }
  return size;
}

}  // namespace bezierbench::metric
