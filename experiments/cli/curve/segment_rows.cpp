// SPDX-License-Identifier: MIT
#include "experiments/cli/curve/segment_rows.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>

#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::cli {

void print_segments(std::span<const double> segments, int dimension) {
  constexpr std::size_t enough = 1U << 20U;  // bytes; rows are written in portions of about this size
  std::string text = "segment,index";
  for (int axis = 0; axis < dimension; ++axis) text += "," + axis_name(axis);
  text += "\n";
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t point = 0; point < segments.size() / d; ++point) {
    fmt::format_to(std::back_inserter(text), "{},{}", point / 4, point % 4);
    for (const double value : segments.subspan(point * d, d)) text += "," + number::decimal(value);
    text += "\n";
    if (text.size() < enough) continue;
    fmt::print("{}", text);
    text.clear();
  }
  fmt::print("{}", text);
}

}  // namespace bezierbench::cli
