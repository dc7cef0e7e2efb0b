// SPDX-License-Identifier: MIT
// Formula: Simpson's 3/8 rule S = (b-a)/8 (f_0 + 3 f_1 + 3 f_2 + f_3) on a panel and on its halves, halved again until
//   both agree; then S_left + S_right + (S_left + S_right - S)/15.
// Source: [Document 000], section 3.1, eq. (13); [Davis and Rabinowitz 1984], adaptive Simpson rules. The factor 15:
//   the error falls by 16 when a panel of a smooth integrand is halved.
// Cost: 3 speeds per halving: of the 7 abscissae of two halves 4 are those of the panel.
// Bound: none is proved; there is an estimate. The seven speeds of two halves give three more integrals: S itself,
//   Simpson's 1/3 rule on thirds and the Newton-Cotes rule of seven points. The estimate is the sum of the largest
//   distance of these from S_left + S_right. It is not a fifteenth of this distance, because at a cusp the error falls
//   by 4 only. One distance alone is next to 0 by accident on one sharply bent cubic in a few thousand. The depth of
//   halving is limited, and distances of the size of rounding errors end it.
// Fails: a tolerance near u is not met in the end, for the roundings are part of the estimate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/speed.hpp"

namespace bezierbench {

struct AdaptiveSimpson38 {
  static constexpr int depth_limit = 40;

  static constexpr MethodInfo info{.id = "adaptive_simpson38",
                                   .label = "Adaptive Simpson 3/8",
                                   .problem = Problem::arc_length,
                                   .form = Form::bernstein,
                                   .promise = "the tolerance, or converged is no",
                                   .flops = "per speed (n-1)(1+3d) + 2d + 2",
                                   .citation = "[Document 000], eq. (13); [Davis and Rabinowitz 1984]"};

  template <int Dimension>
  static ArcLength measure(const Curve<Form::bernstein, double, Dimension>& hodograph, double tolerance) {
    const double rounding = rounding_of_length(hodograph, 3 * hodograph.degree() + 64);
    Search<Dimension> search{Speed<Dimension>(hodograph), rounding};
    const int panels = 2 * (hodograph.degree() + 1);
    const double width = 1.0 / panels;
    // A first length, to make the tolerance absolute; half of it, for that length may be too large.
    double first_length = 0;
    std::vector<Panel> initial;
    for (int k = 0; k < panels; ++k) {
      initial.push_back(search.panel(k * width, width));
      first_length += initial.back().integral();
    }
    const double share = tolerance * first_length / panels / 2;
    for (const Panel& panel : initial) search.refine(panel, share, 0);
    const double estimate = search.estimate + rounding;
    return {search.length, estimate, search.speed.evaluations(), estimate <= tolerance * search.length};
  }

 private:
  struct Panel {
    double begin;
    double width;
    double f0, f1, f2, f3;
    [[nodiscard]] double integral() const { return width / 8 * ((f0 + f3) + 3 * (f1 + f2)); }
  };

  template <int Dimension>
  struct Search {
    Speed<Dimension> speed;
    double rounding;  ///< of the whole length
    double length = 0;
    double estimate = 0;

    Panel panel(double begin, double width) {
      return {begin, width, speed(begin), speed(begin + width / 3), speed(begin + width * 2 / 3), speed(begin + width)};
    }

    void refine(const Panel& whole, double share, int depth) {
      const double half = whole.width / 2;
      const double middle_speed = speed(whole.begin + half);
      const Panel left{whole.begin, half, whole.f0, speed(whole.begin + half / 3), whole.f1, middle_speed};
      const Panel right{
          whole.begin + half, half, middle_speed, whole.f2, speed(whole.begin + half + half * 2 / 3), whole.f3};
      const double halves = left.integral() + right.integral();
      const double difference = halves - whole.integral();
      const double ends = left.f0 + right.f3;
      const double thirds =
          whole.width / 18 * (ends + 4 * (left.f1 + middle_speed + right.f2) + 2 * (left.f2 + right.f1));
      const double seven =
          whole.width / 840 * (41 * ends + 216 * (left.f1 + right.f2) + 27 * (left.f2 + right.f1) + 272 * middle_speed);
      const double distance = std::max({std::abs(difference), std::abs(halves - thirds), std::abs(halves - seven)});
      if (depth == depth_limit || distance <= std::max(share, whole.width * rounding)) {
        length += halves + difference / 15;
        estimate += distance;
        return;
      }
      refine(left, share / 2, depth + 1);
      refine(right, share / 2, depth + 1);
    }
  };
};

}  // namespace bezierbench
