// SPDX-License-Identifier: MIT
// Code for hodographs of a low degree that the compiler knows: its loops are written out and its values stay in
// registers. It has the same operations, and so the same bits, as code for any degree.
#pragma once

#include "core/curve.hpp"

namespace bezierbench {

/// Calls measure(h), with the degree in the type of h up to 4, the hodographs of quintics.
template <int Dimension, class Measure>
auto with_fixed_degree(const Curve<Form::bernstein, double, Dimension>& hodograph, const Measure& measure) {
  const auto with_degree = [&]<int Degree>() {
    Curve<Form::bernstein, double, Dimension, Degree> h(Degree);
    for (int i = 0; i <= Degree; ++i)
      for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = hodograph(axis, i);
    return measure(h);
  };
  switch (hodograph.degree()) {
    case 1: return with_degree.template operator()<1>();
    case 2: return with_degree.template operator()<2>();
    case 3: return with_degree.template operator()<3>();
    case 4: return with_degree.template operator()<4>();
    default: return measure(hodograph);
  }
}

}  // namespace bezierbench
