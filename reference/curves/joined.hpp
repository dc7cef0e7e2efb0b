// SPDX-License-Identifier: MIT
// Several files of curves as one set.
#pragma once

#include <span>
#include <string>

#include "reference/curves/read.hpp"

namespace bezierbench::curves {

struct NamedRead {
  std::string name;  ///< of the file
  Read read;
};

/// The curves of all files, in their order. Ids stay as they are in one file, and where they are different in all; else
/// all are `STEM:ID`, STEM being the file's name without folders and extension, with a number where that occurs twice,
/// and `STEM` for a curve without an id. Throws Unreadable for more curves than a set may have.
Read joined(std::span<const NamedRead> files);

}  // namespace bezierbench::curves
