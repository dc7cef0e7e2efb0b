// SPDX-License-Identifier: MIT
#include "reference/length_panels.hpp"

#include <utility>

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

LongReal sum(const LongHodograph& h, const std::vector<Node>& rule) {
  LongReal total = 0;
  for (const Node& node : rule) total += node.weight * h.speed(node.t);
  return total;
}

}  // namespace

LongHodograph LongHodograph::split(const LongReal& t) {
  LongHodograph right = *this;
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

LongReal LongHodograph::speed(const LongReal& t) const {
  std::vector<LongReal> row = vectors;
  for (std::size_t left = row.size() - dimension; left > 0; left -= dimension)
    for (std::size_t k = 0; k < left; ++k) row[k] += t * (row[k + dimension] - row[k]);
  LongReal square = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) square += row[axis] * row[axis];
  return sqrt(square);
}

LongReal LongHodograph::polygon() const {
  LongReal sum = 0;
  for (std::size_t i = 0; i < vectors.size(); i += dimension) {
    LongReal square = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) square += vectors[i + axis] * vectors[i + axis];
    sum += sqrt(square);
  }
  return sum / (degree() + 1);
}

LongReal LongHodograph::chord() const {
  LongReal square = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    LongReal sum = 0;
    for (std::size_t i = axis; i < vectors.size(); i += dimension) sum += vectors[i];
    square += sum * sum;
  }
  return sqrt(square) / (degree() + 1);
}

bool LongHodograph::points_forward() const {
  std::vector<LongReal> mean(dimension, 0);
  for (std::size_t k = 0; k < vectors.size(); ++k) mean[k % dimension] += vectors[k];
  for (std::size_t i = 0; i < vectors.size(); i += dimension) {
    LongReal along = 0;
    for (std::size_t axis = 0; axis < dimension; ++axis) along += vectors[i + axis] * mean[axis];
    if (along < 0) return false;
  }
  return true;
}

LongReal LongHodograph::fine_sum() const {
  static const auto rule = gauss_rule(fine_points);
  return sum(*this, rule);
}

LongHodograph long_hodograph(const CurveView<double>& curve, double from, double to) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  LongHodograph h{d, {}};
  for (std::size_t k = d; k < curve.coefficients.size(); ++k)
    h.vectors.push_back(curve.degree * (LongReal(curve.coefficients[k]) - LongReal(curve.coefficients[k - d])));
  if (h.vectors.empty()) h.vectors.assign(d, 0);
  if (to < 1) h.split(to);
  if (from > 0) h = h.split(LongReal(from) / LongReal(to));
  return h;
}

LengthPanels::LengthPanels(const LongHodograph& hodograph) : negligible_(hodograph.polygon() * LongReal("1e-36")) {
  add(hodograph, 0, 1, 0);
}

void LengthPanels::add(LongHodograph h, const LongReal& begin, const LongReal& width, int depth) {
  static const auto coarse_rule = gauss_rule(coarse_points);
  const LongReal slack = width * (h.polygon() - h.chord());
  const LongReal fine = width * h.fine_sum();
  const bool flat = slack <= negligible_;
  const LongReal difference = flat ? slack : abs(fine - width * sum(h, coarse_rule));
  // A turn that is nearer to an end than every node of both rules does not show in their sums: they agree on a wrong
  // one.
  const bool certain = flat || (difference <= negligible_ && h.points_forward());
  if (certain || depth == depth_limit) {
    length_ += fine;
    uncertainty_ += certain ? difference : slack;
    panels_.push_back({begin, width, std::move(h), fine});
    return;
  }
  const LongHodograph right = h.split(LongReal(0.5));
  const LongReal half = width / 2;
  add(std::move(h), begin, half, depth + 1);
  add(right, begin + half, half, depth + 1);
}

}  // namespace bezierbench::reference
