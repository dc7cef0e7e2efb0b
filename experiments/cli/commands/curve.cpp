// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/curve/curve_commands.hpp"

namespace bezierbench::cli {

void CurveOptions::add_to(Command command) {
  command.option("--curve", file, "curve file (CSV); FILE#ID selects a curve by its id or its number from 0")
      .required()
      .takes(file_value);
  command.option("--form", form, "form of the file").one_of({"bernstein", "power"});
}

void add_curve(Command program, Exit& /*exit*/) {
  auto curve = program.command("curve", "solve one problem by any method, with its true error");
  curve.needs_command();
  add_curve_eval(curve);
  add_curve_convert(curve);
  add_curve_derivative(curve);
  add_curve_length(curve);
  add_curve_at_length(curve);
  add_curve_project(curve);
  add_curve_interpolate(curve);
  add_curve_fit(curve);
  add_curve_split(curve);
  add_curve_grid(curve);
  add_curve_bspline(curve);
}

}  // namespace bezierbench::cli
