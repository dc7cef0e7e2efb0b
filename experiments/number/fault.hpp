// SPDX-License-Identifier: MIT
// What messages say of texts that are not the numbers that they should be.
#pragma once

#include <string_view>

namespace bezierbench::number {

/// Why `text`, which parse_number() refuses or reads as infinity or NaN, is not a finite double, and what to do: the
/// predicate of a sentence.
[[nodiscard]] std::string_view fault(std::string_view text);

}  // namespace bezierbench::number
