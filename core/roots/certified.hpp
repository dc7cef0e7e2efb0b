// SPDX-License-Identifier: MIT
// Formula: the polynomial is halved with a bound e_i of the error of every coefficient. A coefficient with |c_i| <= e_i
//   may have any sign. A piece is dropped where no choice of these signs has a change; it has one simple root where
//   every choice has one change and both ends have certain, opposite signs. That root is bisected, and then enclosed
//   between two t at which the sign of the polynomial is certain. A piece of which no sign is certain, or of width
//   2^-52, is a cluster: it may have any number of roots, unless a wider piece around it turns out to have exactly
//   one. A coefficient 0 at an end is a root there, and is divided out.
// Source: the enclosures are derived here.
// Cost: 52 triangles a root for the bisection, some 10 for the signs, and 10 flops more in each step of a triangle.
// Bound: a step (1-t) a + t b of numbers off by e_a and e_b has the result c off by (1-t) e_a + t e_b + u (|c| + 2
//   |(1-t) a| + |t b|), the last two of them only where t is not 1/2, and 2^-1072 covers underflow. Each sum is
//   enlarged by 2^-49 for its own roundings. Descartes' rule of signs then holds for the exact polynomial.
// Fails: roots closer to each other than about (u p~ / |p^(m)|)^(1/m) are one uncertain cluster, which may have none.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/roots/roots.hpp"
#include "core/roots/subdivision.hpp"

namespace bezierbench {

struct Certified {
  static constexpr MethodInfo info{
      .id = "certified",
      .label = "Subdivision with bounds of all roundings",
      .problem = Problem::roots,
      .promise = "every root is in an enclosure, and a certain enclosure has exactly one distinct root",
      .flops = "O(n^2) a halving, 26n(n+1) a root",
      .cost_exponent = 3,
      .citation = "[Lane and Riesenfeld 1981]; [Higham 2002], section 3.3"};

  static FoundRoots find(const std::vector<double>& b) {
    Polynomial whole{b, {}};
    for (const double x : b) whole.e.push_back(of_a_sum(2 * u * std::abs(x)));
    FoundRoots found;
    const bool at_end = divide_by_zeros(whole, true);
    if (whole.c.empty()) {
      found.enclosures.push_back({0, 1, false});
      return found;
    }
    if (divide_by_zeros(whole, false)) add({0, {0, 0, true}}, found);
    search(whole, 0, 1, found);
    if (at_end) add({1, {1, 1, true}}, found);
    for (std::size_t k = 0; k < found.enclosures.size(); ++k)
      if (!found.enclosures[k].certain) look_around(whole, k, found);
    return found;
  }

 private:
  static constexpr double u = 0x1p-53;
  static constexpr double narrowest = 0x1p-52;
  static constexpr double outward = 0x1p-51;  ///< above the roundings of low + t (high - low), and of low / high

  /// Coefficients, and what they are off by at most.
  struct Polynomial {
    std::vector<double> c;
    std::vector<double> e;

    [[nodiscard]] int sign(std::size_t i) const { return std::abs(c[i]) <= e[i] ? 0 : (c[i] < 0 ? -1 : 1); }
    [[nodiscard]] bool has_certain_ends() const { return sign(0) * sign(c.size() - 1) < 0; }
  };

  struct Root {
    double t;
    RootEnclosure enclosure;
  };

  static Root middle_of_cluster(double low, double high) { return {low / 2 + high / 2, {low, high, false}}; }
  static void add(const Root& root, FoundRoots& found) {
    found.t.push_back(root.t);
    found.enclosures.push_back(root.enclosure);
  }

  /// Above the sum in spite of the roundings of the sum and of the terms.
  static double of_a_sum(double sum) { return (sum + 0x1p-1072) * (1 + 0x1p-49); }

  static std::pair<Polynomial, Polynomial> split(Polynomial p, double t) {
    const double s = 1 - t;
    const double of_products = t == 0.5 ? 0 : u;
    Polynomial left{{p.c[0]}, {p.e[0]}};
    for (std::size_t k = p.c.size() - 1; k > 0; --k) {
      for (std::size_t i = 0; i < k; ++i) {
        const double a = s * p.c[i];
        const double b = t * p.c[i + 1];
        p.c[i] = a + b;
        p.e[i] = of_a_sum(s * p.e[i] + t * p.e[i + 1] + u * std::abs(p.c[i]) +
                          of_products * (2 * std::abs(a) + std::abs(b)));
      }
      left.c.push_back(p.c[0]);
      left.e.push_back(p.e[0]);
    }
    return {std::move(left), std::move(p)};
  }

