// SPDX-License-Identifier: MIT
// The errors of many trials, kept exactly: sums are integers per binade, quantiles come from a histogram of leading
// bits. The order of adding and merging therefore changes nothing: threads, blocks and shards cannot change a byte of a
// statistic.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/curve_view.hpp"
#include "reference/certified_points.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::number {
class ByteReader;
class ByteWriter;
}  // namespace bezierbench::number

namespace bezierbench::metric {

/// 128 bits: the sum of 2^40 squared significands of 24 bits still fits. A compiler extension, hence the marker.
__extension__ using Wide = unsigned __int128;

class Tally {
 public:
  /// Adds one error: finite, >= 0, with at most 24 significant bits (as reference::Distance returns it).
  void add(double error);
  /// Adds several; an infinite one as `add_infinite`.
  void add(std::span<const double> errors);
  /// Adds an infinite one: statistics become infinite.
  void add_infinite() { ++infinite_; }
  void merge(const Tally& other);

  [[nodiscard]] std::uint64_t count() const { return finite_ + infinite_; }
  /// Sum over count, correctly rounded; 0 when empty.
  [[nodiscard]] double mean() const;
  /// Square root of the mean square, correctly rounded; 0 when empty.
  [[nodiscard]] double root_mean_square() const;
  /// The smallest error with at least q count() errors at or below it, its significand cut to 8 bits; 0 < q <= 1.
  [[nodiscard]] double quantile(double q) const;
  [[nodiscard]] double max() const;

  /// Saves and loads the tally exactly. load() throws number::MalformedBytes for bytes that save() never writes.
  void save(number::ByteWriter& bytes) const;
  void load(number::ByteReader& bytes);

 private:
  static constexpr int bins_per_binade = 128;
  struct Binade {
    Wide sum = 0;          ///< of significands
    Wide sum_squares = 0;  ///< of squared significands
    std::array<std::uint64_t, bins_per_binade> bins{};
  };
  Binade& at(int exponent) {
    const auto index = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(exponent) - first_exponent_);
    return index < binades_.size() ? binades_[index] : made_at(exponent);
  }
  Binade& made_at(int exponent);

  std::vector<Binade> binades_;  ///< of consecutive exponents
  int first_exponent_ = 0;       ///< of binades_[0]: errors in [2^(e-1), 2^e)
  std::uint64_t zeros_ = 0;
  std::uint64_t finite_ = 0;
  std::uint64_t infinite_ = 0;
  double max_ = 0;
};

/// Rounds to 24 significant bits, ties to even: the precision in which errors are kept. Infinities and NaN stay as they
/// are.
inline double to_24_bits(double value) {
  constexpr int dropped_bits = 53 - 24;
  constexpr std::uint64_t low = (1ULL << dropped_bits) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t tie_to_even = (bits >> dropped_bits) & 1U;
  const double rounded = std::bit_cast<double>((bits + (low >> 1U) + tie_to_even) & ~low);
  return std::isfinite(value) ? rounded : value;
}

}  // namespace bezierbench::metric

// Errors in the units in which they are judged and kept.

namespace bezierbench::metric {

using ErrorLanes = reference::CertifiedLanes;

/// in_units() of every trial of a group, rounded to 24 bits.
inline ErrorLanes in_units(const ErrorLanes& errors, const ErrorLanes& divisors, double unit = 1) {
  ErrorLanes units;
  for (std::size_t k = 0; k < units.size(); ++k)
    units[k] = to_24_bits(reference::in_units(errors[k], divisors[k], unit));
  return units;
}

/// The size of a curve: the largest extent of its control points along an axis. 0 in power form, whose coefficients are
/// not points. Coordinates are multiplied by `scale` before they are subtracted, and so is the size.
double size_of(const CurveView<double>& curve, double scale = 1);

/// How much larger than in an accuracy study errors may be where few other inputs are drawn from the same cell.
inline constexpr double observed_multiple = 16;

/// The largest error allowed, in units of u p~: that multiple of the largest one `observed` in the same cell, or of 1
/// if that is larger. Where none was observed, or an infinite one, half of the digits of the exact value must be right.
inline double allowed_error_u(std::optional<double> observed, double unit_roundoff) {
  if (observed && std::isfinite(*observed)) return observed_multiple * std::max(*observed, 1.0);
  return 1 / std::sqrt(unit_roundoff);
}

}  // namespace bezierbench::metric
