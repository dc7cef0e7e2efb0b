// SPDX-License-Identifier: MIT
#include "reference/length/speed_series.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <map>
#include <utility>

#include "reference/stop.hpp"

namespace bezierbench::reference {
namespace {

template <class Real>
struct Node {
  Real t;  ///< in [0, 1]
  Real weight;
};

/// The rule on [0, 1]: roots of the Legendre polynomial by Newton's method from cos(pi (i + 3/4)/(n + 1/2)).
std::vector<Node<LongReal>> gauss_rule(int n) {
  const LongReal pi = acos(LongReal(-1));
  std::vector<Node<LongReal>> nodes;
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

template <class Real>
Real rounded(const LongReal& x) {
  if constexpr (std::same_as<Real, LongReal>) {
    return x;
  } else {
    const auto high = x.convert_to<double>();
    return Real(pair_of(fast_two_sum(high, LongReal(x - high).convert_to<double>())));
  }
}

template <class Real>
const std::vector<Node<Real>>& rule() {
  static const auto nodes = [] {
    std::vector<Node<Real>> all;
    for (const auto& node : gauss_rule(Precision<Real>::points_of_rule))
      all.push_back({rounded<Real>(node.t), rounded<Real>(node.weight)});
    return all;
  }();
  return nodes;
}

/// The size of a vector.
template <class Real, class Coordinate>
Real size_of(std::size_t dimension, Coordinate coordinate) {
  if (dimension == 1) return abs(Real(coordinate(0)));
  Real square = 0;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const Real x = coordinate(axis);
    square += x * x;
  }
  return sqrt(square);
}

/// cos(pi i / (2 count)), i = 0 .. 4 count - 1: a turn. Kept, since cosines in 70 digits are expensive.
template <class Real>
const std::vector<Real>& cosines(std::size_t count) {
  thread_local std::map<std::size_t, std::vector<Real>> tables;
  auto& table = tables[count];
  if (!table.empty()) return table;
  const LongReal step = acos(LongReal(-1)) / (2 * count);
  table.assign(4 * count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = rounded<Real>(cos(step * i));
    table[i] = c;
    table[2 * count - i] = -c;
    table[2 * count + i] = -c;
    if (i > 0) table[4 * count - i] = c;
  }
  return table;
}

/// Values of h at t = (1 + z)/2, point by point, by nested multiplication.
template <class Real>
std::vector<Real> values_at(const Hodograph<Real>& h, const std::vector<Real>& z) {
  const std::size_t m = h.degree();
  auto scaled = h.vectors;
  Real binomial = 1;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t axis = 0; axis < h.dimension; ++axis) scaled[i * h.dimension + axis] *= binomial;
    binomial = binomial * (m - i) / (i + 1);
  }
  std::vector<Real> values;
  for (const Real& place : z) {
    StopWhen::poll();
    const Real t = (1 + place) / 2;
    const Real s = (1 - place) / 2;
    std::vector<Real> sum(scaled.begin(), scaled.begin() + static_cast<std::ptrdiff_t>(h.dimension));
    Real power = 1;
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

template <class Real>
Hodograph<Real> Hodograph<Real>::split(const Real& t) {
  Hodograph<Real> right = *this;
  const std::size_t m = degree();
  std::vector<Real> row = vectors;
  for (std::size_t level = 0; level <= m; ++level) {
    StopWhen::poll();
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      vectors[level * dimension + axis] = row[axis];
      right.vectors[(m - level) * dimension + axis] = row[(m - level) * dimension + axis];
    }
    for (std::size_t k = 0; k < (m - level) * dimension; ++k) row[k] = (1 - t) * row[k] + t * row[k + dimension];
  }
  for (std::size_t k = 0; k < weight.size(); ++k) right.weight[k] = weight[k].split(t);
  return right;
}

template <class Real>
Real Hodograph<Real>::polygon() const {
  Real sum = 0;
  for (std::size_t i = 0; i < vectors.size(); i += dimension)
    sum += size_of<Real>(dimension, [&](std::size_t axis) { return vectors[i + axis]; });
  return sum / (degree() + 1);
}

template <class Real>
Real Hodograph<Real>::chord() const {
  return size_of<Real>(dimension,
                       [&](std::size_t axis) {
                         Real sum = 0;
                         for (std::size_t i = axis; i < vectors.size(); i += dimension) sum += vectors[i];
                         return sum;
                       }) /
         (degree() + 1);
}

template <class Real>
SpeedSeries<Real>::SpeedSeries(const Hodograph<Real>& h) : dimension_(h.dimension), coefficients_(h.vectors.size(), 0) {
  const std::size_t count = h.degree() + 1;
  const auto& cosine = cosines<Real>(count);
  std::vector<Real> z;
  for (std::size_t j = 0; j < count; ++j) z.push_back(cosine[2 * j + 1]);
  const auto values = values_at(h, z);
  for (std::size_t k = 0; k < count; ++k) {
    StopWhen::poll();
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      Real& sum = coefficients_[k * dimension_ + axis];
      for (std::size_t j = 0; j < count; ++j)
        sum += values[j * dimension_ + axis] * cosine[k * (2 * j + 1) % (4 * count)];
      sum *= Real(k == 0 ? 1 : 2) / count;
    }
  }
  for (const auto& w : h.weight) weight_.emplace_back(w);
}

