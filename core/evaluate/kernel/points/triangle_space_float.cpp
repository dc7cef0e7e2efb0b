// SPDX-License-Identifier: MIT
#include "core/evaluate/kernel/points/points.hpp"

namespace bezierbench::instantiate {

template std::span<const EvaluateFor<float>> points_of_family<float, 3, Family::triangle>();

}  // namespace bezierbench::instantiate
