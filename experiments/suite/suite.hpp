// SPDX-License-Identifier: MIT
// What a suite file says, as values: which studies, over which axes.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::suite {

enum class Kind {
  accuracy,
  search,
  conversion,
  timing,
  roofline,
  derivative,
  arc_length,
  inverse_arc_length,
  projection,
  interpolation,
  fitting,
  subdivision
};

/// True for studies that a clock decides.
constexpr bool is_timed(Kind kind) { return kind == Kind::timing || kind == Kind::roofline; }

/// The form in which random curves are drawn.
enum class CurveKind { bezier, polynomial, rational };

enum class ScalarKind { float32, float64 };

/// What one timed call does: prepare and one point; one prepared point; a dependent chain; one curve, many t.
enum class Mode { one_shot, point, latency, batch };

struct Interval {
  double min = 0;
  double max = 1;
  friend auto operator<=>(const Interval&, const Interval&) = default;
};

/// CaseAxes of a method's batch kernel a share of the peak or the time of another method, in every row that it is
/// about.
struct Goal {
  std::string method = {};                  ///< id
  double share = 0;                         ///< of the target's peak, at least; 0: not asked
  std::string no_slower_than = {};          ///< id of a method, by its scalar kernel; empty: not asked
  ScalarKind scalar = ScalarKind::float64;  ///< of the rows, like the degrees
  int from_degree = 0;
  int to_degree = max_degree;
  bool needs_additions_beside = false;  ///< only where additions beside multiply-adds raise the peak
  friend auto operator<=>(const Goal&, const Goal&) = default;
};

/// One [[study]] table. Axes are swept in the cross product.
struct Study {
  std::string place;  ///< where it is written, FILE:LINE:COLUMN, for messages; empty where it was not read
  std::string id;
  std::string title;
  Kind kind = Kind::accuracy;
  CurveKind curve = CurveKind::bezier;
  std::vector<int> degree;
  std::vector<double> coordinate_range{1.0};
  std::vector<Interval> t_interval{Interval{}};
  std::vector<std::string> generator{"continuous"};  ///< of a rational study: the first that draws weights
  std::vector<int> dimension{2};
  std::vector<ScalarKind> scalar{ScalarKind::float64};
  std::vector<std::string> methods;            ///< ids or globs as written; empty: all that apply
  std::int64_t trials = 1000;                  ///< per replicate
  std::int64_t replicates = 1;                 ///< independent repetitions, for a band
  std::vector<std::string> baseline{"exact"};  ///< what errors are measured against: `exact` or a method id
  std::int64_t decomposed_trials = 0;          ///< accuracy only: so many trials of a cell have their error taken apart
  std::int64_t budget = 0;                     ///< search only: inputs that the climb may try per cell and method
  std::vector<Mode> modes;                     ///< timing only
  std::vector<int> order;                      ///< derivative only: of the derivatives
  std::vector<int> points;                     ///< interpolation and fitting only: number of data points
  std::vector<Goal> goals;                     ///< roofline only: what is asked of batch kernels
  std::vector<double> tolerance;  ///< where a method promises one: relative for lengths, a distance for fits
  std::string published;          ///< file of printed values in reference/published; may be empty
};

struct Suite {
  std::string id;
  std::string title;
  std::uint64_t seed = 1;
  std::vector<Study> studies;
};

}  // namespace bezierbench::suite
