// SPDX-License-Identifier: MIT
#include "reference/exact_point.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error_free.hpp"

namespace bezierbench::reference {
namespace {

constexpr int expansion_bits = 3 * 53;

/// floor(log2 |x|) of a normal number, read from its bits.
int floor_log2(double x) { return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52U) & 0x7ffU) - 1023; }

/// 2^e for -1022 <= e <= 1023.
double power_of_two(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52U); }

constexpr int safe_exponent = 900;  ///< scaling by less than this neither overflows nor loses bits

}  // namespace

ExactPoint exactly(std::span<const double> point) {
  ExactPoint result;
  result.dimension = static_cast<int>(point.size());
  std::array<Rational, max_dimension> coordinates;
  long lowest = std::numeric_limits<long>::max();
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    coordinates[axis] = exactly(point[axis]);
    if (point[axis] != 0) lowest = std::min(lowest, coordinates[axis].exponent);
  }
  if (lowest == std::numeric_limits<long>::max()) return result;
  result.exponent = lowest;
  for (std::size_t axis = 0; axis < point.size(); ++axis)
    if (point[axis] != 0)
      mpz_mul_2exp(result.numerator[axis].get_mpz_t(), coordinates[axis].numerator.get_mpz_t(),
                   static_cast<mp_bitcnt_t>(coordinates[axis].exponent - lowest));
  return result;
}

namespace {

Rational squared_distance(const ExactPoint& a, const ExactPoint& b) {
  Rational sum;
  for (int axis = 0; axis < a.dimension; ++axis) {
    const Rational d = a.coordinate(axis) - b.coordinate(axis);
    sum = sum + d * d;
  }
  return sum;
}

}  // namespace

double distance(const ExactPoint& a, const ExactPoint& b) { return square_root(error_format, squared_distance(a, b)); }

namespace {

double spacing(long exponent, const Format& format) {
  return std::ldexp(1.0, static_cast<int>(std::max(exponent - format.precision + 1, format.lowest_exponent)));
}

}  // namespace

std::optional<double> ulp_at_length(double length, const Format& format) {
  if (length == 0) return spacing(format.lowest_exponent, format);
  int exponent = 0;
  if (!std::isfinite(length) || std::frexp(length, &exponent) == 0.5) return std::nullopt;
  return spacing(exponent - 1L, format);
}

double ulp_of_length(const ExactPoint& point, double length, const Format& format) {
  if (const auto decided = ulp_at_length(length, format)) return *decided;
  ExactPoint origin;
  origin.dimension = point.dimension;
  const long square_exponent = floor_log2(squared_distance(point, origin));
  return spacing(square_exponent >= 0 ? square_exponent / 2 : (square_exponent - 1) / 2, format);
}

Distance::Distance(const ExactPoint& exact) : exact_(&exact) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(exact.dimension); ++axis)
    expansions_[axis] = expand(exact.numerator[axis], exact.denominator, exact.exponent);
}

Distance::Distance(std::span<const double> point) : point_(point) {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    if (point[axis] == 0) continue;
    auto& expansion = expansions_[axis];
    int exponent = 0;
    expansion.high = std::frexp(point[axis], &exponent);
    expansion.exponent = exponent;
  }
}

Distance::Expansion Distance::expand(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  Expansion result;
  if (numerator == 0) return result;
  thread_local mpz_class leading;
  thread_local mpz_class remainder;
  long dropped = static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) - expansion_bits;
  if (denominator == 1) {
    if (dropped > 0) {
      result.complete = static_cast<long>(mpz_scan1(numerator.get_mpz_t(), 0)) >= dropped;
      mpz_tdiv_q_2exp(leading.get_mpz_t(), numerator.get_mpz_t(), static_cast<mp_bitcnt_t>(dropped));
    } else {
      mpz_mul_2exp(leading.get_mpz_t(), numerator.get_mpz_t(), static_cast<mp_bitcnt_t>(-dropped));
    }
  } else {
    dropped -= static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2)) - 1;
    if (dropped > 0)
      mpz_tdiv_q_2exp(leading.get_mpz_t(), numerator.get_mpz_t(), static_cast<mp_bitcnt_t>(dropped));
    else
      mpz_mul_2exp(leading.get_mpz_t(), numerator.get_mpz_t(), static_cast<mp_bitcnt_t>(-dropped));
    mpz_tdiv_qr(leading.get_mpz_t(), remainder.get_mpz_t(), leading.get_mpz_t(), denominator.get_mpz_t());
    result.complete = false;
  }
  result.exponent = exponent + dropped;
  // Three chunks of at most 53 bits each, from the top; then renormalised so that each is the nearest double.
  std::array<double, 3> chunk{};
  for (double& part : chunk) {
    if (leading == 0) break;
    const double top = leading.get_d();  // truncates towards zero
    part = top;
    remainder = top;
    leading -= remainder;
  }
  const auto lower = fast_two_sum(chunk[1], chunk[2]);
  const auto upper = fast_two_sum(chunk[0], lower.value);
  const auto rest = fast_two_sum(upper.error, lower.error);
  const int scale = floor_log2(upper.value) + 1;
  result.high = upper.value * power_of_two(-scale);
  result.middle = rest.value * power_of_two(-scale);
  result.low = rest.error * power_of_two(-scale);
  result.exponent += scale;
  return result;
}

