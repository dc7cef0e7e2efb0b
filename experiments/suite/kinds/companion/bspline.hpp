// SPDX-License-Identifier: MIT
// Studies of knot spans of B-spline curves have no keys of their own.
#pragma once

namespace bezierbench::suite {

struct Kind;

struct BsplineKeys {
  static const Kind& kind();
};

}  // namespace bezierbench::suite
