// SPDX-License-Identifier: MIT
#include "reference/certified_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error_free.hpp"

namespace bezierbench::reference {
namespace {

constexpr double largest_t = 8;
constexpr double smallest_t = 0x1p-100;  ///< below this the low part of the ratio may underflow
constexpr double smallest_magnitude = 0x1p-600;
constexpr double largest_magnitude = 0x1p+1000;
constexpr double smallest_weight = 0x1p-400;
constexpr int weight_exponent = 200;       ///< of the largest weight
constexpr int coefficient_exponent = 600;  ///< of the largest coefficient, where the degree allows it
constexpr int term_exponent = 1000;        ///< of the largest sum of terms
constexpr double min_weight = 0x1p-40;     ///< |D'| / Q
constexpr int quotient_error = 16;         ///< its error, as pair.hpp has it

/// The factor that the header proves, and one unit for underflow; a relative margin of 2^-20 covers the second order.
double error_factor(Form form, int n) {
  const double factor = form == Form::bernstein ? 36.0 * n + 8 : form == Form::rational ? 28.0 * n + 11 : 12.0 * n + 1;
  return factor * (1 + 0x1p-20);
}

/// The sum of all C(n,i) 2^-k is this power of two.
int binomial_exponent(int n) { return n - n / 2; }

double largest_coefficient(Form form, int n) {
  if (form == Form::power) return std::ldexp(1.0, coefficient_exponent);
  const int weight_bits = form == Form::rational ? weight_exponent : 0;
  return std::ldexp(1.0, std::min(coefficient_exponent, term_exponent - weight_bits - binomial_exponent(n)));
}

bool is_moderate_weight(double weight) {
  const double size = std::abs(weight);
  return weight == 0 || (size >= smallest_weight && size <= std::ldexp(1.0, weight_exponent));
}

/// C(n,i) 2^-k for all i, each right to 4 u^2.
std::vector<Pair> scaled_binomials(int n) {
  std::vector<Pair> row;
  mpz_class binomial = 1;
  mpz_class rest;
  for (int i = 0; i <= n; ++i) {
    const double high = binomial.get_d();  // truncates towards zero, as the next one does
    rest = high;
    rest = binomial - rest;
    const Pair pair = pair_of(fast_two_sum(high, rest.get_d()));
    row.push_back({std::ldexp(pair.high, -(n / 2)), std::ldexp(pair.low, -(n / 2))});
    binomial *= n - i;
    binomial /= i + 1;
  }
  return row;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kept_bits = 24;
constexpr int dropped_bits = 53 - kept_bits;
constexpr std::uint64_t fraction = (1ULL << 52U) - 1;

/// An integer below 2^52 as a double. Vectors have no instruction for this conversion, so it uses the bits.
inline double to_double(std::uint64_t value) {
  constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;
  return std::bit_cast<double>(bits_of_2_52 | value) - 0x1p+52;
}

/// The difference of a computed coordinate and high + low on one axis, with a relative error of at most 4u: see
/// Distance.
inline double difference(double computed, double high, double low) {
  const auto top = two_sum(computed, -high);
  return top.value + (top.error - low);
}

inline double larger(double a, double b) { return a < b ? b : a; }
inline double smaller(double a, double b) { return b < a ? b : a; }

/// The length of three differences, each with an error of at most `error`, rounded to 24 bits. NaN where the interval
/// that contains the length holds numbers that round differently. There are no branches, so that compilers vectorise
/// it.
inline double certain_length(double x, double y, double z, double error) {
  const double largest = larger(larger(std::abs(x), std::abs(y)), std::abs(z));
  const double unit = std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) & ~fraction);
  const double scale = 1 / unit;
  const double scaled = std::sqrt((x * scale) * (x * scale) + (y * scale) * (y * scale) + (z * scale) * (z * scale));
  constexpr double axes = 1.75;          // the square root of three axes, rounded up
  constexpr double roundings = 0x1p-48;  // of the differences, squares, sum and root
  const double uncertainty = axes * error * scale / scaled + roundings;
  constexpr std::uint64_t mask = (1ULL << dropped_bits) - 1;
  constexpr double half = 1ULL << (dropped_bits - 1);
  const auto bits = std::bit_cast<std::uint64_t>(scaled);
  const double tail = to_double(bits & mask);  // in units of 2^-52 of the binade
  const double rounded_down = std::bit_cast<double>(bits & ~mask);
  const double rounded_up = std::bit_cast<double>((bits & ~mask) + (mask + 1));
  const double rounded = (tail > half ? rounded_up : rounded_down) * unit;
  const bool in_range = (largest >= 0x1p-900) & (largest <= 0x1p+900);
  const bool certain = (uncertainty < 0x1p-26) & (std::abs(tail - half) > uncertainty * 0x1p+53 + 1);
  return (in_range & certain) ? rounded : unknown;
}

}  // namespace

