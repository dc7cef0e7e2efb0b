// SPDX-License-Identifier: MIT
// `curve convert`: the coefficients of one curve in another form.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>

#include "core/evaluate/kernel/kernel.hpp"
#include "experiments/cli/curve/coordinate_columns.hpp"
#include "experiments/cli/curve/curve_commands.hpp"
#include "experiments/cli/curve/curve_methods.hpp"
#include "experiments/cli/startup/vocabulary.hpp"

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
                    fmt::format("--method {}: its coefficients are {}, which a curve file does not hold; see `curve "
                                "eval --method {}`, or convert with another of `list methods`",
                                id, inner_coefficients(kernel.evaluated_form), kernel.info->id));
}

/// Throws Failure for a coefficient that overflows, since the reader of curve files refuses numbers that are not
/// finite.
void require_finite(const CurveFile& converted, const ConvertOptions& options) {
  for (int i = 0; i <= converted.degree(); ++i)
    for (int axis = 0; axis < converted.dimension; ++axis)
      if (!std::isfinite(converted.view()(axis, i)))
        throw Failure(Exit::input_output,
                      fmt::format("{}: coefficient {} of axis {} is beyond the largest double after conversion by {}; "
                                  "scale the coordinates down, by a power of two to keep their digits",
                                  options.curve.file, i, axis_name(axis), options.methods.front()));
}

void convert(const ConvertOptions& options, CurveFile& curve) {
  refuse_inner_conversion(options.methods.front(), curve.dimension);
  const auto methods =
      chosen(conversion_kernels<double>(curve.dimension), options.methods, curve, vocabulary().conversions);
  std::vector<double> converted(curve.coefficients.size());
  methods.front()->convert(curve.view(), converted.data());
  curve.coefficients = converted;
  require_finite(curve, options);
}

void convert_all(const ConvertOptions& options) {
  auto curves = read_curves(options.curve.file, options.curve.form_value());
  for (auto& curve : curves) convert(options, curve);
  fmt::print("{}", curves_csv(curves));
}

}  // namespace

void add_curve_convert(Command curve) {
  auto options = std::make_shared<ConvertOptions>();
  auto command = curve.command("convert", "convert the coefficients to the other form");
  options->curve.add_to(command);
  command.option("--method", options->methods, "id of a conversion")
      .required()
      .once()
      .takes("METHOD", methods_of(Problem::conversion));
  command.action([options] { convert_all(*options); });
}

}  // namespace bezierbench::cli
