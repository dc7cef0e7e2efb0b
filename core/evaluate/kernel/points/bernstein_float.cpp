// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/points/points.hpp"

namespace bezierbench::instantiate {

template std::span<const EvaluateFor<float>> points_of_family<float, 1, Family::bernstein>();
template std::span<const EvaluateFor<float>> points_of_family<float, 2, Family::bernstein>();
template std::span<const EvaluateFor<float>> points_of_family<float, 3, Family::bernstein>();

}  // namespace bezierbench::instantiate
