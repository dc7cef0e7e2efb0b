// SPDX-License-Identifier: MIT
// All statements, behind function pointers.
#pragma once

#include <array>

#include "experiments/guarantees/axes_independent.hpp"
#include "experiments/guarantees/constant_reproduced.hpp"
#include "experiments/guarantees/ends_exact.hpp"
#include "experiments/guarantees/finite.hpp"
#include "experiments/guarantees/in_convex_hull.hpp"
#include "experiments/guarantees/in_hull.hpp"
#include "experiments/guarantees/monotone.hpp"
#include "experiments/guarantees/reversal.hpp"
#include "experiments/guarantees/scaling_by_two.hpp"
#include "experiments/guarantees/total.hpp"
#include "experiments/guarantees/translation.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct Statement {
  Property property;
  int least_dimension = 1;
  int largest_dimension = most_axes;
  bool uses_t_next = false;
  bool uses_offset = false;
  /// Changes an input into one that the statement is about, if need be; twice is the same as once.
  void (*fit)(Case<Scalar>& input) = nullptr;
  Excess (*excess)(Evaluation<Scalar>& method, const Case<Scalar>& input) = nullptr;

  /// So many axes of an input decide; the others stay 0.
  [[nodiscard]] int axes(int dimension) const { return least_dimension > 1 ? dimension : 1; }
  [[nodiscard]] bool concerns(int dimension) const {
    return dimension >= least_dimension && dimension <= largest_dimension;
  }
};

template <class Scalar, template <class> class Defined>
constexpr Statement<Scalar> statement() {
  using Definition = Defined<Scalar>;
  Statement<Scalar> made{.property = Definition::property, .fit = Definition::fit, .excess = Definition::excess};
  if constexpr (requires { Definition::least_dimension; }) made.least_dimension = Definition::least_dimension;
  if constexpr (requires { Definition::in_the_plane; }) made.least_dimension = made.largest_dimension = 2;
  if constexpr (requires { Definition::uses_t_next; }) made.uses_t_next = true;
  if constexpr (requires { Definition::uses_offset; }) made.uses_offset = true;
  return made;
}

/// In the order of `properties`.
template <class Scalar>
inline constexpr std::array statements{statement<Scalar, EndsExact>(),
                                       statement<Scalar, ConstantReproduced>(),
                                       statement<Scalar, InHull>(),
                                       statement<Scalar, InConvexHull>(),
                                       statement<Scalar, Monotone>(),
                                       statement<Scalar, Reversal>(),
                                       statement<Scalar, Translation>(),
                                       statement<Scalar, ScalingByTwo>(),
                                       statement<Scalar, AxesIndependent>(),
                                       statement<Scalar, Finite>(),
                                       statement<Scalar, Total>()};
static_assert(statements<double>.size() == properties.size());

}  // namespace bezierbench::guarantees