  /// Divides by t, or by 1 - t, as often as the polynomial is 0 there: q_i = c_(i+1) n / (i+1), or c_i n / (n-i).
  static bool divide_by_zeros(Polynomial& p, bool at_end) {
    bool is_root = false;
    while (!p.c.empty() && (at_end ? p.c.back() : p.c.front()) == 0) {
      is_root = true;
      const std::size_t n = p.c.size() - 1;
      for (std::size_t i = 0; i < n; ++i) {
        const double factor = static_cast<double>(n) / static_cast<double>(at_end ? n - i : i + 1);
        const std::size_t from = at_end ? i : i + 1;
        p.c[i] = factor * p.c[from];
        p.e[i] = of_a_sum(factor * p.e[from] + 2 * u * std::abs(p.c[i]));
      }
      p.c.pop_back();
      p.e.pop_back();
    }
    return is_root;
  }

  /// The largest number of changes of sign of any choice of the uncertain signs.
  static int most_changes(const Polynomial& p) {
    constexpr int impossible = -10000;
    int ends_above = 0;  // of the coefficients so far, the last sign being + or -
    int ends_below = 0;
    for (std::size_t i = 0; i < p.c.size(); ++i) {
      const int sign = p.sign(i);
      const int above = std::max(ends_above, i == 0 ? 0 : ends_below + 1);
      const int below = std::max(ends_below, i == 0 ? 0 : ends_above + 1);
      ends_above = sign < 0 ? impossible : above;
      ends_below = sign > 0 ? impossible : below;
    }
    return std::max(ends_above, ends_below);
  }

  static bool has_one_root(const Polynomial& p) { return p.has_certain_ends() && most_changes(p) == 1; }

  static void search(const Polynomial& p, double low, double width, FoundRoots& found) {
    if (most_changes(p) == 0) return;
    if (has_one_root(p)) {
      add(enclosed(p, low, low + width, found), found);
      return;
    }
    bool is_noise = true;
    for (std::size_t i = 0; i < p.c.size(); ++i) is_noise = is_noise && p.sign(i) == 0;
    if (is_noise || width <= narrowest) {
      double from = low;
      if (!found.t.empty() && !found.enclosures.back().certain && found.enclosures.back().high == low) {
        from = found.enclosures.back().low;
        found.t.pop_back();
        found.enclosures.pop_back();
      }
      add(middle_of_cluster(from, low + width), found);
      return;
    }
    const auto [left, right] = split(p, 0.5);
    ++found.evaluations;
    search(left, low, width / 2, found);
    search(right, low + width / 2, width / 2, found);
  }

  /// A narrow enclosure of the one root in (low, high), p being the coefficients there.
  static Root enclosed(const Polynomial& p, double low, double high, FoundRoots& found) {
    const double width = high - low;
    const auto middle = bisected_root(p.c, width);
    found.evaluations += middle.evaluations;
    const auto reach = [&](int direction, int sign, double end) {
      for (double step = narrowest_piece / width; step < 1; step *= 2) {
        const double t = middle.t + direction * step;
        if (!(t > 0 && t < 1)) break;
        ++found.evaluations;
        if (split(p, t).second.sign(0) == sign) return std::clamp(low + t * width + direction * outward, low, high);
      }
      return end;
    };
    const RootEnclosure enclosure{reach(-1, p.sign(0), low), reach(1, p.sign(p.c.size() - 1), high), true};
    return {std::clamp(low + middle.t * width, enclosure.low, enclosure.high), enclosure};
  }

  /// Decides a cluster by wider pieces around it, which do not reach its neighbours.
  static void look_around(const Polynomial& whole, std::size_t k, FoundRoots& found) {
    auto& cluster = found.enclosures[k];
    const double floor = k == 0 ? 0 : found.enclosures[k - 1].high / 2 + cluster.low / 2;
    const double ceiling = k + 1 == found.enclosures.size() ? 1 : found.enclosures[k + 1].low / 2 + cluster.high / 2;
    // A split at low / high is off by a rounding of the quotient: the piece must begin well before the cluster.
    constexpr double apart = 0x1p-50;
    for (double more = apart; more < 1; more *= 8) {
      const double low = std::max(cluster.low - more, floor);
      const double high = std::min(cluster.high + more, ceiling);
      if ((low > 0 && cluster.low - low < apart / 2) || (high < 1 && high <= cluster.high)) return;
      auto p = whole;
      if (high < 1) p = split(std::move(p), high).first;
      if (low > 0) p = split(std::move(p), low / high).second;
      found.evaluations += 2;
      if (!has_one_root(p)) continue;
      const auto [t, narrow] = enclosed(p, low, high, found);
      cluster = {std::max(cluster.low, narrow.low), std::min(cluster.high, narrow.high), true};
      found.t[k] = std::clamp(t, cluster.low, cluster.high);
      return;
    }
  }
};

}  // namespace bezierbench