std::optional<double> CertifiedPoint::distance(std::span<const double> point) const {
  std::array<double, max_dimension> differences{};
  for (std::size_t axis = 0; axis < point.size(); ++axis)
    differences[axis] = difference(point[axis], high[axis], low[axis]);
  const double length = certain_length(differences[0], differences[1], differences[2], error);
  if (std::isnan(length)) return std::nullopt;
  return length;
}

CertifiedLanes CertifiedBlock::distances(const PointLanes& points) const {
  static_assert(max_dimension == 3);
  CertifiedLanes result;
  for (std::size_t k = 0; k < certified_lanes; ++k)
    result[k] =
        certain_length(difference(points[0][k], high[0][k], low[0][k]), difference(points[1][k], high[1][k], low[1][k]),
                       difference(points[2][k], high[2][k], low[2][k]), error[k]);
  return result;
}

CertifiedPoints::CertifiedPoints(Form form, int dimension, int degree)
    : form_(form),
      dimension_(dimension),
      degree_(degree),
      binomials_(form == Form::power ? std::vector<Pair>(static_cast<std::size_t>(degree) + 1, Pair{1, 0})
                                     : scaled_binomials(degree)),
      coefficients_(binomials_.size() * static_cast<std::size_t>(dimension)),
      weights_(form == Form::rational ? binomials_.size() : 0) {}

void CertifiedPoints::set_ratio(std::size_t lane, double t) {
  Pair ratio{t, 0};
  if (form_ != Form::power) {
    const Pair s = pair_of(two_sum(1.0, -t));
    const Pair larger = t <= 0.5 ? s : Pair{t, 0};
    ratio = quotient(t <= 0.5 ? Pair{t, 0} : s, larger);
    larger_.high[lane] = larger.high;
    larger_.low[lane] = larger.low;
  }
  ratio_.high[lane] = ratio.high;
  ratio_.low[lane] = ratio.low;
}

void CertifiedPoints::load(std::size_t lane, const CurveView<double>& curve, double t) {
  set_ratio(lane, t);
  bool moderate = std::abs(t) >= smallest_t && std::abs(t) <= largest_t;
  const double largest = largest_coefficient(form_, degree_);
  const bool descending = form_ != Form::power && t > 0.5;
  for (int i = 0; i <= degree_; ++i)
    for (int axis = 0; axis < dimension_; ++axis) {
      const double value = curve(axis, descending ? degree_ - i : i);
      moderate = moderate && std::abs(value) <= largest;
      coefficients_[static_cast<std::size_t>(i * dimension_ + axis)][lane] = value;
    }
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double weight = curve.weights[descending ? weights_.size() - 1 - i : i];
    moderate = moderate && is_moderate_weight(weight);
    weights_[i][lane] = weight;
  }
  const double growth = form_ == Form::power && std::abs(t) > 1 ? std::pow(std::abs(t), degree_) : 1;
  least_[lane] = moderate ? smallest_magnitude * growth : unknown;
}

void CertifiedPoints::evaluate() { evaluate_lanes<lanes>(); }

void CertifiedPoints::evaluate_one() {
  evaluate_lanes<lanes / 4>();
  std::fill(points_.error.begin() + 1, points_.error.end(), unknown);
}

template <std::size_t Count>
void CertifiedPoints::evaluate_lanes() {
  sum_up<Count>();
  find_magnitude<Count>();
  if (form_ == Form::bernstein) multiply_by_power<Count>();
  if (form_ == Form::rational) divide_by_weights<Count>();
  certify<Count>();
}

/// One step of Horner's scheme, sums = sums ratio + factors coefficients, in all lanes.
template <std::size_t Count>
void CertifiedPoints::add(const Lanes& coefficients, const Pairs& factors, Pairs& sums, Lanes& magnitudes) const {
  for (std::size_t lane = 0; lane < Count; ++lane) {
    const Pair term = product(Pair{factors.high[lane], factors.low[lane]}, coefficients[lane]);
    const Pair raised = product(Pair{sums.high[lane], sums.low[lane]}, Pair{ratio_.high[lane], ratio_.low[lane]});
    const Pair next = sum(raised, term);
    sums.high[lane] = next.high;
    sums.low[lane] = next.low;
    magnitudes[lane] = magnitudes[lane] * std::abs(ratio_.high[lane]) + std::abs(term.high);
  }
}

template <std::size_t Count>
void CertifiedPoints::sum_up() {
  sums_ = {};
  magnitudes_ = {};
  weight_sums_ = {};
  weight_magnitudes_ = {};
  const auto axes = static_cast<std::size_t>(dimension_);
  Lanes ones;
  ones.fill(1);
  Pairs factors;
  for (std::size_t i = binomials_.size(); i-- > 0;) {
    const Pair binomial = binomials_[i];
    if (form_ == Form::rational) {
      for (std::size_t lane = 0; lane < Count; ++lane) {
        const Pair weighted = product(binomial, weights_[i][lane]);
        factors.high[lane] = weighted.high;
        factors.low[lane] = weighted.low;
      }
      add<Count>(ones, factors, weight_sums_, weight_magnitudes_);
    } else {
      factors.high.fill(binomial.high);
      factors.low.fill(binomial.low);
    }
    for (std::size_t axis = 0; axis < axes; ++axis)
      add<Count>(coefficients_[i * axes + axis], factors, sums_[axis], magnitudes_[axis]);
  }
}

