// SPDX-License-Identifier: MIT
// Values that a scalar that stands for several numbers computes once. Those that depend on the degree only, such as
// binomials, are shared by all curves. Those that depend on t as well are shared by all axes of a point: one division
// instead of one for each axis, and comparisons whose results are plain truth values.
#pragma once

namespace bezierbench {

namespace detail {

template <class Scalar>
struct SharedType {
  using Type = Scalar;
};
template <class Scalar>
requires requires { typename Scalar::Shared; }
struct SharedType<Scalar> {
  using Type = typename Scalar::Shared;
};

}  // namespace detail

/// The type of a value that all curves of a Scalar share: `Scalar` itself where it is one number, else its member type
/// `Shared`, which converts to it.
template <class Scalar>
using SharedBy = typename detail::SharedType<Scalar>::Type;

/// Returns t in the type for values that depend on t alone. That type is `Scalar`; for Axes, which have a function of
/// their own in core/evaluate/kernel/points/axes.hpp, it is the type of a coordinate. A Scalar can be constructed from
/// either.
template <class Scalar>
constexpr Scalar parameter_of(const Scalar& t) {
  return t;
}

}  // namespace bezierbench
