// SPDX-License-Identifier: MIT
// What methods need of axes besides their arithmetic: a curve that is one of two, nodes, the division by a weight.
#pragma once

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/kernel/points/axes.hpp"
#include "core/evaluate/schemes/barycentric.hpp"

namespace bezierbench {

/// Of two curves the first, or the second, without a branch: which it is, no processor can guess for t at random.
template <Form F, class S, int Dimension, int Degree>
Curve<F, Axes<S, Dimension>, 1, Degree> chosen(bool is_first, const Curve<F, Axes<S, Dimension>, 1, Degree>& first,
                                               const Curve<F, Axes<S, Dimension>, 1, Degree>& second) {
  const S* const places[] = {second.data(), first.data()};
  return {places[is_first ? 1 : 0], first.degree()};
}

/// True at a node of the barycentric form, which all axes share.
template <class S, int Dimension>
bool at_node(const Axes<S, Dimension>& distance) {
  return at_node(distance.lane(0));
}

/// The point with these homogeneous coordinates, whose last lane is left over.
template <class S, int Lifted>
Point<Axes<S, Lifted>, 1> over_last(const Point<Axes<S, Lifted>, 1>& lifted) {
  return Point<Axes<S, Lifted>, 1>(lifted[0] / Axes<S, Lifted>(lifted[0].lane(Lifted - 1)));
}

}  // namespace bezierbench
