// SPDX-License-Identifier: MIT
// Formula: p(k/32), k = 0..32, by de Casteljau; where it changes its sign, Newton's method with p and p' from one
//   triangle, and the middle of the bracket where a step leaves it.
// Bound: none.
// Fails: two roots between neighbouring samples are lost, and so is every root of even multiplicity that is not a
//   sample.
#pragma once

#include "core/roots/roots.hpp"
#include "core/roots/subdivision.hpp"

namespace bezierbench {

struct SampledNewton {
  static constexpr MethodInfo info{.id = "sampled_newton",
                                   .label = "Samples, Newton's method where the sign changes",
                                   .problem = Problem::roots,
                                   .flops = "50n(n+1), and 9n(n+1) a root",
                                   .cost_exponent = 2,
                                   .citation = "[Press et al. 2007], sections 9.1 and 9.4"};

  static FoundRoots find(const std::vector<double>& b) {
    constexpr int parts = 32;
    FoundRoots found;
    double before = b.front();
    if (before == 0) found.t.push_back(0);
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const double value = k == parts ? b.back() : bernstein_value(b, t);
      ++found.evaluations;
      if (value == 0)
        found.t.push_back(t);
      else if (before != 0 && (before < 0) != (value < 0))
        found.t.push_back(bracketed(b, t - 1.0 / parts, t, before < 0, found.evaluations));
      before = value;
    }
    return found;
  }

 private:
  static double bracketed(const std::vector<double>& b, double from, double to, bool rises, std::int64_t& evaluations) {
    constexpr int most_steps = 60;  // enough for bisection alone
    const auto n = static_cast<double>(b.size() - 1);
    double t = from / 2 + to / 2;
    for (int step = 0; step < most_steps; ++step) {
      auto c = b;
      for (std::size_t k = c.size() - 1; k > 1; --k)
        for (std::size_t i = 0; i < k; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
      const double value = (1 - t) * c[0] + t * c[1];
      ++evaluations;
      if (value == 0) return t;
      ((value < 0) == rises ? from : to) = t;
      double next = t - value / (n * (c[1] - c[0]));
      if (!(next > from && next < to)) next = from / 2 + to / 2;
      if (next - t <= narrowest_piece && t - next <= narrowest_piece) return next;
      t = next;
    }
    return t;
  }
};

}  // namespace bezierbench
