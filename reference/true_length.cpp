// SPDX-License-Identifier: MIT
#include "reference/true_length.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace bezierbench::reference {
namespace {

constexpr int coarse_points = 30;
constexpr int fine_points = 44;
constexpr int depth_limit = 200;

struct Node {
  LongReal t;  ///< in [0, 1]
  LongReal weight;
};

/// The rule on [0, 1]: roots of the Legendre polynomial by Newton's method from cos(pi (i + 3/4)/(n + 1/2)).
std::vector<Node> gauss_rule(int n) {
  const LongReal pi = acos(LongReal(-1));
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    LongReal x = cos(pi * (i + 0.75) / (n + 0.5));
    LongReal slope;
    for (int step = 0; step < 9; ++step) {
      LongReal before = 1;
      LongReal p = x;
      for (int k = 2; k <= n; ++k) {
        const LongReal next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    nodes.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

/// Control vectors of a hodograph, point by point.
struct Hodograph {
  std::size_t dimension;
  std::vector<LongReal> vectors;

  [[nodiscard]] std::size_t degree() const { return vectors.size() / dimension - 1; }

  /// Halves or cuts: the part on [0, t] stays here, that on [t, 1] is returned.
  Hodograph split(const LongReal& t) {
    Hodograph right = *this;
    const std::size_t m = degree();
    std::vector<LongReal> row = vectors;
    for (std::size_t level = 0; level <= m; ++level) {
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        vectors[level * dimension + axis] = row[axis];
        right.vectors[(m - level) * dimension + axis] = row[(m - level) * dimension + axis];
      }
      for (std::size_t k = 0; k < (m - level) * dimension; ++k) row[k] += t * (row[k + dimension] - row[k]);
    }
    return right;
  }

  [[nodiscard]] LongReal speed(const LongReal& t) const {
    std::vector<LongReal> row = vectors;
    for (std::size_t left = row.size() - dimension; left > 0; left -= dimension)
      for (std::size_t k = 0; k < left; ++k) row[k] += t * (row[k + dimension] - row[k]);
    LongReal square = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) square += row[axis] * row[axis];
    return sqrt(square);
  }

  /// Mean size of the vectors, and the size of their mean: polygon and chord, for a parameter of width 1.
  [[nodiscard]] LongReal polygon() const {
    LongReal sum = 0;
    for (std::size_t i = 0; i < vectors.size(); i += dimension) {
      LongReal square = 0;
      for (std::size_t axis = 0; axis < dimension; ++axis) square += vectors[i + axis] * vectors[i + axis];
      sum += sqrt(square);
    }
    return sum / (degree() + 1);
  }
  [[nodiscard]] LongReal chord() const {
    LongReal square = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      LongReal sum = 0;
      for (std::size_t i = axis; i < vectors.size(); i += dimension) sum += vectors[i];
      square += sum * sum;
    }
    return sqrt(square) / (degree() + 1);
  }
};

/// Differences of the control points over [from, to], exact but for 70 digits.
Hodograph hodograph_of(const CurveView<double>& curve, double from, double to) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  Hodograph h{d, {}};
  for (std::size_t k = d; k < curve.coefficients.size(); ++k)
    h.vectors.push_back(curve.degree * (LongReal(curve.coefficients[k]) - LongReal(curve.coefficients[k - d])));
  if (h.vectors.empty()) h.vectors.assign(d, 0);
  if (to < 1) h.split(to);
  if (from > 0) h = h.split(LongReal(from) / LongReal(to));
  return h;
}

class Integral {
 public:
  explicit Integral(const Hodograph& h) : negligible_(h.polygon() * LongReal("1e-36")) { add(h, 1, 0); }

  LongReal length = 0;
  LongReal uncertainty = 0;

 private:
  void add(Hodograph h, const LongReal& width, int depth) {
    const LongReal slack = width * (h.polygon() - h.chord());
    const LongReal fine = width * sum(h, fine_rule());
    const LongReal difference = slack <= negligible_ ? slack : abs(fine - width * sum(h, coarse_rule()));
    if (difference <= negligible_ || depth == depth_limit) {
      length += fine;
      uncertainty += abs(difference);
      return;
    }
    const Hodograph right = h.split(LongReal(0.5));
    add(h, width / 2, depth + 1);
    add(right, width / 2, depth + 1);
  }

  static LongReal sum(const Hodograph& h, const std::vector<Node>& rule) {
    LongReal total = 0;
    for (const Node& node : rule) total += node.weight * h.speed(node.t);
    return total;
  }
  static const std::vector<Node>& coarse_rule() {
    static const auto rule = gauss_rule(coarse_points);
    return rule;
  }
  static const std::vector<Node>& fine_rule() {
    static const auto rule = gauss_rule(fine_points);
    return rule;
  }

  LongReal negligible_;
};

}  // namespace

TrueLength::TrueLength(const CurveView<double>& curve, double from, double to) {
  if (from == to) return;
  const Hodograph h = hodograph_of(curve, from, to);
  if (h.polygon() == 0) return;
  const Integral integral(h);
  const LongReal width = LongReal(to) - LongReal(from);
  value_ = width * integral.length;
  uncertainty_ = width * integral.uncertainty;
  if (uncertainty_ > value_ * LongReal("1e-30"))
    throw std::runtime_error("the arc length of a curve is not certain to 30 digits");
}

std::string TrueLength::decimal(int digits) const { return value_.str(digits, std::ios_base::fmtflags{}); }

double TrueLength::error_of(double length) const {
  if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
  const LongReal error = abs(LongReal(length) - value_);
  return error.convert_to<double>();
}

}  // namespace bezierbench::reference
