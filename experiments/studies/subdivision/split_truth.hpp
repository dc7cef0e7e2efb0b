// SPDX-License-Identifier: MIT
// The true halves of one curve at one t, and what the errors of computed control points are compared with: p~ and the
// proved bound of each, with Euclidean norms for magnitudes.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/subdivide/kernel.hpp"
#include "reference/exact_split.hpp"

namespace bezierbench::studies {

enum class Side { left, right };
inline constexpr std::array sides{Side::left, Side::right};

/// Splits `curve` at t: the numbers of the left half, then those of the right one.
void compute_halves(const SplitKernel& method, const CurveView<double>& curve, double t, std::vector<double>& numbers);

/// The numbers that a method computed, as compute_halves writes them.
class ComputedHalves {
 public:
  ComputedHalves(const CurveView<double>& curve, std::vector<double> numbers);

  /// Control point i of a half: its coordinates and, of a rational curve, its weight.
  [[nodiscard]] std::span<const double> control(Side side, int i) const;
  [[nodiscard]] bool all_finite() const;
  /// The control points of a half as a curve; valid as long as this object.
  [[nodiscard]] CurveView<double> curve(Side side) const;

 private:
  Form form_;
  int dimension_;
  int degree_;
  std::vector<double> numbers_;
  std::array<std::vector<double>, 2> points_;
  std::array<std::vector<double>, 2> weights_;
};

/// One computed number or point against the truth.
struct SplitError {
  double error;    ///< for a point the Euclidean distance, rounded to 24 bits
  double error_u;  ///< over u p~; where p~ is 0: 0 for error 0, else infinite
  double bound;    ///< infinite where nothing is proved
  double bound_u;  ///< over u p~
};

class SplitTruth {
 public:
  /// Of a curve in Bernstein or rational form, at finite t; `curve` must outlive this object.
  SplitTruth(const CurveView<double>& curve, double t);
  SplitTruth(const SplitTruth&) = delete;
  SplitTruth& operator=(const SplitTruth&) = delete;

  /// The coordinates `computed` for control point i of a half, by a method with this bound (none: nullptr).
  [[nodiscard]] SplitError of_point(const SplitBound* bound, Side side, int i, std::span<const double> computed) const;
  /// The weight `computed` for control point i of a half of a rational curve, likewise.
  [[nodiscard]] SplitError of_weight(const SplitBound* bound, Side side, int i, double computed) const;

  /// True where points of both halves keep to those of the whole, as far as the bounds of all control points let them:
  /// the point of each computed half at 1/2 against the point of the curve at t/2 and at (1 + t)/2, all exact. Also
  /// true where no bound is proved.
  [[nodiscard]] bool middles_agree(const SplitBound* bound, const ComputedHalves& computed) const;

 private:
  /// What the bounds of the control points of a half multiply.
  struct Half {
    reference::ExactHalf exact;
    std::vector<std::optional<reference::Distance>> distances;  ///< from the exact points that exist
    std::vector<SplitScale> points;
    std::vector<SplitScale> weights;  ///< of a rational curve
  };

  void take(Side side, reference::ExactHalf exact, const reference::ExactHalf& p_tilde);
  [[nodiscard]] const Half& half(Side side) const { return halves_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] double point_bound(const SplitBound* bound, Side side, int i) const;
  [[nodiscard]] double weight_bound(const SplitBound* bound, Side side, int i) const;
  [[nodiscard]] double middle_bound(const SplitBound* bound, Side side) const;
  /// The Euclidean norm of max |b_ja|, or max |w_j b_ja|, over the axes a.
  [[nodiscard]] double largest_point(int first, int last) const;
  [[nodiscard]] double largest_weight(int first, int last) const;

  CurveView<double> curve_;
  bool proved_;  ///< t in [0,1] and weights >= 0
  std::array<Half, 2> halves_;
  reference::Middles middles_;
};

}  // namespace bezierbench::studies
