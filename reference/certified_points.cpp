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

constexpr int exact_binomials = 56;  ///< through this degree every C(n,i) is a double
constexpr int largest_power_degree = 128;
constexpr double largest_t = 8;
constexpr double smallest_t = 0x1p-100;  ///< below this the low part of the ratio may underflow
constexpr double smallest_magnitude = 0x1p-600;
constexpr double largest_coefficient = 0x1p+600;

struct Pair {
  double high;
  double low;
};

inline Pair normalised(Expansion2<double> sum) { return {sum.value, sum.error}; }

inline Pair product(Pair x, Pair y) {
  const auto high = two_prod(x.high, y.high);
  return normalised(fast_two_sum(high.value, high.error + fused(x.high, y.low, x.low * y.high)));
}

inline Pair sum(Pair x, Pair y) {
  const auto high = two_sum(x.high, y.high);
  return normalised(two_sum(high.value, high.error + (x.low + y.low)));
}

inline Pair quotient(Pair x, Pair y) {
  const double first = x.high / y.high;
  const double rest = (fused(-first, y.high, x.high) + x.low) - first * y.low;
  return normalised(fast_two_sum(first, rest / y.high));
}

/// The factor that the header proves, and one unit for underflow; a relative margin of 2^-20 covers the second order.
double error_factor(Form form, int n) {
  return (form == Form::bernstein ? 44.0 * n + 9 : 12.0 * n + 1) * (1 + 0x1p-20);
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

bool CertifiedPoints::applies(Form form, int degree) {
  return form == Form::bernstein ? degree <= exact_binomials : form == Form::power && degree <= largest_power_degree;
}

CertifiedPoints::CertifiedPoints(Form form, int dimension, int degree)
    : form_(form),
      dimension_(dimension),
      degree_(degree),
      binomials_(static_cast<std::size_t>(degree) + 1, 1),
      coefficients_((static_cast<std::size_t>(degree) + 1) * static_cast<std::size_t>(dimension)) {
  if (form != Form::bernstein) return;
  std::uint64_t binomial = 1;
  for (int i = 1; i <= degree; ++i) {
    binomial = binomial * static_cast<std::uint64_t>(degree - i + 1) / static_cast<std::uint64_t>(i);
    binomials_[static_cast<std::size_t>(i)] = static_cast<double>(binomial);  // below 2^53
  }
}

void CertifiedPoints::set_ratio(std::size_t lane, double t) {
  Pair ratio{t, 0};
  if (form_ == Form::bernstein) {
    const Pair s = normalised(two_sum(1.0, -t));
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
  const bool descending = form_ == Form::bernstein && t > 0.5;
  for (int i = 0; i <= degree_; ++i)
    for (int axis = 0; axis < dimension_; ++axis) {
      const double value = curve(axis, descending ? degree_ - i : i);
      moderate = moderate && std::abs(value) <= largest_coefficient;
      coefficients_[static_cast<std::size_t>(i * dimension_ + axis)][lane] = value;
    }
  unknown_[lane] = moderate ? 0 : unknown;
}

void CertifiedPoints::evaluate() {
  for (auto& axis : sums_) axis = {};
  for (auto& axis : magnitudes_) axis = {};
  for (int i = degree_; i >= 0; --i) {
    const double binomial = binomials_[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < dimension_; ++axis) {
      const Lanes& coefficient = coefficients_[static_cast<std::size_t>(i * dimension_ + axis)];
      Pairs& p = sums_[static_cast<std::size_t>(axis)];
      Lanes& magnitude = magnitudes_[static_cast<std::size_t>(axis)];
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto term = two_prod(binomial, coefficient[lane]);
        const Pair raised = product({p.high[lane], p.low[lane]}, {ratio_.high[lane], ratio_.low[lane]});
        const Pair next = sum(raised, {term.value, term.error});
        p.high[lane] = next.high;
        p.low[lane] = next.low;
        magnitude[lane] = magnitude[lane] * std::abs(ratio_.high[lane]) + std::abs(term.value);
      }
    }
  }
  if (form_ == Form::bernstein) multiply_by_power();
  finish();
}

void CertifiedPoints::multiply_by_power() {
  Pairs power;
  Pairs square = larger_;
  power.high.fill(1);
  for (int rest = degree_; rest > 0; rest /= 2) {
    const bool odd = rest % 2 == 1;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Pair base{square.high[lane], square.low[lane]};
      if (odd) {
        const Pair next = product({power.high[lane], power.low[lane]}, base);
        power.high[lane] = next.high;
        power.low[lane] = next.low;
      }
      const Pair next = product(base, base);
      square.high[lane] = next.high;
      square.low[lane] = next.low;
    }
  }
  for (int axis = 0; axis < dimension_; ++axis) {
    Pairs& p = sums_[static_cast<std::size_t>(axis)];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Pair next = product({p.high[lane], p.low[lane]}, {power.high[lane], power.low[lane]});
      p.high[lane] = next.high;
      p.low[lane] = next.low;
      magnitudes_[static_cast<std::size_t>(axis)][lane] *= std::abs(power.high[lane]);
    }
  }
}

void CertifiedPoints::finish() {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      // After products the low part is up to two ulps of the high one; a certificate has the nearest double as high
      // part.
      const auto nearest = two_sum(sums_[axis].high[lane], sums_[axis].low[lane]);
      points_.high[axis][lane] = nearest.value;
      points_.low[axis][lane] = nearest.error;
    }
  const double factor = error_factor(form_, degree_) * 0x1p-106;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const double magnitude = larger(larger(magnitudes_[0][lane], magnitudes_[1][lane]), magnitudes_[2][lane]);
    const double error = factor * (magnitude * (1 + 0x1p-40)) + unknown_[lane];
    points_.error[lane] = magnitude >= smallest_magnitude ? error : unknown;
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
