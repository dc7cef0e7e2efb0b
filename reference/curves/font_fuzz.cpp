// SPDX-License-Identifier: MIT
// Fonts: what can be read are lines, quadratics and cubics of finite numbers, and paths are joined and closed.
#include <algorithm>
#include <cmath>

#include "experiments/fuzzing/property.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {
namespace {

void check(std::string_view contents) {
  Read font;
  try {
    font = read_font(contents, fuzzing::file_name);
  } catch (const Unreadable& refusal) {
    const std::string_view message = refusal.what();
    fuzzing::require(message.starts_with(fuzzing::file_name), "the file is named");
    fuzzing::require(message.find('\n') == std::string_view::npos, "the message is one line");
    return;
  }
  const auto same = [](auto a, auto b) { return std::ranges::equal(a, b); };
  std::size_t first = 0;
  for (std::size_t k = 0; k < font.set.size(); ++k) {
    const auto numbers = font.set[k].coefficients;
    fuzzing::require(font.set[k].degree >= 1 && font.set[k].degree <= 3, "the degree is 1, 2 or 3");
    fuzzing::require(std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }), "numbers are finite");
    if (font.set.begins_path(k))
      first = k;
    else
      fuzzing::require(same(numbers.first(2), font.set[k - 1].coefficients.last(2)), "segments are joined");
    if (k + 1 == font.set.size() || font.set.begins_path(k + 1))
      fuzzing::require(same(numbers.last(2), font.set[first].coefficients.first(2)), "a path ends where it begins");
  }
}

}  // namespace
}  // namespace bezierbench::curves

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::curves::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
