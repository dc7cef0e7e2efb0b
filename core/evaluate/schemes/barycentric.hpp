// SPDX-License-Identifier: MIT
// Formula: p(t) = sum w_j/(t - x_j) p(x_j) / sum w_j/(t - x_j),  w_j = 1 / product over k != j of (x_j - x_k).
//   This is the second barycentric form through n + 1 points of the curve. The methods that share this scheme differ in
//   their nodes x_j only.
// Source: [Berrut and Trefethen 2004], eq. (4.2); weights by eq. (3.2).
// Cost: (n+1)(3+2d) + d flops per point, n+1+d of them divisions. `prepare` takes n(n+1) flops for the weights and
//   14 d n(n+1) for the values by compensated_volk_schumaker. These are about as accurate as rounded exact values and
//   cost O(n) a node, where de Casteljau's triangle would make O(n^3) of `prepare`.
// Nodes: the form interpolates with any weights, but equals p only with the weights of the stored nodes. Therefore
//   nodes are rounded to multiples of u first, the right half as 1 minus the left. Their differences are then exact,
//   and the weights, which are products of these differences, have a relative error of at most gamma_n. Closed forms of
//   the weights belong to unrounded nodes. Near 0 those lie as close as 2.4/n^2 and rounding moves them by about u, so
//   such weights would have a relative error of n^2 u. In float, weights and values are formed in double and rounded
//   once.
// Bound: with M = max|b| and L = sum |l_j(t)|, the Lebesgue function of the nodes, |computed - p| <= (4n+7) u L M to
//   first order. A term of the numerator has 2n+4 roundings (value, n in the weight, difference, quotient, product, n
//   additions), one of the denominator 2n+2, and their quotient one ([Higham 2004], second form). This is not a
//   multiple of p~: where p~ vanishes at an end, the error need not. So `info` states no bound.
// Fails: where coordinates over |t - x_j| overflow, for t next to 0 and coordinates past 2^500 (2^60 in float). The
//   error relative to p~ grows without limit near the ends, where p~ may vanish (see the bound).
#pragma once

#include <algorithm>
#include <concepts>
#include <tuple>
#include <type_traits>

#include "core/evaluate/methods/compensated_volk_schumaker.hpp"
#include "core/vector/lane_choice.hpp"
#include "core/vector/shared.hpp"

namespace bezierbench {

template <class Scalar, int Dimension, int Degree>
struct Barycentric {
  PreparedRow<Scalar, Degree> nodes;
  PreparedRow<Scalar, Degree> weights;
  Curve<Form::bernstein, Scalar, Dimension, Degree> values;  ///< column j is the point at nodes[j]

