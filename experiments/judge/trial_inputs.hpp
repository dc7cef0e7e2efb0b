// SPDX-License-Identifier: MIT
// The inputs of one trial: drawn in double, then rounded to the scalar type of the methods. The truth is that of the
// rounded inputs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/sample/draw.hpp"

namespace bezierbench::judge {

/// Reusable. Views of it are valid until its next change.
template <class Scalar>
class TrialInputs {
 public:
  TrialInputs() = default;
  /// `form` is that of the drawn curves.
  TrialInputs(Form form, const sample::Cell& cell) { be_of(form, cell); }
  /// The next draws are of this cell; memory is kept.
  void be_of(Form form, const sample::Cell& cell) {
    form_ = form;
    dimension_ = cell.dimension;
    degree_ = cell.degree;
  }

  void draw(const sample::Sampler& sampler, std::uint64_t trial) {
    sampler.draw(trial, drawn_);
    round();
  }
  /// Takes given values instead of drawing them, and rounds them likewise.
  void assign(const sample::Trial& values) {
    drawn_ = values;
    round();
  }

  [[nodiscard]] CurveView<Scalar> curve() const { return {form_, dimension_, degree_, coefficients_, weights_}; }
  [[nodiscard]] Scalar t() const { return static_cast<Scalar>(drawn_.t); }
  /// The same curve and parameter in double, for the reference.
  [[nodiscard]] CurveView<double> true_curve() const {
    return {form_, dimension_, degree_, drawn_.coefficients, drawn_.weights};
  }
  [[nodiscard]] double true_t() const { return drawn_.t; }
  [[nodiscard]] const sample::Trial& values() const { return drawn_; }

 private:
  void round() {
    round(drawn_.coefficients, coefficients_);
    round(drawn_.weights, weights_);
    drawn_.t = static_cast<double>(t());
  }
  static void round(std::vector<double>& drawn, std::vector<Scalar>& rounded) {
    rounded.assign(drawn.begin(), drawn.end());
    std::copy(rounded.begin(), rounded.end(), drawn.begin());
  }

  Form form_ = Form::bernstein;
  int dimension_ = 0;
  int degree_ = 0;
  sample::Trial drawn_;
  std::vector<Scalar> coefficients_;
  std::vector<Scalar> weights_;
};

}  // namespace bezierbench::judge
