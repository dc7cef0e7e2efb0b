// SPDX-License-Identifier: MIT
#include "reference/curves/place.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bezierbench::curves {

void Source::refuse(std::size_t offset, std::string_view what) const {
  const auto before = text.substr(0, offset);
  const auto line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  throw Unreadable(
      fmt::format("{}:{}:{}: {}", name, 1 + std::ranges::count(before, '\n'), before.size() - line_begin + 1, what));
}

void require_room(const CurveSet& set, std::string_view name) {
  if (set.size() >= most_curves)
    throw Unreadable(fmt::format("{}: more than {} curves; split the file", name, most_curves));
}

}  // namespace bezierbench::curves
