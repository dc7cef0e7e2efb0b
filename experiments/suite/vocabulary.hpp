// SPDX-License-Identifier: MIT
// The ids that a suite may name. The caller passes them in, so that this folder requires no roster.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::suite {

// What a generator can draw. A study is checked against it when it is read, before any run begins.

struct GeneratorLimits {
  bool weights = false;      ///< it draws weights, so it is for rational curves only
  bool whole_curve = false;  ///< the coefficients of a curve are drawn together, not point by point
  int bezier_degree = max_degree;
  int polynomial_degree = max_degree;
  double smallest_range = 0;
  double largest_range = 0x1p+1020;  ///< norms and second differences of points are in range
  bool finite_width = false;         ///< t_max - t_min must not overflow
  /// The coefficients are exactly those of an intended polynomial. This needs R to be a power of two and the scalar to
  /// be double.
  bool exact_coefficients = false;
};

struct Kind;

struct KnownGenerator {
  std::string id;
  GeneratorLimits limits;
};

/// A method that only some builds have.
struct AbsentMethod {
  std::string id;
  std::string remedy;  ///< how to get it
};

struct Vocabulary {
  std::span<const Kind* const> kinds;
  std::vector<std::string> methods;      ///< evaluators, paths and the methods of companion problems
  std::vector<std::string> conversions;  ///< parts of conversion chains such as `factorial+positive_sum`
  std::vector<KnownGenerator> generators;
  std::vector<std::string> published_files;  ///< names in reference/published
  std::vector<AbsentMethod> absent_methods;
};

}  // namespace bezierbench::suite
