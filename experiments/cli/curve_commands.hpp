// SPDX-License-Identifier: MIT
// The subcommands of `curve`: each adds itself and remembers what to do when it is chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/curve.hpp"
#include "experiments/failure.hpp"

namespace bezierbench::cli {

/// What every subcommand that reads a curve asks for.
struct CurveOptions {
  std::string file;
  std::string form = "bernstein";

  [[nodiscard]] Form form_value() const { return form == "bernstein" ? Form::bernstein : Form::power; }
  void add_to(CLI::App& command);
};

void add_curve_eval(CLI::App& curve);
void add_curve_convert(CLI::App& curve);
void add_curve_derivative(CLI::App& curve);
void add_curve_length(CLI::App& curve);
void add_curve_at_length(CLI::App& curve);
void add_curve_project(CLI::App& curve);
void add_curve_interpolate(CLI::App& curve);
void add_curve_fit(CLI::App& curve);

}  // namespace bezierbench::cli
