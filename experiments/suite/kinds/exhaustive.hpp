// SPDX-License-Identifier: MIT
// Keys of studies that evaluate named curves at every float of an interval.
#pragma once

#include <string>
#include <vector>

namespace bezierbench::suite {

struct Kind;

struct ExhaustiveKeys {
  std::vector<std::string> curves;  ///< ids or globs of the named curves

  static const Kind& kind();
};

}  // namespace bezierbench::suite
