// SPDX-License-Identifier: MIT
// Keys of conversion studies: errors of coefficients in another form.
#pragma once

#include <string>

namespace bezierbench::suite {

struct Kind;

struct ConversionKeys {
  std::string published;  ///< file of printed values in reference/published; may be empty

  static const Kind& kind();
};

}  // namespace bezierbench::suite
