// SPDX-License-Identifier: MIT
// `curve convert`: the coefficients of one curve in another form.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/cli/curve/curve_command.hpp"

namespace bezierbench::cli {
namespace {

struct ConvertOptions {
  CurveOptions curve;
  std::vector<std::string> methods;
};

/// The coefficients of a form that no curve file can hold and that only paths use, in words.
std::string_view inner_coefficients(Form form) {
  return form == Form::power_centered ? "those of powers of t - 1/2" : "pairs of doubles";
}

void refuse_inner_conversion(const std::string& id, int dimension) {
  for (const auto& kernel : kernels<double>(dimension))
    if (kernel.info->id.starts_with(id + ":") && kernel.evaluated_form != Form::power &&
        kernel.evaluated_form != Form::bernstein)
      throw Failure(Exit::usage,
                    "--method {}: its coefficients are {}, which a curve file does not hold; see `curve eval --method "
                    "{}`, or convert with another of `list methods`",
                    id, inner_coefficients(kernel.evaluated_form), kernel.info->id);
}

/// Throws Failure for a coefficient that overflows, since the reader of curve files refuses numbers that are not
/// finite.
void convert(const ConvertOptions& options, CurveFile& curve) {
  const auto& method = options.methods.front();
  refuse_inner_conversion(method, curve.dimension);
  const auto chosen_methods =
      chosen(conversion_kernels<double>(curve.dimension), options.methods, curve, Problem::conversion);
  std::vector<double> converted(curve.coefficients.size());
  chosen_methods.front()->convert(curve.view(), converted.data());
  const auto beyond = std::ranges::find_if(converted, [](double value) { return !std::isfinite(value); });
  if (beyond != converted.end()) {
    const auto place = static_cast<int>(beyond - converted.begin());
    throw Failure(Exit::input_output,
                  "{}: coefficient {} of axis {} is beyond the largest double after conversion by {}; scale the "
                  "coordinates down, by a power of two to keep their digits",
                  options.curve.name(), place / curve.dimension, axis_name(place % curve.dimension), method);
  }
  curve.coefficients = converted;
}

void add_convert(Command command) {
  auto options = std::make_shared<ConvertOptions>();
  options->curve.add_to(command);
  command.option("--method", options->methods, "id of a conversion")
      .required()
      .once()
      .takes("METHOD", methods_of(Problem::conversion));
  command.action([options] {
    auto curves = options->curve.read();
    for (auto& curve : curves) convert(*options, curve);
    fmt::print("{}", curves_csv(curves));
  });
}

}  // namespace

extern constexpr CurveCommand curve_convert{"convert", "convert the coefficients to the other form", add_convert};

}  // namespace bezierbench::cli