template <class Real>
Real SpeedSeries<Real>::speed(const Real& z) const {
  const Real twice = 2 * z;
  const Real size = size_of<Real>(dimension_, [&](std::size_t axis) {
    Real here = 0;
    Real before = 0;
    for (std::size_t k = degree(); k > 0; --k) {
      Real next = coefficients_[k * dimension_ + axis] + twice * here - before;
      before = std::move(here);
      here = std::move(next);
    }
    return Real(coefficients_[axis] + z * here - before);
  });
  if (weight_.empty()) return size;
  const Real w = weight_.front().speed(z);
  return size / (w * w);
}

template <class Real>
Real SpeedSeries<Real>::mean_speed_to(const Real& z_end) const {
  if (stays_ahead()) return chord_to(z_end);
  const Real width = z_end + 1;
  Real sum = 0;
  for (const Node<Real>& node : rule<Real>()) sum += node.weight * speed(node.t * width - 1);
  return sum;
}

template <class Real>
Real SpeedSeries<Real>::size_1(std::size_t k) const {
  Real sum = 0;
  for (std::size_t axis = 0; axis < dimension_; ++axis) sum += abs(coefficients_[k * dimension_ + axis]);
  return sum;
}

template <class Real>
Real SpeedSeries<Real>::size_of_first() const {
  return size_of<Real>(dimension_, [&](std::size_t axis) { return coefficients_[axis]; });
}

template <class Real>
Real SpeedSeries<Real>::size_of_values() const {
  Real sum = size_of_first();
  for (std::size_t k = 1; k <= degree(); ++k) sum += size_1(k);
  return sum;
}

template <class Real>
Real SpeedSeries<Real>::least_weight() const {
  const auto& w = weight_.front();
  const Real first = w.size_of_first();
  return 2 * first - w.size_of_values();
}

template <class Real>
Real SpeedSeries<Real>::largest() const {
  return change_of_speed({size_of_values(), 0});
}

/// |h| / W^2 changes by at most d / w^2 + 2 |h| e / w^3 where |h| changes by d and W by e, and both W stay above w: the
/// difference of 1 / W^2 is that of W times (1 / W + 1 / W') / (W W').
template <class Real>
Real SpeedSeries<Real>::change_of_speed(const Off& off) const {
  if (weight_.empty()) return off.vectors;
  const Real least = least_weight() - off.weight;
  if (least <= 0) return std::numeric_limits<double>::infinity();
  return (off.vectors + 2 * size_of_values() * off.weight / least) / (least * least);
}

