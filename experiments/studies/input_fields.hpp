// SPDX-License-Identifier: MIT
// How an input that can be replayed is written: every bit of it, in hexadecimal floating point.
#pragma once

#include <string>
#include <vector>

#include "experiments/sample/draw.hpp"

namespace bezierbench::studies {

/// t,coefficients
const std::vector<std::string>& input_columns();

/// The fields of those columns: coefficients separated by blanks, all of the first axis, then of the next.
std::vector<std::string> input_fields(const sample::Trial& trial, int dimension);

}  // namespace bezierbench::studies
