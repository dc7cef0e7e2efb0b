// SPDX-License-Identifier: MIT
// `curve convert`: the coefficients of one curve in another form.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "core/evaluate/kernel.hpp"
#include "experiments/cli/curve_commands.hpp"
#include "experiments/cli/curve_methods.hpp"
#include "experiments/cli/vocabulary.hpp"

namespace bezierbench::cli {
namespace {

struct Options {
  CurveOptions curve;
  std::vector<std::string> methods;
};

void convert(const Options& options) {
  auto curve = read_curve(options.curve.file, options.curve.form_value());
  const auto methods =
      chosen(conversion_kernels<double>(curve.dimension), options.methods, curve, vocabulary().conversions);
  std::vector<double> converted(curve.coefficients.size());
  methods.front()->convert(curve.view(), converted.data());
  curve.coefficients = converted;
  fmt::print("{}", curve_csv(curve));
}

}  // namespace

void add_curve_convert(Command curve) {
  auto options = std::make_shared<Options>();
  auto command = curve.command("convert", "coefficients in the other form");
  options->curve.add_to(command);
  command.option("--method", options->methods, "conversion id").required().once();
  command.action([options] { convert(*options); });
}

}  // namespace bezierbench::cli
