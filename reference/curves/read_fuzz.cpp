// SPDX-License-Identifier: MIT
// Files of curves: one that can be read holds curves of finite numbers within the limits, and the set written as CSV
// reads back to the same bits.
#include <algorithm>
#include <cmath>

#include "experiments/fuzzing/property.hpp"
#include "reference/curves/csv.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::curves {
namespace {

void check(std::string_view text) {
  Read result;
  const bool readable = fuzzing::reads(Exit::input_output, [&] {
    try {
      result = read(text, fuzzing::file_name);
    } catch (const Unreadable& error) {
      throw Failure(Exit::input_output, error.what());
    }
  });
  if (!readable) return;
  const auto finite = [](double value) { return std::isfinite(value); };
  for (std::size_t k = 0; k < result.set.size(); ++k) {
    const auto curve = result.set[k];
    fuzzing::require(std::ranges::all_of(curve.coefficients, finite) && std::ranges::all_of(curve.weights, finite),
                     "numbers are finite");
    fuzzing::require(curve.degree >= 0 && curve.degree <= max_degree, "the degree is one");
  }
  if (result.set.empty()) return;
  const auto again = read_csv(to_csv(result.set), fuzzing::file_name, Form::bernstein).set;
  fuzzing::require(again.canonical_bytes() == result.set.canonical_bytes(), "curves read back");
}

}  // namespace
}  // namespace bezierbench::curves

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::curves::check(bezierbench::fuzzing::text_of(bytes, size));
  return 0;
}
