// SPDX-License-Identifier: MIT
// Every method for B-spline curves. One line here makes it exist everywhere, for rational curves too.
#pragma once

#include "core/bspline/chudy_wozny_span.hpp"
#include "core/bspline/de_boor.hpp"
#include "core/bspline/de_boor_cox_basis.hpp"
#include "core/bspline/homogeneous_span.hpp"
#include "core/bspline/knot_insertion_span.hpp"

namespace bezierbench {

using PolynomialBsplineMethods = TypeList<DeBoor,             //
                                          DeBoorCoxBasis,     //
                                          KnotInsertionSpan,  //
                                          ChudyWoznySpan>;

namespace detail {

template <class... Methods>
TypeList<Methods..., HomogeneousSpan<Methods>...> and_rational(TypeList<Methods...>);

}  // namespace detail

using BsplineMethods = decltype(detail::and_rational(PolynomialBsplineMethods{}));

}  // namespace bezierbench
