// SPDX-License-Identifier: MIT
// The list of `curve` commands. Each is one object, in the file of its name.
#include "experiments/cli/commands/commands.hpp"
#include "experiments/cli/curve/curve_command.hpp"

namespace bezierbench::cli {

extern const CurveCommand curve_eval, curve_convert, curve_derivative, curve_length, curve_at_length, curve_project,
    curve_interpolate, curve_fit, curve_split, curve_grid, curve_bspline, curve_spaced, curve_flatten, curve_box,
    curve_ease;

void add_curve(Command program, Exit& /*exit*/) {
  auto curve = program.command("curve", "solve one problem by any method, with its true error");
  curve.needs_command();
  for (const auto* one : {&curve_eval, &curve_convert, &curve_derivative, &curve_length, &curve_at_length,
                          &curve_project, &curve_interpolate, &curve_fit, &curve_split, &curve_grid, &curve_bspline,
                          &curve_spaced, &curve_flatten, &curve_box, &curve_ease})
    one->add(curve.command(one->name, one->help));
}

}  // namespace bezierbench::cli