/// A sum or a product loses at most an eighth of a unit. In Clenshaw's algorithm b_k = sum over j >= k of a_j
/// U_(j-k)(z), |U_j| <= j + 1; step k loses less than a unit of the sizes in that sum, which the steps after it raise
/// by at most |U_k|. So |a_j| counts (k + 1)(j - k + 1) times for each k <= j, together C(j+3, 3) times; half as often
/// for the error of z, since |T_j'| <= j^2. Squares and root lose half a unit.
template <class Real>
typename SpeedSeries<Real>::Off SpeedSeries<Real>::rounding_of_values() const {
  Real sum = 0;
  for (std::size_t j = 0; j <= degree(); ++j) sum += size_1(j) * ((j + 1) * (j + 2) * (j + 3) / 6);
  return {2 * sum, weight_.empty() ? Real(0) : weight_.front().rounding_of_values().vectors};
}

/// The coefficient of T_j is a sum over k >= j of at most c - j products with factors of at most 2 in size.
template <class Real>
typename SpeedSeries<Real>::Off SpeedSeries<Real>::rounding_of_halving() const {
  Real sum = 0;
  for (std::size_t k = 0; k <= degree(); ++k) sum += size_1(k) * (k + 1);
  return {sum * (degree() + 2) / 4, weight_.empty() ? Real(0) : weight_.front().rounding_of_halving().vectors};
}

template <class Real>
bool SpeedSeries<Real>::stays_ahead() const {
  if (dimension_ > 1 || !weight_.empty()) return false;
  Real others = 0;
  for (std::size_t k = 1; k <= degree(); ++k) others += size_1(k);
  return others < abs(coefficients_[0]);
}

template <class Real>
Real SpeedSeries<Real>::chord_to(const Real& z_end) const {
  std::vector<Real> t{1, z_end};  // T_k(z_end)
  while (t.size() < degree() + 3) t.push_back(2 * z_end * t.back() - t[t.size() - 2]);
  const auto since_the_beginning = [&](std::size_t k) { return Real(t[k] - (k % 2 == 0 ? 1 : -1)); };
  std::vector<Real> integral{z_end + 1, since_the_beginning(2) / 4};  // of T_k from -1
  for (std::size_t k = 2; k <= degree(); ++k)
    integral.push_back(since_the_beginning(k + 1) / (2 * (k + 1)) - since_the_beginning(k - 1) / (2 * (k - 1)));
  const Real chord = size_of<Real>(dimension_,
                                   [&](std::size_t axis) {
                                     Real sum = 0;
                                     for (std::size_t k = 0; k <= degree(); ++k)
                                       sum += coefficients_[k * dimension_ + axis] * integral[k];
                                     return sum;
                                   }) /
                     (z_end + 1);
  if (weight_.empty()) return chord;
  const Real largest_weight = weight_.front().size_of_values();
  return chord / (largest_weight * largest_weight);
}

/// Let f be analytic inside the ellipse with foci -1 and 1 whose half-axes sum to rho > 1, and |f| <= M there. With N
/// points a rule misses at most 32/15 M rho^(-2N) / (1 - rho^-2) of the mean of f (Trefethen, Approximation Theory and
/// Approximation Practice, theorem 19.3). The ellipse of a shorter part, with the same rho, lies inside that one.
///
/// Inside |T_k| <= (rho^k + rho^-k)/2. Let S be the sum of |a_k| times that, k > 0, and sqrt(2) S < |a_0|. Then h.h has
/// no root inside: at one h = x + iy with |x| = |y|, for h.h = |x|^2 - |y|^2 + 2i x.y; with g = h - a_0, of a size of
/// at most S, y = Im g, a_0 being real, and |a_0| <= |x| + |Re g| = |Im g| + |Re g| <= sqrt(2) S. So |h| = sqrt(h.h) is
/// analytic inside, and at most |a_0| + S < 2 |a_0|. Let W be at least half its first coefficient w inside, too: then
/// |h| / W^2 is analytic and at most 8 |a_0| / w^2.
template <class Real>
Real SpeedSeries<Real>::proved_miss(const Real& allowed) const {
  if (stays_ahead()) return 0;
  const Real first_vector = size_of_first();
  Real first = first_vector;  // of the speed
  if (!weight_.empty()) {
    const Real w = weight_.front().size_of_first();
    if (w == 0) return -1;
    first *= 4 / (w * w);
  }
  if (first == 0 || allowed <= 0) return -1;
  constexpr double min_rho = 1.1;
  constexpr int exponent = 2 * Precision<Real>::points_of_rule;
  constexpr double up = 1 + 1e-9;  // more than all roundings in double
  const auto wanted = Real(2 * first * Real(32) / 15 / allowed).template convert_to<double>();
  const double log_wanted = wanted > 1 ? std::log(wanted) : 0;
  const double min_fall = 1 - 1 / (min_rho * min_rho);
  const double rho = std::max(min_rho, std::exp((log_wanted - std::log(min_fall)) / exponent) * up);
  const auto others = [&](const SpeedSeries& series) {
    Real sum = 0;
    double power = 1;
    for (std::size_t k = 1; k <= series.degree(); ++k) {
      power *= rho;
      sum += series.size_1(k) * ((power + 1 / power) / 2 * up);
    }
    return sum;
  };
  const Real sum = others(*this);
  if (2 * sum * sum >= first_vector * first_vector) return -1;
  for (const auto& w : weight_)
    if (2 * others(w) > w.size_of_first()) return -1;
  return 2 * first * (up * 32.0 / 15 * std::pow(rho, -exponent) / (1 - 1 / (rho * rho)));
}

