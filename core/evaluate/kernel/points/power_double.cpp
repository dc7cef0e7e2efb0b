// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/points/points.hpp"

namespace bezierbench::instantiate {

template std::span<const EvaluateFor<double>> points_of_family<double, 1, Family::power>();
template std::span<const EvaluateFor<double>> points_of_family<double, 2, Family::power>();
template std::span<const EvaluateFor<double>> points_of_family<double, 3, Family::power>();

}  // namespace bezierbench::instantiate
