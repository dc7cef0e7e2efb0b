// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {

/// The number in an option, from 0 on. The parser would turn a number beyond the range of the type into the largest one
/// of the type. Throws Failure(Exit::usage).
inline std::int64_t whole_number(std::string_view option, const std::string& text) {
  const auto number = number::parse_integer(text);
  if (!number || *number < 0)
    throw Failure(Exit::usage, fmt::format("{} {}: not a whole number from 0 to 2^63-1", option, text));
  return *number;
}

}  // namespace bezierbench::cli
