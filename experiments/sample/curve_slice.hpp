// SPDX-License-Identifier: MIT
// Inputs from curve sets: the curves of one form, dimension and degree of a set, each at some parameters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/sample/draw.hpp"
#include "experiments/sample/words.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/curves/curve_set.hpp"

namespace bezierbench::sample {

/// A curve set that a suite names.
struct LoadedSet {
  std::string id;      ///< in the column `curves`
  std::string sha256;  ///< of CurveSet::canonical_bytes()
  bool is_shipped = false;
  curves::CurveSet curves;
};

/// Trial k of a slice is one of its curves at one of this curve's parameters; the parameters of a curve follow each other.
class CurveSlice {
 public:
  /// Curves `numbers` of the set, which have one form, dimension and degree; at least one. `parameters` of each are drawn
  /// or on a grid, as the study says; a curve has at least one if they are stored.
  CurveSlice(std::shared_ptr<const LoadedSet> set, std::vector<std::size_t> numbers, const suite::Study& study,
             suite::Placement placement);

  [[nodiscard]] const LoadedSet& set() const { return *set_; }
  [[nodiscard]] CurveView<double> curve(std::size_t k) const { return set_->curves[numbers_[k]]; }
  [[nodiscard]] std::size_t curve_count() const { return numbers_.size(); }
  [[nodiscard]] std::string_view curve_id(std::size_t k) const { return set_->curves.id(numbers_[k]); }
  [[nodiscard]] suite::Placement placement() const { return placement_; }
  /// No coordinate has a larger magnitude.
  [[nodiscard]] double range() const;

  [[nodiscard]] std::uint64_t trials() const { return first_trials_.back(); }
  /// Which of its curves trial `trial` is of.
  [[nodiscard]] std::size_t curve_of(std::uint64_t trial) const;

  /// Writes the inputs of a trial: a pure function of the seed, the study, the cell and the trial. A drawn parameter takes
  /// the first words of the trial; the placement of a curve takes words of the curve, the same at all its parameters.
  /// `points` further points take the next words of the trial. They are uniform in the box of the control points, enlarged
  /// by the size of the curve on every side.
  void draw(std::uint64_t seed, std::uint64_t study_key, std::uint64_t cell_key, std::uint64_t trial, int points,
            Trial& out) const;

  /// The identity of the inputs, as canonical(cell) is for drawn curves.
  [[nodiscard]] std::string canonical() const;

 private:
  void place(Words& words, const CurveView<double>& curve, std::vector<double>& coefficients) const;

  std::shared_ptr<const LoadedSet> set_;
  std::vector<std::size_t> numbers_;
  std::vector<std::uint64_t> first_trials_;  ///< of each curve, and the number of all
  suite::ParameterSource source_;
  suite::Placement placement_;
  double stored_range_ = 0;  ///< the largest magnitude of a coordinate as stored
};

/// Whether the sets of the study have a curve that it takes.
bool has_inputs(const suite::Study& study);

/// The studies that a study of curve sets stands for: one for each set, form, dimension, degree and placement, in the
/// order of their first curves; the form, dimension and degree are then those of the study, the trials those of its slice.
/// Only forms and degrees that the kind takes and that the study names. Other studies stand for themselves. Throws
/// Failure(usage) where nothing is left.
std::vector<suite::Study> studies_of(const suite::Study& study);

}  // namespace bezierbench::sample
