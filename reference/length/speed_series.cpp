// SPDX-License-Identifier: MIT
#include "reference/length/speed_series.hpp"

#include <algorithm>
#include <utility>

namespace bezierbench::reference {
namespace {

constexpr int points_of_rule = 44;

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

/// The size of a vector.
template <class Coordinate>
LongReal size_of(std::size_t dimension, Coordinate coordinate) {
  LongReal square = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const LongReal x = coordinate(axis);
    square += x * x;
  }
  return sqrt(square);
}

/// cos(pi i / (2 count)), i = 0 .. 4 count - 1: a turn.
std::vector<LongReal> cosines(std::size_t count) {
  const LongReal step = acos(LongReal(-1)) / (2 * count);
  std::vector<LongReal> table(4 * count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const LongReal c = cos(step * i);
    table[i] = c;
    table[2 * count - i] = -c;
    table[2 * count + i] = -c;
    if (i > 0) table[4 * count - i] = c;
  }
  return table;
}

/// Values of h at t = (1 + z)/2, point by point, by nested multiplication.
std::vector<LongReal> values_at(const LongHodograph& h, const std::vector<LongReal>& z) {
  const std::size_t m = h.degree();
  auto scaled = h.vectors;
  LongReal binomial = 1;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t axis = 0; axis < h.dimension; ++axis) scaled[i * h.dimension + axis] *= binomial;
    binomial = binomial * (m - i) / (i + 1);
  }
  std::vector<LongReal> values;
  for (const LongReal& place : z) {
    const LongReal t = (1 + place) / 2;
    const LongReal s = (1 - place) / 2;
    std::vector<LongReal> sum(scaled.begin(), scaled.begin() + static_cast<std::ptrdiff_t>(h.dimension));
    LongReal power = 1;
    for (std::size_t i = 1; i <= m; ++i) {
      power *= t;
      for (std::size_t axis = 0; axis < h.dimension; ++axis)
        sum[axis] = sum[axis] * s + power * scaled[i * h.dimension + axis];
    }
    values.insert(values.end(), sum.begin(), sum.end());
  }
  return values;
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
    for (std::size_t k = 0; k < (m - level) * dimension; ++k) row[k] = (1 - t) * row[k] + t * row[k + dimension];
  }
  return right;
}

LongReal LongHodograph::polygon() const {
  LongReal sum = 0;
  for (std::size_t i = 0; i < vectors.size(); i += dimension)
    sum += size_of(dimension, [&](std::size_t axis) { return vectors[i + axis]; });
  return sum / (degree() + 1);
}

LongReal LongHodograph::chord() const {
  return size_of(dimension,
                 [&](std::size_t axis) {
                   LongReal sum = 0;
                   for (std::size_t i = axis; i < vectors.size(); i += dimension) sum += vectors[i];
                   return sum;
                 }) /
         (degree() + 1);
}

SpeedSeries::SpeedSeries(const LongHodograph& h) : dimension_(h.dimension), coefficients_(h.vectors.size(), 0) {
  const std::size_t count = h.degree() + 1;
  const auto cosine = cosines(count);
  std::vector<LongReal> z;
  for (std::size_t j = 0; j < count; ++j) z.push_back(cosine[2 * j + 1]);
  const auto values = values_at(h, z);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      LongReal& sum = coefficients_[k * dimension_ + axis];
      for (std::size_t j = 0; j < count; ++j)
        sum += values[j * dimension_ + axis] * cosine[k * (2 * j + 1) % (4 * count)];
      sum *= LongReal(k == 0 ? 1 : 2) / count;
    }
}

LongReal SpeedSeries::speed(const LongReal& z) const {
  const LongReal twice = 2 * z;
  return size_of(dimension_, [&](std::size_t axis) {
    LongReal here = 0;
    LongReal before = 0;
    for (std::size_t k = degree(); k > 0; --k) {
      LongReal next = coefficients_[k * dimension_ + axis] + twice * here - before;
      before = std::move(here);
      here = std::move(next);
    }
    return LongReal(coefficients_[axis] + z * here - before);
  });
}

LongReal SpeedSeries::mean_speed_to(const LongReal& z_end) const {
  if (stays_ahead()) return chord_to(z_end);
  static const auto rule = gauss_rule(points_of_rule);
  const LongReal width = z_end + 1;
  LongReal sum = 0;
  for (const Node& node : rule) sum += node.weight * speed(node.t * width - 1);
  return sum;
}

LongReal SpeedSeries::size_1(std::size_t k) const {
  LongReal sum = 0;
  for (std::size_t axis = 0; axis < dimension_; ++axis) sum += abs(coefficients_[k * dimension_ + axis]);
  return sum;
}

LongReal SpeedSeries::largest() const {
  LongReal sum = size_of(dimension_, [&](std::size_t axis) { return coefficients_[axis]; });
  for (std::size_t k = 1; k <= degree(); ++k) sum += size_1(k);
  return sum;
}

bool SpeedSeries::stays_ahead() const {
  if (dimension_ > 1) return false;
  LongReal others = 0;
  for (std::size_t k = 1; k <= degree(); ++k) others += size_1(k);
  return others < abs(coefficients_[0]);
}

