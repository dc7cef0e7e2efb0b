// SPDX-License-Identifier: MIT
// Curve files: one that can be read holds a curve of finite numbers. Without weights the curve can be written, and the
// file read again gives an equal curve.
#include <algorithm>
#include <cmath>

#include "experiments/cli/curve/curve_file.hpp"
#include "experiments/fuzzing/property.hpp"

namespace bezierbench::cli {
namespace {

void check(std::string_view text, Form form) {
  CurveFile curve;
  if (!fuzzing::reads(Exit::input_output, [&] { curve = parse_curve(text, fuzzing::file_name, form); })) return;
  const auto finite = [](double value) { return std::isfinite(value); };
  fuzzing::require(std::ranges::all_of(curve.coefficients, finite) && std::ranges::all_of(curve.weights, finite),
                   "numbers are finite");
  fuzzing::require(curve.degree() >= 0 && curve.degree() <= max_degree, "the degree is one");
  if (curve.form == Form::rational) return;
  const CurveFile again = parse_curve(curve_csv(curve), fuzzing::file_name, form);
  fuzzing::require(again.coefficients == curve.coefficients && again.dimension == curve.dimension,
                   "a curve reads back");
}

}  // namespace
}  // namespace bezierbench::cli

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  bezierbench::cli::check(bezierbench::fuzzing::text_of(bytes, size), bezierbench::Form::bernstein);
  return 0;
}
