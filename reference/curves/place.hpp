// SPDX-License-Identifier: MIT
// What the readers of texts share: how they refuse a place of their text, and how curves enter a set within the limits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/curve_view.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {

/// A text and the name of its file, for messages.
struct Source {
  std::string_view text;
  std::string name;

  /// Throws Unreadable with `NAME:LINE:COLUMN: what` for the byte `offset`. Lines and columns are counted from 1,
  /// columns in bytes.
  [[noreturn]] void refuse(std::size_t offset, std::string_view what) const;
};

/// Throws Unreadable that names the file where `set` has as many curves as a set may.
void require_room(const CurveSet& set, std::string_view name);

}  // namespace bezierbench::curves
