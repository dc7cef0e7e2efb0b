// SPDX-License-Identifier: MIT
// `choose --curves`: the methods ranked on given curves. Accuracy is measured on them, times come from the shipped answers or
// from a race on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/failure.hpp"

namespace bezierbench::cli {

struct CurvesWish {
  std::vector<std::string> files;  ///< or ids of shipped sets
  std::optional<double> tolerance;
  std::string tolerance_text;
  std::string unit;  ///< u, ulp, coordinate or size
  std::string mode;
  std::string scalar;
  std::optional<int> degree;  ///< of the only ranking; empty: one for each form and degree
  bool measure = false;       ///< times of now
  std::string format;
};

/// Prints one ranking for each form, dimension and degree of the curves, the most frequent non-linear one first. Returns
/// `finding` where a tolerance is given that no method keeps in one of them. Throws Failure as load_curves() does.
Exit choose_on_curves(const CurvesWish& wish);

}  // namespace bezierbench::cli
