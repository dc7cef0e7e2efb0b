// SPDX-License-Identifier: MIT
// Keys of timing studies. The axes of the problem that is timed have the names of the keys of that problem's own kind.
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/values.hpp"

namespace bezierbench::suite {

struct Kind;

struct TimingKeys {
  std::vector<Mode> modes{Mode::one_shot, Mode::point, Mode::latency, Mode::batch};
  std::vector<int> order;         ///< orders of derivatives
  std::vector<int> points;        ///< numbers of data points, for interpolation and fitting
  std::vector<double> tolerance;  ///< for lengths, inverse lengths and fits
  std::string published;          ///< file of printed values in reference/published; may be empty

  static const Kind& kind();
};

}  // namespace bezierbench::suite
