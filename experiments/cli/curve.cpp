// SPDX-License-Identifier: MIT
#include "experiments/cli/commands.hpp"
#include "experiments/cli/curve_commands.hpp"

namespace bezierbench::cli {

void CurveOptions::add_to(CLI::App& command) {
  command.add_option("--curve", file, "curve file (CSV)")->required();
  command.add_option("--form", form, "form of the file")->check(CLI::IsMember({"bernstein", "power"}));
}

void add_curve(CLI::App& app, Exit& /*exit*/) {
  auto* curve = app.add_subcommand("curve", "one curve, any method, against the truth");
  curve->require_subcommand(1);
  add_curve_eval(*curve);
  add_curve_convert(*curve);
  add_curve_derivative(*curve);
  add_curve_length(*curve);
  add_curve_at_length(*curve);
  add_curve_project(*curve);
  add_curve_interpolate(*curve);
  add_curve_fit(*curve);
}

}  // namespace bezierbench::cli
