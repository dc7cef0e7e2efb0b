// SPDX-License-Identifier: MIT
// The values in a suite file: which studies, over which axes.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/kinds/accuracy.hpp"
#include "experiments/suite/kinds/companion/arc_length.hpp"
#include "experiments/suite/kinds/companion/bspline.hpp"
#include "experiments/suite/kinds/companion/derivative.hpp"
#include "experiments/suite/kinds/companion/fitting.hpp"
#include "experiments/suite/kinds/companion/grid.hpp"
#include "experiments/suite/kinds/companion/interpolation.hpp"
#include "experiments/suite/kinds/companion/inverse_arc_length.hpp"
#include "experiments/suite/kinds/companion/projection.hpp"
#include "experiments/suite/kinds/companion/subdivision.hpp"
#include "experiments/suite/kinds/conversion.hpp"
#include "experiments/suite/kinds/exhaustive.hpp"
#include "experiments/suite/kinds/guarantees.hpp"
#include "experiments/suite/kinds/hard_cases.hpp"
#include "experiments/suite/kinds/roofline.hpp"
#include "experiments/suite/kinds/search.hpp"
#include "experiments/suite/kinds/timing.hpp"
#include "experiments/suite/places.hpp"
#include "experiments/suite/values.hpp"

namespace bezierbench::suite {

/// The kinds of studies, each by the struct of those keys that not every kind has. This is the only list of kinds;
/// `Keys::kind()` (kinds.hpp) describes each.
using KindKeys = std::variant<AccuracyKeys, SearchKeys, ConversionKeys, TimingKeys, RooflineKeys, DerivativeKeys,
                              ArcLengthKeys, InverseArcLengthKeys, ProjectionKeys, InterpolationKeys, FittingKeys,
                              SubdivisionKeys, HardCasesKeys, GuaranteesKeys, ExhaustiveKeys, GridKeys, BsplineKeys>;

/// One [[study]] table. Axes are swept in the cross product.
struct Study {
  Places places;  ///< for messages
  std::string id;
  std::string title;
  KindKeys keys;                 ///< the kind of the study and the keys of this kind
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
};

/// Whether the study is of the kind that has these keys.
template <class Keys>
bool is_kind(const Study& study) {
  return std::holds_alternative<Keys>(study.keys);
}

/// The keys of the study's kind. Throws std::bad_variant_access for a study of another kind.
template <class Keys>
const Keys& keys_of(const Study& study) {
  return std::get<Keys>(study.keys);
}
template <class Keys>
Keys& keys_of(Study& study) {
  return std::get<Keys>(study.keys);
}

struct Suite {
  std::string id;
  std::string title;
  std::uint64_t seed = 1;
  std::vector<Study> studies;
};

}  // namespace bezierbench::suite
