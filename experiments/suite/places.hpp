// SPDX-License-Identifier: MIT
// Where a study and its keys are written, for messages about faults.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bezierbench::suite {

/// A place in a file; line and column count from 1.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct KeyPlace {
  Position key;
  Position value;
  std::vector<Position> elements;  ///< for a value that is an array
};

struct Places {
  std::string file;  ///< empty for a study that was not read from a file
  Position header;   ///< place of the [[study]] line
  std::map<std::string, KeyPlace, std::less<>> keys;
  std::map<std::string, std::string, std::less<>> options;  ///< by key: the option that has set it
};

}  // namespace bezierbench::suite
