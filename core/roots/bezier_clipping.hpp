// SPDX-License-Identifier: MIT
// Formula: the control points (i/n, b_i) have the graph in their convex hull, which meets the axis in [t_0, t_1]: the
//   roots are there, and the rest is clipped, by de Casteljau. Where less than 20 % is clipped, the piece is halved. A
//   piece of width 2^-45 is a root; roots closer than that are one.
// Cost: a clip takes two triangles and n(n+1)/2 quotients; clips converge quadratically at a simple root.
// Bound: none.
// Fails: near a multiple root it only halves, and finds it some times or not at all, as the roundings decide; the
//   roundings of a clip may cut off a root.
#pragma once

#include <algorithm>

#include "core/roots/roots.hpp"
#include "core/roots/subdivision.hpp"

namespace bezierbench {

struct BezierClipping {
  static constexpr MethodInfo info{.id = "bezier_clipping",
                                   .label = "Bezier clipping",
                                   .problem = Problem::roots,
                                   .flops = "O(n^2) a clip",
                                   .cost_exponent = 2,
                                   .citation = "[Sederberg and Nishita 1990], section 2"};

  static FoundRoots find(const std::vector<double>& b) {
    FoundRoots found;
    search(b, 0, 1, found);
    std::ranges::sort(found.t);
    const auto is_same = [](double a, double c) { return c - a <= width_of_root; };
    found.t.erase(std::unique(found.t.begin(), found.t.end(), is_same), found.t.end());
    return found;
  }

 private:
  static constexpr double width_of_root = 0x1p-45;
  static constexpr double most_kept = 0.8;

  struct Part {
    double from = 1;
    double to = 0;
  };

  /// Where the hull of points on both sides meets the axis: the chords of all pairs are in it, its edges among them.
  static Part part_on_axis(const std::vector<double>& b) {
    const auto n = static_cast<double>(b.size() - 1);
    Part part;
    const auto include = [&](double t) {
      part.from = std::min(part.from, t);
      part.to = std::max(part.to, t);
    };
    for (std::size_t i = 0; i < b.size(); ++i) {
      const double at = static_cast<double>(i) / n;
      if (b[i] == 0) include(at);
      for (std::size_t j = i + 1; j < b.size(); ++j)
        if ((b[i] < 0 && b[j] > 0) || (b[i] > 0 && b[j] < 0))
          include(at + static_cast<double>(j - i) / n * (b[i] / (b[i] - b[j])));
    }
    return part;
  }

  /// The coefficients over [0, t], or over [t, 1] if `after`.
  static std::vector<double> piece(std::vector<double> b, double t, bool after) {
    std::vector<double> before{b[0]};
    for (std::size_t k = b.size() - 1; k > 0; --k) {
      for (std::size_t i = 0; i < k; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
      before.push_back(b[0]);
    }
    return after ? b : before;
  }

  static void search(std::vector<double> b, double low, double width, FoundRoots& found) {
    while (true) {
      if (sign_changes(b) == 0) {  // the polynomial is 0 at an end at most, or everywhere
        if (b.front() == 0) found.t.push_back(low);
        if (b.back() == 0) found.t.push_back(std::min(low + width, 1.0));
        return;
      }
      const auto [from, to] = part_on_axis(b);
      const double kept = to - from;
      if (kept * width <= width_of_root) {
        found.t.push_back(std::min(low + (from / 2 + to / 2) * width, 1.0));
        return;
      }
      if (kept > most_kept) {
        auto [left, right] = bernstein_halves(std::move(b));
        ++found.evaluations;
        search(std::move(left), low, width / 2, found);
        b = std::move(right);
        low += width / 2;
        width /= 2;
        continue;
      }
      if (to < 1) b = piece(std::move(b), to, false);
      if (from > 0) b = piece(std::move(b), from / to, true);
      found.evaluations += (to < 1 ? 1 : 0) + (from > 0 ? 1 : 0);
      low += from * width;
      width *= kept;
    }
  }
};

}  // namespace bezierbench
