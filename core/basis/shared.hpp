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

/// The type of a value that is the same for all curves of a Scalar: `Scalar` itself where that is one number, else what
/// it names `Shared`, which converts to it.
template <class Scalar>
using SharedBy = typename detail::SharedType<Scalar>::Type;

}  // namespace bezierbench