LongReal SpeedSeries::chord_to(const LongReal& z_end) const {
  std::vector<LongReal> t{1, z_end};  // T_k(z_end)
  while (t.size() < degree() + 3) t.push_back(2 * z_end * t.back() - t[t.size() - 2]);
  const auto since_the_beginning = [&](std::size_t k) { return LongReal(t[k] - (k % 2 == 0 ? 1 : -1)); };
  std::vector<LongReal> integral{z_end + 1, since_the_beginning(2) / 4};  // of T_k from -1
  for (std::size_t k = 2; k <= degree(); ++k)
    integral.push_back(since_the_beginning(k + 1) / (2 * (k + 1)) - since_the_beginning(k - 1) / (2 * (k - 1)));
  return size_of(dimension_,
                 [&](std::size_t axis) {
                   LongReal sum = 0;
                   for (std::size_t k = 0; k <= degree(); ++k)
                     sum += coefficients_[k * dimension_ + axis] * integral[k];
                   return sum;
                 }) /
         (z_end + 1);
}

/// Let f be analytic inside the ellipse with foci -1 and 1 whose half-axes sum to rho > 1, and |f| <= M there. With N
/// points a rule misses at most 32/15 M rho^(-2N) / (1 - rho^-2) of the mean of f (Trefethen, Approximation Theory and
/// Approximation Practice, theorem 19.3). The ellipse of a shorter part, with the same rho, lies inside that one.
///
/// Inside |T_k| <= (rho^k + rho^-k)/2. Let S be the sum of |a_k| times that, k > 0, and sqrt(2) S < |a_0|. Then h.h has
/// no root inside: at one h = x + iy with |x| = |y|, for h.h = |x|^2 - |y|^2 + 2i x.y; with g = h - a_0, of a size of
/// at most S, y = Im g, a_0 being real, and |a_0| <= |x| + |Re g| = |Im g| + |Re g| <= sqrt(2) S. So |h| = sqrt(h.h) is
/// analytic inside, and at most |a_0| + S < 2 |a_0|.
LongReal SpeedSeries::proved_miss(const LongReal& allowed) const {
  if (stays_ahead()) return 0;
  const LongReal first = size_of(dimension_, [&](std::size_t axis) { return coefficients_[axis]; });
  if (first == 0 || allowed <= 0) return -1;
  constexpr double least_rho = 1.1;
  const LongReal wanted = 2 * first * LongReal(32) / 15 / allowed;
  const double log_wanted = wanted > 1 ? log(wanted).convert_to<double>() : 0;
  const double fall = 1 - 1 / (least_rho * least_rho);
  const LongReal rho = std::max(least_rho, std::exp((log_wanted - std::log(fall)) / (2 * points_of_rule)) * (1 + 1e-9));
  LongReal sum = 0;
  LongReal power = 1;
  for (std::size_t k = 1; k <= degree(); ++k) {
    power *= rho;
    sum += size_1(k) * (power + 1 / power) / 2;
  }
  if (2 * sum * sum >= first * first * (1 - LongReal("1e-30"))) return -1;
  const LongReal inverse = 1 / (rho * rho);
  return 2 * first * LongReal(32) / 15 * pow(inverse, points_of_rule) / (1 - inverse);
}

LongReal SpeedSeries::shorten(const LongReal& allowed) {
  LongReal cut = 0;
  while (degree() > 0) {
    const LongReal with_next = cut + size_1(degree());
    if (with_next > allowed) break;
    cut = with_next;
    coefficients_.resize(coefficients_.size() - dimension_);
  }
  return cut;
}

SpeedSeries::Halving::Halving(std::size_t degree) : rows_((degree + 1) * (degree + 2) / 2, 0) {
  const auto at = [this](std::size_t j, std::size_t k) -> LongReal& { return rows_[k * (k + 1) / 2 + j]; };
  at(0, 0) = 1;
  if (degree > 0) at(0, 1) = at(1, 1) = LongReal(0.5);
  for (std::size_t k = 2; k <= degree; ++k)  // T_k(z) = (y + 1) T_(k-1)(z) - T_(k-2)(z) with 2 z = y + 1
    for (std::size_t j = 0; j < k; ++j) {
      const LongReal& term = at(j, k - 1);
      at(j, k) += term;
      at(j + 1, k) += j == 0 ? term : term / 2;
      if (j > 0) at(j - 1, k) += term / 2;
      if (j <= k - 2) at(j, k) -= at(j, k - 2);
    }
}

SpeedSeries SpeedSeries::halve(const Halving& halving) {
  SpeedSeries right(dimension_);
  right.coefficients_.resize(coefficients_.size());
  for (std::size_t j = 0; j <= degree(); ++j)
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      LongReal even = 0;
      LongReal odd = 0;
      for (std::size_t k = j; k <= degree(); ++k)
        ((k - j) % 2 == 0 ? even : odd) += halving(j, k) * coefficients_[k * dimension_ + axis];
      right.coefficients_[j * dimension_ + axis] = even + odd;
      coefficients_[j * dimension_ + axis] = even - odd;  // a_j is read by no later j
    }
  return right;
}

}  // namespace bezierbench::reference
