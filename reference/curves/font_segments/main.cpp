// SPDX-License-Identifier: MIT
// For font_test.py: `font_segments FONT` prints a line for each segment of a font, `id begins_path x0y0x1y1...`, where
// a coordinate is the 16 hexadecimal digits of its bits, and then `left out: COUNT REASON`.
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "reference/curves/font.hpp"

int main(int argc, char** argv) {
  using namespace bezierbench::curves;
  if (argc != 2) return std::fputs("usage: font_segments FONT\n", stderr), 2;
  std::ifstream file(argv[1], std::ios::binary);
  const std::string contents{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  try {
    const Read font = read_font(contents, argv[1]);
    for (std::size_t k = 0; k < font.set.size(); ++k) {
      std::string line = fmt::format("{} {:d} ", font.set.id(k), font.set.begins_path(k));
      for (const double x : font.set[k].coefficients) line += fmt::format("{:016x}", std::bit_cast<std::uint64_t>(x));
      std::puts(line.c_str());
    }
    for (const auto& [reason, count] : font.left_out) fmt::print("left out: {} {}\n", count, reason);
  } catch (const Unreadable& wrong) {
    return fmt::print(stderr, "{}\n", wrong.what()), 4;
  }
  return 0;
}