template <std::size_t Count>
void CertifiedPoints::find_magnitude() {
  for (std::size_t lane = 0; lane < Count; ++lane)
    magnitude_[lane] = larger(larger(magnitudes_[0][lane], magnitudes_[1][lane]), magnitudes_[2][lane]);
  smallest_ = magnitude_;
}

template <std::size_t Count>
void CertifiedPoints::multiply_by_power() {
  Pairs power;
  power.high.fill(1);
  if (degree_ % 2 == 1) power = larger_;
  Pairs square;
  for (std::size_t lane = 0; lane < Count; ++lane) {
    const Pair base{larger_.high[lane], larger_.low[lane]};
    const Pair next = product(base, base);
    square.high[lane] = 2 * next.high;
    square.low[lane] = 2 * next.low;
  }
  for (int rest = degree_ / 2; rest > 0; rest /= 2) {
    const bool odd = rest % 2 == 1;
    for (std::size_t lane = 0; lane < Count; ++lane) {
      const Pair base{square.high[lane], square.low[lane]};
      if (odd) {
        const Pair next = product(Pair{power.high[lane], power.low[lane]}, base);
        power.high[lane] = next.high;
        power.low[lane] = next.low;
      }
      const Pair next = product(base, base);
      square.high[lane] = next.high;
      square.low[lane] = next.low;
    }
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    Pairs& p = sums_[axis];
    for (std::size_t lane = 0; lane < Count; ++lane) {
      const Pair next = product(Pair{p.high[lane], p.low[lane]}, Pair{power.high[lane], power.low[lane]});
      p.high[lane] = next.high;
      p.low[lane] = next.low;
    }
  }
  for (std::size_t lane = 0; lane < Count; ++lane) {
    magnitude_[lane] *= std::abs(power.high[lane]);
    smallest_[lane] = smaller(smallest_[lane], magnitude_[lane]);
  }
}

template <std::size_t Count>
void CertifiedPoints::divide_by_weights() {
  Lanes largest{};  // |p'|
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
    Pairs& p = sums_[axis];
    for (std::size_t lane = 0; lane < Count; ++lane) {
      const Pair next =
          quotient(Pair{p.high[lane], p.low[lane]}, Pair{weight_sums_.high[lane], weight_sums_.low[lane]});
      p.high[lane] = next.high;
      p.low[lane] = next.low;
      largest[lane] = larger(largest[lane], std::abs(next.high));
    }
  }
  const double more = quotient_error / error_factor(form_, degree_);
  for (std::size_t lane = 0; lane < Count; ++lane) {
    const double divisor = std::abs(weight_sums_.high[lane]);
    const double weights = weight_magnitudes_[lane];
    const double magnitude = magnitude_[lane] / divisor;
    smallest_[lane] = smaller(smaller(smallest_[lane], weights), magnitude);
    smallest_[lane] = divisor >= min_weight * weights ? smallest_[lane] : 0;
    magnitude_[lane] = magnitude * (1 + more) + largest[lane] * (weights / divisor);
  }
}

template <std::size_t Count>
void CertifiedPoints::certify() {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    for (std::size_t lane = 0; lane < Count; ++lane) {
      // A certificate has the double nearest to its point as high part, also beside ties.
      const auto nearest = two_sum(sums_[axis].high[lane], sums_[axis].low[lane]);
      points_.high[axis][lane] = nearest.value;
      points_.low[axis][lane] = nearest.error;
    }
  const double factor = error_factor(form_, degree_) * 0x1p-106 * (1 + 0x1p-40);
  for (std::size_t lane = 0; lane < Count; ++lane) {
    const double magnitude = magnitude_[lane];
    const bool large_enough = smallest_[lane] >= least_[lane];
    const bool small_enough = magnitude <= largest_magnitude;
    points_.error[lane] = (large_enough & small_enough) ? factor * magnitude : unknown;
  }
}

std::optional<CertifiedPoint> CertifiedPoints::point(std::size_t lane) const {
  if (std::isnan(points_.error[lane])) return std::nullopt;
  CertifiedPoint result;
  result.dimension = dimension_;
  for (std::size_t axis = 0; axis < max_dimension; ++axis) {
    result.high[axis] = points_.high[axis][lane];
    result.low[axis] = points_.low[axis][lane];
  }
  result.error = points_.error[lane];
  return result;
}

}  // namespace bezierbench::reference
