// SPDX-License-Identifier: MIT
// The true halves of one curve at one t, and the units in which errors of computed control points are measured: p~ and
// the proved bound of each, with Euclidean norms as magnitudes.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/subdivide/kernel.hpp"
#include "reference/companion/exact_split.hpp"

namespace bezierbench::studies {

enum class Side { left, right };
inline constexpr std::array sides{Side::left, Side::right};

/// Splits `curve` at t. `numbers` becomes the numbers of the left half, then those of the right one.
void compute_halves(const SplitKernel& method, const CurveView<double>& curve, double t, std::vector<double>& numbers);

/// The numbers that a method computed, as compute_halves writes them.
class ComputedHalves {
 public:
  ComputedHalves(const CurveView<double>& curve, std::vector<double> numbers);

  /// Control point i of a half: its coordinates and, of a rational curve, its weight.
  [[nodiscard]] std::span<const double> control(Side side, int i) const;
  [[nodiscard]] bool all_finite() const;
  /// The control points of a half as a curve, which refers to this object.
  [[nodiscard]] CurveView<double> curve(Side side) const;

 private:
  Form form_;
  int dimension_;
  int degree_;
  std::vector<double> numbers_;
  std::array<std::vector<double>, 2> points_;
  std::array<std::vector<double>, 2> weights_;
};

/// The error of one computed number or point.
struct SplitError {
  double error;    ///< for a point the Euclidean distance, rounded to 24 bits
  double error_u;  ///< over u p~; where p~ is 0: 0 for error 0, else infinite
  double bound;    ///< infinite where none is proved
  double bound_u;  ///< bound over u p~
};

class SplitTruth {
 public:
  /// The truth for a curve in Bernstein or rational form at finite t; `curve` must outlive this object.
  SplitTruth(const CurveView<double>& curve, double t);
  SplitTruth(const SplitTruth&) = delete;
  SplitTruth& operator=(const SplitTruth&) = delete;

  /// The error of the coordinates `computed` for control point `i` of a half. `bound` is the method's; nullptr if it
  /// has none.
  [[nodiscard]] SplitError point_error(const SplitBound* bound, Side side, int i,
                                       std::span<const double> computed) const;
  /// The error of the weight `computed` for control point `i` of a half of a rational curve.
  [[nodiscard]] SplitError weight_error(const SplitBound* bound, Side side, int i, double computed) const;

  /// Whether the point of each computed half at 1/2 equals the point of the curve at t/2 or (1 + t)/2, as far as the
  /// bounds of the control points allow. All points are exact. True also where no bound is proved.
  [[nodiscard]] bool middles_agree(const SplitBound* bound, const ComputedHalves& computed) const;

 private:
  /// The true control points of a half, and the quantities that their bounds multiply.
  struct Half {
    reference::ExactHalf exact;
    std::vector<std::optional<reference::Distance>> distances;  ///< distances from the exact points that exist
    std::vector<SplitScale> points;
    std::vector<SplitScale> weights;  ///< empty unless the curve is rational
  };

  void take(Side side, reference::ExactHalf exact, const reference::ExactHalf& p_tilde);
  [[nodiscard]] const Half& half(Side side) const { return halves_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] double point_bound(const SplitBound* bound, Side side, int i) const;
  [[nodiscard]] double weight_bound(const SplitBound* bound, Side side, int i) const;
  [[nodiscard]] double middle_bound(const SplitBound* bound, Side side) const;
  /// The Euclidean norm over the axes a of max |b_ja|, or of max |w_j b_ja| for a rational curve, over j from first to
  /// last.
  [[nodiscard]] double largest_point(int first, int last) const;
  [[nodiscard]] double largest_weight(int first, int last) const;

  CurveView<double> curve_;
  bool proved_;  ///< whether bounds hold: t is in [0,1] and no weight is negative
  std::array<Half, 2> halves_;
  reference::Middles middles_;
};

}  // namespace bezierbench::studies
