// SPDX-License-Identifier: MIT
// Models of CAD, read by Open CASCADE in a process of its own.
#pragma once

#include <string>
#include <string_view>

#include "reference/curves/read.hpp"

namespace bezierbench::cli {

/// Reads a STEP or IGES file as peers::model_reader() does, which must not be null. Throws curves::Unreadable also where
/// Open CASCADE crashes or takes more than the time and the memory that it is given, and Failure(interrupted).
curves::Read read_model(std::string_view contents, const std::string& name);

}  // namespace bezierbench::cli