  [[nodiscard]] auto parts() const { return std::tie(nodes, weights, values); }
};

namespace detail {

/// The type in which `prepare` computes: double for floating point, the scalar itself for exact scalars.
template <class Scalar>
using PerCurve = std::conditional_t<std::floating_point<Scalar>, double, Scalar>;

/// The nodes whose left half is `left(j)`, in [0, 1/2]: x_j + x_(n-j) = 1, and for floating point all are multiples of
/// u, as is every number that was rounded in [1/2, 1].
template <class Scalar, int Degree, class Left>
PerCoefficient<Scalar, Degree> mirrored_nodes(int n, Left left) {
  auto nodes = per_coefficient<Scalar, Degree>(n);
  const Scalar half = Scalar(1) / Scalar(2);
  for (int j = 0; 2 * j < n; ++j) {
    const PerCurve<Scalar> beyond_half = left(j) + PerCurve<Scalar>(half);
    nodes[j] = static_cast<Scalar>(beyond_half) - half;
    nodes[n - j] = Scalar(1) - nodes[j];
  }
  if (n % 2 == 0) nodes[n / 2] = half;
  return nodes;
}

/// The weights of these nodes in [0,1], the largest of them 1. Differences are quadrupled, by 1 over the capacity of
/// the interval, so that no product leaves the range of double.
template <class Scalar, int Degree>
PerCoefficient<Scalar, Degree> weights_of(const PerCoefficient<Scalar, Degree>& nodes) {
  using Wide = PerCurve<Scalar>;
  const int n = static_cast<int>(nodes.size()) - 1;
  auto products = per_coefficient<Wide, Degree>(n);
  for (int j = 0; j <= n; ++j) {
    products[j] = Wide(1);
    for (int k = 0; k <= n; ++k)
      if (k != j) products[j] *= Wide(4) * (static_cast<Wide>(nodes[j]) - static_cast<Wide>(nodes[k]));
  }
  const auto magnitude = [](const Wide& value) { return value < Wide(0) ? Wide(-value) : value; };
  Wide smallest = magnitude(products[0]);
  for (int j = 1; j <= n; ++j) smallest = std::min<Wide>(smallest, magnitude(products[j]));
  auto weights = per_coefficient<Scalar, Degree>(n);
  for (int j = 0; j <= n; ++j) weights[j] = static_cast<Scalar>(Wide(smallest / products[j]));
  return weights;
}

}  // namespace detail

/// The distance from a node below which a quotient might overflow, for scalars that round, lanes of them included.
template <class Scalar>
inline constexpr double node_reach = 0;
template <>
inline constexpr double node_reach<double> = 0x1p-500;
template <>
inline constexpr double node_reach<float> = 0x1p-60;
template <class Lanes>
requires requires { typename Lanes::Scalar; }
inline constexpr double node_reach<Lanes> = node_reach<typename Lanes::Scalar>;

/// True at a node, and so close to one that a quotient might overflow. Only the node 0 has doubles so near it, so that
/// none is near two nodes; the curve changes by at most 2 n max|b| |distance| on the way.
template <class Scalar>
constexpr auto at_node(const Scalar& distance) {
  if constexpr (node_reach < Scalar >> 0) {
    const auto reach = Scalar(node_reach<Scalar>);
    return both(-reach < distance, distance < reach);
  } else {
    return distance == Scalar(0);
  }
}

/// All per-curve work, for these distinct nodes in [0,1].
template <class Scalar, int Dimension, int Degree>
Barycentric<Scalar, Dimension, Degree> prepare_barycentric(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, const PerCoefficient<Scalar, Degree>& nodes) {
  using Wide = detail::PerCurve<Scalar>;
  const int n = curve.degree();
  Curve<Form::bernstein, Wide, Dimension, Degree> wide(n);
  for (int i = 0; i <= n; ++i)
    for (int axis = 0; axis < Dimension; ++axis) wide(axis, i) = static_cast<Wide>(curve(axis, i));
  const auto scheme = CompensatedVolkSchumaker::prepare(wide);
  Barycentric<Scalar, Dimension, Degree> prepared{nodes, detail::weights_of<Scalar, Degree>(nodes), curve};
  for (int j = 0; j <= n; ++j) {
    const auto point = CompensatedVolkSchumaker::evaluate(scheme, static_cast<Wide>(nodes[j]));
    for (int axis = 0; axis < Dimension; ++axis) prepared.values(axis, j) = static_cast<Scalar>(point[axis]);
  }
  return prepared;
}

/// The second form at t; at a node the value there. A scalar leaves the sum at its node; of many lanes those at a node
/// are given its value afterwards.
template <class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> evaluate_barycentric(const Barycentric<Scalar, Dimension, Degree>& prepared, const Scalar& t) {
  const int n = prepared.values.degree();
  Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
  Scalar denominator(0);
  bool at_some_node = false;
  for (int j = 0; j <= n; ++j) {
    const Scalar distance = t - prepared.nodes[j];
    const auto at_this_node = at_node(parameter_of(distance));
    if (all_of(at_this_node)) {
      for (int axis = 0; axis < Dimension; ++axis) sum[axis] = prepared.values(axis, j);
      return sum;
    }
    at_some_node |= any_of(at_this_node);
    const Scalar quotient = prepared.weights[j] / distance;
    denominator += quotient;
    for (int axis = 0; axis < Dimension; ++axis) sum[axis] += quotient * prepared.values(axis, j);
  }
  for (int axis = 0; axis < Dimension; ++axis) sum[axis] = sum[axis] / denominator;
  if (!at_some_node) return sum;
  for (int j = 0; j <= n; ++j) {
    const Scalar distance = t - prepared.nodes[j];
    const auto at_this_node = at_node(parameter_of(distance));
    for (int axis = 0; axis < Dimension; ++axis) sum[axis] = select(at_this_node, prepared.values(axis, j), sum[axis]);
  }
  return sum;
}

}  // namespace bezierbench
