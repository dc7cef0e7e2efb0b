// SPDX-License-Identifier: MIT
#include "experiments/studies/notes.hpp"

#include <cstdio>

#include "experiments/echo.hpp"

namespace bezierbench::studies {

void note(const std::string& line) { std::fputs((printable(line) + '\n').c_str(), stderr); }

}  // namespace bezierbench::studies
