// SPDX-License-Identifier: MIT
// Studies of splitting a curve have no keys of their own.
#pragma once

namespace bezierbench::suite {

struct Kind;

struct SubdivisionKeys {
  static const Kind& kind();
};

}  // namespace bezierbench::suite
