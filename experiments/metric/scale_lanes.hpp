// SPDX-License-Identifier: MIT
// What the scales of a group of trials need, computed side by side with the operations of the scalar functions, and so
// with their bits: core/basis/amplification.hpp, TrialScale.
#pragma once

#include <bitset>
#include <cstddef>
#include <vector>

#include "core/basis/error_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/certified_points.hpp"

namespace bezierbench::metric {

/// Curves in Bernstein or power form, of one dimension and degree. Reusable; keeps its memory.
class ScaleLanes {
 public:
  using Lanes = reference::CertifiedLanes;

  void begin(int dimension, int degree);
  void load(std::size_t lane, const CurveView<double>& curve, double t);
  /// The norms of all coefficients; must be called between the last `load` and what follows.
  void take_norms();

  /// False where norms or sums may leave the range of double on the way: nothing here is known of such a lane.
  [[nodiscard]] bool is_plain(std::size_t lane) const { return plain_[lane]; }
  /// The largest norm of a coefficient.
  [[nodiscard]] double largest(std::size_t lane) const { return largest_[lane]; }

  /// amplification() of the norms; NaN for kinds that are rare, and where powers may leave the range of double on the
  /// way.
  [[nodiscard]] Lanes amplifications(Amplification kind) const;

 private:
  [[nodiscard]] Lanes bernstein_sums(const Lanes& x, const Lanes& y) const;
  [[nodiscard]] Lanes power_sums(const Lanes& x, const Lanes& y) const;

  int dimension_ = 0;
  int degree_ = 0;
  std::vector<Lanes> coefficients_;  ///< point by point
  std::vector<Lanes> norms_;
  Lanes t_{};
  Lanes largest_{};
  std::bitset<reference::certified_lanes> plain_;
};

}  // namespace bezierbench::metric
