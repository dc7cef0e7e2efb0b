// SPDX-License-Identifier: MIT
// The subcommands of `curve`: each adds its options and its action.
#pragma once

#include <string>

#include "core/curve_view.hpp"
#include "experiments/cli/command.hpp"

namespace bezierbench::cli {

/// The options of every subcommand that reads a curve.
struct CurveOptions {
  std::string file;
  std::string form = "bernstein";

  [[nodiscard]] Form form_value() const { return form == "bernstein" ? Form::bernstein : Form::power; }
  void add_to(Command command);
};

void add_curve_eval(Command curve);
void add_curve_convert(Command curve);
void add_curve_derivative(Command curve);
void add_curve_length(Command curve);
void add_curve_at_length(Command curve);
void add_curve_project(Command curve);
void add_curve_interpolate(Command curve);
void add_curve_fit(Command curve);
void add_curve_split(Command curve);
void add_curve_grid(Command curve);
void add_curve_bspline(Command curve);

}  // namespace bezierbench::cli
