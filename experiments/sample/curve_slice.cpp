// SPDX-License-Identifier: MIT
#include "experiments/sample/curve_slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "experiments/sample/words.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::sample {
namespace {

constexpr double page = 64;  ///< in units of the largest coordinate: an em is a sixtieth of a page

/// Form, dimension and degree.
using Shape = std::tuple<Form, int, int>;

Shape shape_of(const CurveView<double>& curve) { return {curve.form, curve.dimension, curve.degree}; }

bool names(const std::vector<int>& values, int value) {
  return values.empty() || std::ranges::find(values, value) != values.end();
}

bool takes(const suite::Study& study, const CurveView<double>& curve) {
  const auto& inputs = suite::kind_of(study).inputs;
  if (study.places.keys.contains("curve") && curve.form != study.form) return false;
  return std::ranges::find(inputs.forms, curve.form) != inputs.forms.end() && curve.degree >= inputs.least_degree &&
         names(study.degree, curve.degree) && names(study.dimension, curve.dimension);
}

/// Which curves of a set are of which shape, in the order of the first ones.
std::vector<std::pair<Shape, std::vector<std::size_t>>> shapes_of(const suite::Study& study, const LoadedSet& set) {
  std::vector<std::pair<Shape, std::vector<std::size_t>>> shapes;
  const bool stored = study.parameters_from == suite::ParameterSource::stored;
  for (std::size_t k = 0; k < set.curves.size(); ++k) {
    const auto curve = set.curves[k];
    if (!takes(study, curve) || (stored && set.curves.parameters(k).empty())) continue;
    const auto shape = shape_of(curve);
    auto found = std::ranges::find(shapes, shape, [](const auto& one) { return one.first; });
    if (found == shapes.end()) found = shapes.insert(found, {shape, {}});
    found->second.push_back(k);
  }
  return shapes;
}

/// Appends points in the enlarged box of those that are there.
void add_points(Words& words, int dimension, int points, std::vector<double>& coefficients) {
  const auto d = static_cast<std::size_t>(dimension);
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  std::copy_n(coefficients.begin(), d, low.begin());
  high = low;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    low[i % d] = std::min(low[i % d], coefficients[i]);
    high[i % d] = std::max(high[i % d], coefficients[i]);
  }
  double size = 0;
  for (std::size_t axis = 0; axis < d; ++axis) size = std::max(size, high[axis] - low[axis]);
  for (std::size_t k = 0; k < d * static_cast<std::size_t>(points); ++k)
    coefficients.push_back(affine(low[k % d] - size, high[k % d] + size, words.next_uniform()));
}

}  // namespace

CurveSlice::CurveSlice(std::shared_ptr<const LoadedSet> set, std::vector<std::size_t> numbers,
                       const suite::Study& study, suite::Placement placement)
    : set_(std::move(set)), numbers_(std::move(numbers)), source_(study.parameters_from), placement_(placement) {
  std::uint64_t trials = 0;
  for (const std::size_t k : numbers_) {
    first_trials_.push_back(trials);
    trials += source_ == suite::ParameterSource::stored ? set_->curves.parameters(k).size()
                                                        : static_cast<std::uint64_t>(study.parameters);
    for (const double coordinate : set_->curves[k].coefficients)
      stored_range_ = std::max(stored_range_, std::abs(coordinate));
  }
  first_trials_.push_back(trials);
}

double CurveSlice::range() const {
  return placement_ == suite::Placement::translated ? (page + 1) * stored_range_ : stored_range_;
}

std::size_t CurveSlice::curve_of(std::uint64_t trial) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(first_trials_, trial) - first_trials_.begin()) - 1;
}

void CurveSlice::draw(std::uint64_t seed, std::uint64_t study_key, std::uint64_t cell_key, std::uint64_t trial,
                      int points, Trial& out) const {
  trial %= trials();
  const std::size_t number = curve_of(trial);
  const auto stored = curve(number);
  out.coefficients.assign(stored.coefficients.begin(), stored.coefficients.end());
  out.weights.assign(stored.weights.begin(), stored.weights.end());
  Words words_of_curve(seed, study_key, ~cell_key, number);
  place(words_of_curve, stored, out.coefficients);

  Words words(seed, study_key, cell_key, trial);
  const std::uint64_t count = first_trials_[number + 1] - first_trials_[number];
  const std::uint64_t k = trial - first_trials_[number];
  switch (source_) {
    case suite::ParameterSource::stored: out.t = set_->curves.parameters(numbers_[number])[k]; break;
    case suite::ParameterSource::grid: out.t = static_cast<double>(k) / static_cast<double>(count - 1); break;
    case suite::ParameterSource::drawn: out.t = affine(0, 1, words.next_uniform());
  }
  if (points > 0) add_points(words, stored.dimension, points, out.coefficients);
}

void CurveSlice::place(Words& words, const CurveView<double>& curve, std::vector<double>& coefficients) const {
  if (placement_ == suite::Placement::stored) return;
  if (placement_ == suite::Placement::scaled) {
    const double factor = affine(0.5, 1, words.next_uniform());
    for (double& coordinate : coefficients) coordinate *= factor;
    return;
  }
  std::array<double, 3> offset{};
  for (double& one : offset) one = affine(-page * stored_range_, page * stored_range_, words.next_uniform());
  const auto d = static_cast<std::size_t>(curve.dimension);
  const std::size_t moved = curve.form == Form::power ? d : coefficients.size();
  for (std::size_t i = 0; i < moved; ++i) coefficients[i] += offset[i % d];
}

std::string CurveSlice::canonical() const {
  const auto [form, dimension, degree] = shape_of(curve(0));
  return fmt::format("curves={};form={};dimension={};degree={};parameters={}:{};placement={}", set_->sha256, name(form),
                     dimension, degree, suite::name(source_), trials(), suite::name(placement_));
}

bool has_inputs(const suite::Study& study) {
  return std::ranges::any_of(study.sets, [&](const auto& set) { return !shapes_of(study, *set).empty(); });
}

std::vector<suite::Study> studies_of(const suite::Study& study) {
  if (!suite::has_sets(study) || suite::kind_of(study).inputs.sets == suite::SetUse::required) return {study};
  std::vector<suite::Study> all;
  for (const auto& set : study.sets)
    for (const auto& [shape, numbers] : shapes_of(study, *set))
      for (const auto placement : study.placement) {
        suite::Study& one = all.emplace_back(study);
        const auto slice = std::make_shared<CurveSlice>(set, numbers, study, placement);
        one.form = std::get<0>(shape);
        one.dimension = {std::get<1>(shape)};
        one.degree = {std::get<2>(shape)};
        one.trials = static_cast<std::int64_t>(slice->trials());
        one.replicates = 1;
        one.slice = slice;
      }
  if (all.empty())
    suite::refuse(study,
                  {"curves", 0, "kind",
                   study.parameters_from == suite::ParameterSource::stored
                       ? "no curve of the sets that the study takes has parameters, in a column t; leave "
                         "parameters_from out"
                       : "no curve of the sets has a form and degree that the kind takes and that the study names; see "
                         "`bezierbench curves FILE`"});
  for (const auto& one : all)
    if (std::ranges::find(one.scalar, suite::ScalarKind::float32) != one.scalar.end() &&
        !(one.slice->range() <= std::numeric_limits<float>::max()))
      suite::refuse(study, {"curves", 0, "scalar",
                            fmt::format("set \"{}\" has a coordinate beyond the largest float; scale it down, or leave "
                                        "float out",
                                        one.slice->set().id)});
  return all;
}

}  // namespace bezierbench::sample