Distance::Difference Distance::difference(double value, const Expansion& expansion) {
  Difference result;
  if (expansion.high == 0) {  // the true coordinate is zero
    result.value = value;
    result.certain = value == 0 || std::abs(value) >= std::numeric_limits<double>::min();
    return result;
  }
  result.exponent = expansion.exponent;
  double scaled = 0;
  if (value != 0) {
    const long apart = floor_log2(value) - expansion.exponent;
    const bool safe = std::abs(apart) < safe_exponent && std::abs(expansion.exponent) < safe_exponent;
    if (!safe) {
      result.certain = false;
      return result;
    }
    scaled = value * power_of_two(static_cast<int>(-expansion.exponent));
  }
  const auto top = two_sum(scaled, -expansion.high);
  const double rest = (top.error - expansion.middle) - expansion.low;
  result.value = top.value + rest;
  // `high` is the double nearest to the truth, so |value - truth| >= |middle + low| for any double: nothing cancels
  // beyond a factor of two, and the roundings above change the result by at most 2^-50 of it. The remainder of the
  // expansion is below 2^-155.
  result.certain = expansion.complete || 0x1p-155 <= 0x1p-50 * std::abs(result.value);
  return result;
}

double Distance::to(std::span<const double> point) const {
  for (const double value : point)
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  std::array<Difference, max_dimension> differences;
  long largest = std::numeric_limits<long>::min();
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    auto& d = differences[axis] = difference(point[axis], expansions_[axis]);
    if (!d.certain) return exact_distance(point);
    if (d.value != 0) largest = std::max(largest, d.exponent + floor_log2(d.value));
  }
  if (largest == std::numeric_limits<long>::min()) return 0;
  if (std::abs(largest) > safe_exponent) return exact_distance(point);
  double sum = 0;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const auto& d = differences[axis];
    const long by = d.exponent - largest;
    if (d.value == 0 || by + floor_log2(d.value) < -safe_exponent / 2) continue;  // too small to change the sum
    if (std::abs(by) > safe_exponent) return exact_distance(point);
    const double scaled = d.value * power_of_two(static_cast<int>(by));
    sum += scaled * scaled;
  }
  const double distance = std::sqrt(sum);
  // 53 - 24 = 29 bits are dropped. The relative error is about 2^-46, so the integers decide values nearer to a tie.
  constexpr std::uint64_t dropped_mask = (1ULL << 29U) - 1;
  constexpr std::int64_t half = 1LL << 28U;
  const auto bits = std::bit_cast<std::uint64_t>(distance);
  const auto tail = static_cast<std::int64_t>(bits & dropped_mask);
  if (std::abs(tail - half) <= 1LL << 8U) return exact_distance(point);
  const auto rounded = (bits & ~dropped_mask) + (tail > half ? dropped_mask + 1 : 0);
  return std::bit_cast<double>(rounded) * power_of_two(static_cast<int>(largest));
}

double Distance::exact_distance(std::span<const double> point) const {
  Rational sum;
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const Rational truth = exact_ != nullptr ? exact_->coordinate(static_cast<int>(axis)) : exactly(point_[axis]);
    const Rational d = exactly(point[axis]) - truth;
    sum = sum + d * d;
  }
  return square_root(error_format, sum);
}

}  // namespace bezierbench::reference