/// |h| may change the speed by half of what is allowed, and W by the other half, with a third of it to spare.
template <class Real>
typename SpeedSeries<Real>::Off SpeedSeries<Real>::shorten(const Real& allowed) {
  if (weight_.empty()) return {shorten_vectors(allowed), 0};
  const Real least = least_weight();
  if (least <= 0) return {};
  const Real of_vectors = allowed * least * least / 3;
  const Real size = size_of_values();
  const Real most = least / 8;
  Real of_weight = size > 0 ? Real(of_vectors / (2 * size) * least) : most;
  if (of_weight > most) of_weight = most;
  return {shorten_vectors(of_vectors), weight_.front().shorten_vectors(of_weight)};
}

template <class Real>
Real SpeedSeries<Real>::shorten_vectors(const Real& allowed) {
  Real cut = 0;
  while (degree() > 0) {
    const Real with_next = cut + size_1(degree());
    if (with_next > allowed) break;
    cut = with_next;
    coefficients_.resize(coefficients_.size() - dimension_);
  }
  return cut;
}

template <class Real>
SpeedSeries<Real>::Halving::Halving(std::size_t degree) : rows_((degree + 1) * (degree + 2) / 2, 0) {
  const auto at = [this](std::size_t j, std::size_t k) -> Real& { return rows_[k * (k + 1) / 2 + j]; };
  at(0, 0) = 1;
  if (degree > 0) at(0, 1) = at(1, 1) = Real(0.5);
  for (std::size_t k = 2; k <= degree; ++k)  // T_k(z) = (y + 1) T_(k-1)(z) - T_(k-2)(z) with 2 z = y + 1
    for (std::size_t j = 0; j < k; ++j) {
      const Real& term = at(j, k - 1);
      at(j, k) += term;
      at(j + 1, k) += j == 0 ? term : term / 2;
      if (j > 0) at(j - 1, k) += term / 2;
      if (j <= k - 2) at(j, k) -= at(j, k - 2);
    }
}

template <class Real>
SpeedSeries<Real> SpeedSeries<Real>::halve(const Halving& halving) {
  SpeedSeries<Real> right(dimension_);
  right.coefficients_.resize(coefficients_.size());
  for (std::size_t j = 0; j <= degree(); ++j) {
    StopWhen::poll();
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      Real even = 0;
      Real odd = 0;
      for (std::size_t k = j; k <= degree(); ++k)
        ((k - j) % 2 == 0 ? even : odd) += halving(j, k) * coefficients_[k * dimension_ + axis];
      right.coefficients_[j * dimension_ + axis] = even + odd;
      coefficients_[j * dimension_ + axis] = even - odd;  // a_j is read by no later j
    }
  }
  for (auto& w : weight_) right.weight_.push_back(w.halve(halving));
  return right;
}

template struct Hodograph<LongReal>;
template struct Hodograph<PairReal>;
template class SpeedSeries<LongReal>;
template class SpeedSeries<PairReal>;

}  // namespace bezierbench::reference
