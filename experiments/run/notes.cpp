// SPDX-License-Identifier: MIT
#include "experiments/run/notes.hpp"

#include <cstdio>

#include "experiments/echo.hpp"

namespace bezierbench::run {

void note(const std::string& line) { std::fputs((printable(line) + '\n').c_str(), stderr); }

}  // namespace bezierbench::run
