// SPDX-License-Identifier: MIT
// Curve files: one that can be read holds curves of finite numbers. Without weights they can be written, and the file
// read again gives equal curves.
#include <algorithm>
#include <cmath>

#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/fuzzing/property.hpp"

namespace bezierbench::cli {
namespace {

void check(std::string_view text, Form form) {
  std::vector<CurveFile> curves;
  if (!fuzzing::reads(Exit::input_output, [&] { curves = parse_curves(text, fuzzing::file_name, form); })) return;
  const auto finite = [](double value) { return std::isfinite(value); };
  for (const auto& curve : curves) {
    fuzzing::require(std::ranges::all_of(curve.coefficients, finite) && std::ranges::all_of(curve.weights, finite),
                     "numbers are finite");
    fuzzing::require(curve.degree() >= 0 && curve.degree() <= max_degree, "the degree is one");
  }
  if (std::ranges::any_of(curves, [](const auto& curve) { return curve.form == Form::rational; })) return;
  const auto again = parse_curves(curves_csv(curves), fuzzing::file_name, form);
  fuzzing::require(std::ranges::equal(again, curves,
                                      [](const auto& a, const auto& b) {
                                        return a.coefficients == b.coefficients && a.dimension == b.dimension;
                                      }),
                   "curves read back");
}

}  // namespace
}  // namespace bezierbench::cli

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::cli::check(bezierbench::fuzzing::text_of(bytes, size), bezierbench::Form::bernstein);
  return 0;
}
