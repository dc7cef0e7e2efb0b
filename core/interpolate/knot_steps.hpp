// SPDX-License-Identifier: MIT
// Formula: the steps between the parameters of points: h_i = |K_(i+1) - K_i|^e, where e is 0 for uniform, 1/2 for
//   centripetal and 1 for chord-length parameters.
// Source: [Lee 1989].
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace bezierbench {

/// The first is the default of commands; spline.hpp has the reason.
enum class Parameters { centripetal, uniform, chord };

inline constexpr std::array<std::string_view, 3> parameters_names{"centripetal", "uniform", "chord"};

/// The steps over the largest of them. Points are n + 1 >= 2, or n >= 2 of a closed curve, whose last step goes back to
/// the first point; `dimension` finite coordinates each. A step is 0 where points coincide, also where its length is
/// below 2^-900 of the largest. Uniform steps are 1.
std::vector<double> knot_steps(std::span<const double> points, int dimension, Parameters parameters, bool closed);

}  // namespace bezierbench
