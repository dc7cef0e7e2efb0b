// SPDX-License-Identifier: MIT
// The values in a suite file: which studies, over which axes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/places.hpp"
#include "experiments/suite/values.hpp"

namespace bezierbench::suite {

struct Kind;

/// One [[study]] table. Axes are swept in the cross product.
struct Study {
  Places places;  ///< for messages
  std::string id;
  std::string title;
  const Kind* kind = nullptr;    ///< null only in studies that no one asks for their kind
  Form curve = Form::bernstein;  ///< the form in which random curves are drawn, one of those that are given
  std::vector<int> degree;
  std::vector<double> coordinate_range{1.0};
  std::vector<Interval> t_interval{Interval{}};
  std::vector<std::string> generator{"continuous"};  ///< default of a rational study: the first that draws weights
  std::vector<int> dimension{2};
  std::vector<ScalarKind> scalar{ScalarKind::float64};
  std::vector<std::string> methods;            ///< ids or globs as written; empty: all that apply
  std::int64_t trials = 1000;                  ///< per replicate
  std::int64_t replicates = 1;                 ///< independent repetitions, for a band
  std::vector<std::string> baseline{"exact"};  ///< what errors are measured against: `exact` or a method id

  // Keys that not every kind has; the kind's own fields (kind.hpp) say which.
  std::vector<int> order;         ///< orders of derivatives
  std::vector<int> points;        ///< numbers of data points, or of points of a grid
  std::vector<double> tolerance;  ///< relative to a length, or distances from data
  std::vector<Mode> modes{Mode::one_shot, Mode::point, Mode::latency, Mode::batch};
  std::string published;                ///< file of printed values in reference/published; may be empty
  std::int64_t decomposed_trials = 0;   ///< trials per cell whose error is split into its parts
  std::int64_t budget = 0;              ///< inputs that a search may try per cell and method
  std::int64_t kept = 8;                ///< hard cases of each family and search
  std::vector<std::string> properties;  ///< guarantees that are searched for; empty: all of them
  std::vector<std::string> curves;      ///< ids or globs of named curves
  std::vector<Goal> goals;              ///< goals that batch kernels must reach
};

struct Suite {
  std::string id;
  std::string title;
  std::uint64_t seed = 1;
  std::vector<Study> studies;
};

}  // namespace bezierbench::suite
