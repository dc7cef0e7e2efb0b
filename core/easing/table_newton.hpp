// SPDX-License-Identifier: MIT
// Formula: x(k/10), k = 0..10, in float; t between the two that enclose x by the secant; from there 4 steps of Newton's
//   method where the slope is at least 0.001, else at most 10 halvings of that tenth, until |x(t) - x| <= 1e-7.
// Cost: 11 values of x(t) per curve.
// Bound: none is stated. 10 halvings leave an error of 1e-4 in t.
// Fails: y goes back, where one x is left to Newton's method and its neighbour to the halvings: at 1190 of the 2^20
//   steps of (1, 0, 0, 1), by up to 3.8e-4.
#pragma once

#include <array>
#include <cmath>

#include "core/easing/easing.hpp"

namespace bezierbench {

struct EasingTableNewton {
  static constexpr MethodInfo info{.id = "easing_table_newton",
                                   .label = "Table, then Newton or bisection",
                                   .problem = Problem::easing,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "60 with Newton, at most 80 with bisection",
                                   .citation = "[Renaudeau 2018]"};
  static constexpr int parts = 10;

  /// One coordinate, with the coefficients made as [Renaudeau 2018] makes them.
  template <class Scalar>
  struct Coordinate {
    Coordinate(Scalar p1, Scalar p2) : a(1 - 3 * p2 + 3 * p1), b(3 * p2 - 6 * p1), c(3 * p1) {}
    [[nodiscard]] Scalar at(Scalar t) const { return ((a * t + b) * t + c) * t; }
    [[nodiscard]] Scalar slope(Scalar t) const { return 3 * a * t * t + 2 * b * t + c; }
    Scalar a, b, c;
  };
  template <class Scalar>
  struct Prepared {
    Coordinate<Scalar> x, y;
    bool is_line;
    std::array<float, parts + 1> table;
  };

  template <class Scalar>
  static Prepared<Scalar> prepare(const EasingCurve<Scalar>& curve) {
    Prepared<Scalar> prepared{
        {curve.x1, curve.x2}, {curve.y1, curve.y2}, curve.x1 == curve.y1 && curve.x2 == curve.y2, {}};
    for (std::size_t k = 0; k < prepared.table.size(); ++k)
      prepared.table[k] = static_cast<float>(prepared.x.at(static_cast<Scalar>(k) * width<Scalar>));
    return prepared;
  }

  template <class Scalar>
  static Eased<Scalar> solve(const Prepared<Scalar>& curve, Scalar x) {
    if (curve.is_line || x == 0 || x == 1) return {x, x};
    Scalar start = 0;
    std::size_t k = 1;
    for (; k != parts && curve.table[k] <= x; ++k) start += width<Scalar>;
    const auto before = static_cast<Scalar>(curve.table[k - 1]);
    const auto after = static_cast<Scalar>(curve.table[k]);
    const Scalar guess = start + (x - before) / (after - before) * width<Scalar>;
    const Scalar slope = curve.x.slope(guess);
    Eased<Scalar> eased{guess};
    if (slope >= Scalar(0.001))
      newton(curve, x, eased);
    else if (slope != 0)
      bisect(curve, x, start, eased);
    eased.y = curve.y.at(eased.t);
    return eased;
  }

 private:
  template <class Scalar>
  static constexpr auto width = Scalar(0.1);

  template <class Scalar>
  static void newton(const Prepared<Scalar>& curve, Scalar x, Eased<Scalar>& eased) {
    for (; eased.steps < 4; ++eased.steps) {
      const Scalar slope = curve.x.slope(eased.t);
      if (slope == 0) return;
      eased.t -= (curve.x.at(eased.t) - x) / slope;
    }
  }

  template <class Scalar>
  static void bisect(const Prepared<Scalar>& curve, Scalar x, Scalar low, Eased<Scalar>& eased) {
    Scalar high = low + width<Scalar>;
    Scalar residual;
    do {
      eased.t = low + (high - low) / 2;
      residual = curve.x.at(eased.t) - x;
      (residual > 0 ? high : low) = eased.t;
    } while (++eased.steps < 10 && std::abs(residual) > Scalar(1e-7));
  }
};

}  // namespace bezierbench
