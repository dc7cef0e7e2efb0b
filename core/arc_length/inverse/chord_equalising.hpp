// SPDX-License-Identifier: MIT
// Formula: parameters t_0 = 0 < ... < t_N = 1 with chords |C(t_k) - C(t_(k-1))| of one length. The target, as a share
//   of the chords' sum, is then a point of one of them. N is doubled until a proved error is small enough.
// Source: the document's loop for several points equalises chords, not arcs. It moves each t_k by a Newton step for the
//   sum of the chords before it, and nothing keeps the t_k in order. Here the new t_k are read off that sum, as a
//   piecewise linear function of t ([de Boor 1974]): in order on every curve, cusps included. Within its chord the
//   target's t is where the distance from the chord's beginning is the share that is left.
// Cost: N + 1 points for each round, at most 12 rounds for each N, N = 8 to 1024; the length of the curve by adaptive
//   Gauss-Legendre rules.
// Bias: an arc of length h and curvature k is longer than its chord by about k^2 h^3 / 24, so equal chords are not
//   equal arcs where the curvature varies. The bias falls by 4 when N is doubled, but by 2 only at a cusp or turn,
//   where a chord may be shorter than its arc by its own length.
// Bound: proved. The polygon from 0 to t is at most s(t), that from t to 1 at most s(1) - s(t). Roundings are added.
// Fails: it is slow, and does not meet tolerances below about 1e-6 in the end.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/arc_length/inverse/inverse_arc_length.hpp"
#include "core/arc_length/points.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

struct ChordEqualising {
  static constexpr std::size_t fewest_chords = 8;
  static constexpr std::size_t max_chords = 1024;
  static constexpr int rounds = 12;             ///< for each number of chords
  static constexpr double even = 1 + 1.0 / 64;  ///< largest ratio of the longest chord to the mean one

  static constexpr MethodInfo info{.id = "chord_equalising",
                                   .label = "Equal chords",
                                   .problem = Problem::inverse_arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, proved, or converged is no",
                                   .flops = "per point n(1+3d) + 2d + 2",
                                   .citation = "[Document 000], section 3.3; [de Boor 1974]"};

  template <int Dimension>
  static InverseArcLength solve(const Curve<Form::bernstein, double, Dimension>& hodograph, double target,
                                double tolerance) {
    const auto whole = GaussLegendreAdaptive::measure(hodograph, std::max(tolerance, finest_tolerance) / 8);
    const double share = std::clamp(target / whole.length, 0.0, 1.0);
    Polygon<Dimension> polygon(curve_of(hodograph), fewest_chords);
    InverseArcLength result;
    for (;; polygon.double_chords()) {
      result.iterations += polygon.equalise();
      const auto [t, before, behind] = polygon.place(share);
      const double latest = whole.length + whole.error_estimate - behind;  // s(t) lies between `before` and this
      result.t = t;
      result.error_estimate = std::max(std::abs(target - before), std::abs(latest - target)) + polygon.rounding();
      result.converged = result.error_estimate <= tolerance * (whole.length - whole.error_estimate);
      if (result.converged || polygon.chords() == max_chords) break;
    }
    result.evaluations = whole.evaluations + polygon.evaluations();
    return result;
  }

 private:
  /// A parameter, and the lengths of the polygon on either side of its point.
  struct Place {
    double t;
    double before;
    double behind;
  };

  template <int Dimension>
  class Polygon {
   public:
    Polygon(const Curve<Form::bernstein, double, Dimension>& curve, std::size_t chords)
        : prepared_(HornerBernstein::prepare(curve)), rounding_of_chord_(rounding_of_chord(curve)) {
      for (std::size_t k = 0; k <= chords; ++k) t_.push_back(static_cast<double>(k) / static_cast<double>(chords));
    }

    [[nodiscard]] std::size_t chords() const { return t_.size() - 1; }
    [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }
    [[nodiscard]] double rounding() const { return static_cast<double>(t_.size()) * rounding_of_chord_; }

    void double_chords() {
      std::vector<double> finer;
      for (std::size_t k = 0; k + 1 < t_.size(); ++k) finer.insert(finer.end(), {t_[k], (t_[k] + t_[k + 1]) / 2});
      finer.push_back(1);
      t_ = finer;
    }

    /// Moves the parameters until the chords are even or the rounds are used up. Returns the number of rounds.
    int equalise() {
      for (int round = 1;; ++round) {
        measure();
        if (longest_ * static_cast<double>(chords()) <= even * sum_.back() || round == rounds) return round;
        std::vector<double> moved{0};
        for (std::size_t k = 1; k < chords(); ++k)
          moved.push_back(parameter(sum_.back() * static_cast<double>(k) / static_cast<double>(chords())));
        moved.push_back(1);
        t_ = moved;
      }
    }

    Place place(double share) {
      const double length = share * sum_.back();
      const std::size_t k = chord_at(length);
      double low = share == 1 ? t_[k + 1] : t_[k];
      double high = share == 0 ? t_[k] : t_[k + 1];
      for (double t = low + (high - low) / 2; t > low && t < high; t = low + (high - low) / 2)
        (sum_[k] + (at(t) - points_[k]).norm() <= length ? low : high) = t;
      const auto point = at(low);
      return {low, sum_[k] + (point - points_[k]).norm(),
              (points_[k + 1] - point).norm() + (sum_.back() - sum_[k + 1])};
    }

   private:
    Point<double, Dimension> at(double t) {
      ++evaluations_;
      return HornerBernstein::evaluate(prepared_, t);
    }

    void measure() {
      points_.clear();
      for (const double t : t_) points_.push_back(at(t));
      sum_.assign(1, 0.0);
      longest_ = 0;
      for (std::size_t k = 0; k < chords(); ++k) {
        const double chord = (points_[k + 1] - points_[k]).norm();
        sum_.push_back(sum_[k] + chord);
        longest_ = std::max(longest_, chord);
      }
    }

    /// The index of the last chord that begins at or before this length of the polygon.
    [[nodiscard]] std::size_t chord_at(double length) const {
      const auto behind = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, length);
      return static_cast<std::size_t>(behind - sum_.begin()) - 1;
    }

    [[nodiscard]] double parameter(double length) const {
      const std::size_t k = chord_at(length);
      const double chord = sum_[k + 1] - sum_[k];
      return chord > 0 ? t_[k] + (t_[k + 1] - t_[k]) * std::min((length - sum_[k]) / chord, 1.0) : t_[k];
    }

    HornerBernstein::Prepared<double, Dimension, dynamic> prepared_;
    double rounding_of_chord_;
    std::vector<double> t_;
    std::vector<Point<double, Dimension>> points_;
    std::vector<double> sum_;  ///< for each point, the sum of the chords before it
    double longest_ = 0;
    std::int64_t evaluations_ = 0;
  };
};

}  // namespace bezierbench
