// SPDX-License-Identifier: MIT
// Values that depend on the degree only, such as binomials. Where a scalar stands for many curves, all of them share
// these values, which are computed once.
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

}  // namespace bezierbench
