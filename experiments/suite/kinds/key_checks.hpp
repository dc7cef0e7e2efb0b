// SPDX-License-Identifier: MIT
// Checks of values that keys of several kinds have; internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/fault.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

Finding check_orders(const std::vector<int>& order);
Finding check_points(const std::vector<int>& points);
Finding check_tolerances(const std::vector<double>& tolerance);
Finding check_published(const std::string& published, const Vocabulary& known);

}  // namespace bezierbench::suite
