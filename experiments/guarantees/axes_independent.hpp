// SPDX-License-Identifier: MIT
// axes_independent: a coordinate of p(t) is the same whatever the other axes of the control points are, for t in [0,1]
// and all finite control points, subnormal ones included; also whether it is finite. It is compared with what results
// where the other axes are 0.
#pragma once

#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct AxesIndependent {
  static constexpr Property property = Property::axes_independent;
  static constexpr int least_dimension = 2;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    double largest = 0;
    for (int axis = 0; axis < input.dimension; ++axis) {
      auto alone = input;
      for (int i = 0; i <= input.degree(); ++i)
        for (int other = 0; other < input.dimension; ++other)
          if (other != axis) alone(other, i) = 0;
      const Scalar with = point[static_cast<std::size_t>(axis)];
      const Scalar without = method.point(alone.coefficients, input.t)[static_cast<std::size_t>(axis)];
      if (std::isfinite(with) && std::isfinite(without))
        largest = std::max(largest, std::abs(ulps_above(with, without)));
      else if (!(with == without || (std::isnan(with) && std::isnan(without))))
        largest = infinite;
    }
    return largest;
  }
};

}  // namespace bezierbench::guarantees
