// SPDX-License-Identifier: MIT
// Where a study and its keys are written, so that whoever finds a fault can say it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bezierbench::suite {

/// Both count from 1.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct KeyPlace {
  Position key;
  Position value;
  std::vector<Position> elements;  ///< of a value that is an array
};

struct Places {
  std::string file;  ///< empty for a study that was not read
  Position header;   ///< of the [[study]] line
  std::map<std::string, KeyPlace, std::less<>> keys;
  std::map<std::string, std::string, std::less<>> options;  ///< by the key that the option has set: `--set degree=3`
};

}  // namespace bezierbench::suite
