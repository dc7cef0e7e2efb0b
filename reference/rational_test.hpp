// SPDX-License-Identifier: MIT
// What the tests of exact results share.
#pragma once

#include "reference/rational.hpp"

namespace bezierbench::reference {

inline bool same(const Rational& a, const Rational& b) { return (a - b).numerator == 0; }

}  // namespace bezierbench::reference
