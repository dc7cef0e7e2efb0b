// SPDX-License-Identifier: MIT
// The search of all safeguarded methods: steps in an interval whose ends lie on either side of the target.
//
// A step that leaves the interval is replaced by the interval's middle. So is the step after one that did not halve the
// distance |s(t) - S|. Therefore at least every other step halves the interval or the distance. Of the length up to t
// only the part from the nearer end of the interval is integrated. The search ends where the distance with its error is
// within the tolerance, where the distance is within its own error, so that another step would be a guess, where no
// double lies inside the interval, or at the limit of iterations.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/arc_length/inverse/inverse_arc_length.hpp"

namespace bezierbench {

template <class Hodograph>
class BracketedSearch {
 public:
  static constexpr int iteration_limit = 200;

  BracketedSearch(const Hodograph& hodograph, double target, double tolerance)
      : part_(hodograph, tolerance), target_(target) {
    const auto& whole = part_.whole();
    high_ = {1, whole.length, whole.error_estimate};
    allowed_ = tolerance * (whole.length - whole.error_estimate);
  }

  /// `step(t, distance)` returns the method's next t after a t with the signed distance s(t) - S; any double, also NaN.
  template <class Step>
  InverseArcLength run(Step&& step) {
    if (target_ <= 0) return finish(low_);
    if (target_ >= high_.length) return finish(high_);
    double t = target_ / high_.length;
    double before = high_.length;
    Place best = target_ < high_.length / 2 ? low_ : high_;
    while (iterations_ < iteration_limit) {
      if (!inside(t)) t = low_.t + (high_.t - low_.t) / 2;
      if (!inside(t)) break;  // no double is left between the ends
      ++iterations_;
      const Place here = place(t);
      const double distance = here.length - target_;
      if (reached(here) < reached(best)) best = here;
      if (reached(here) <= allowed_ || std::abs(distance) <= here.uncertainty) return finish(best);
      (distance < 0 ? low_ : high_) = here;
      t = std::abs(distance) <= before / 2 ? step(t, distance) : low_.t + (high_.t - low_.t) / 2;
      before = std::abs(distance);
    }
    return finish(best);
  }

 private:
  struct Place {
    double t = 0;
    double length = 0;  ///< length up to t
    double uncertainty = 0;
  };

  [[nodiscard]] bool inside(double t) const { return t > low_.t && t < high_.t; }
  [[nodiscard]] double reached(const Place& place) const {
    return std::abs(place.length - target_) + place.uncertainty;
  }

  Place place(double t) {
    const Place& end = t - low_.t <= high_.t - t ? low_ : high_;
    const auto part = part_(end.t, t);
    return {t, end.length + part.length, end.uncertainty + part.error_estimate};
  }

  InverseArcLength finish(const Place& place) {
    return {place.t, reached(place), iterations_, part_.evaluations(), reached(place) <= allowed_};
  }

  PartLength<Hodograph> part_;
  double target_;
  double allowed_;
  Place low_;
  Place high_;
  std::int64_t iterations_ = 0;
};

}  // namespace bezierbench
