// SPDX-License-Identifier: MIT
// Studies of projection have no keys of their own.
#pragma once

namespace bezierbench::suite {

struct Kind;

struct ProjectionKeys {
  static const Kind& kind();
};

}  // namespace bezierbench::suite
