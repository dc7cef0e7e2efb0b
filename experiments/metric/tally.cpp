// SPDX-License-Identifier: MIT
#include "experiments/metric/tally.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "experiments/number/bytes.hpp"
#include "reference/rational.hpp"

namespace bezierbench::metric {

namespace {

constexpr int precision = 24;
constexpr int bin_bits = 7;

/// A positive error as significand 2^(exponent - 24) with a significand of 24 bits; subnormals alike.
struct Fields {
  int exponent;
  std::uint64_t significand;
  std::size_t bin;  ///< the bits after the leading one
};
Fields fields_of(double value) {
  constexpr int fraction_bits = 52;
  constexpr int bias = 1022;  // of mantissas in [1/2, 1)
  int shifted = 0;
  if (value < std::numeric_limits<double>::min()) {
    shifted = 2 * fraction_bits;
    value *= 0x1p+104;  // exact, and normal
  }
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto fraction = bits & ((1ULL << fraction_bits) - 1);
  return {static_cast<int>(bits >> fraction_bits) - bias - shifted,
          (1ULL << (precision - 1)) | (fraction >> (fraction_bits - precision + 1)),
          fraction >> (fraction_bits - bin_bits)};
}

mpz_class to_mpz(Wide value) {
  mpz_class high = static_cast<std::uint64_t>(value >> 64U);
  high <<= 64U;
  return high + static_cast<std::uint64_t>(value);
}

constexpr int lowest_exponent = -1100;  // of any double, with room
constexpr int highest_exponent = 1100;

void save_wide(number::ByteWriter& bytes, Wide value) {
  bytes(static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 64U));
}

Wide load_wide(number::ByteReader& bytes) {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  bytes(low, high);
  return (static_cast<Wide>(high) << 64U) | low;
}

}  // namespace

Tally::Binade& Tally::made_at(int exponent) {
  if (binades_.empty()) first_exponent_ = exponent;
  if (exponent < first_exponent_) {
    binades_.insert(binades_.begin(), static_cast<std::size_t>(first_exponent_ - exponent), Binade{});
    first_exponent_ = exponent;
  }
  const auto index = static_cast<std::size_t>(exponent - first_exponent_);
  if (index >= binades_.size()) binades_.resize(index + 1);
  return binades_[index];
}

void Tally::add(double error) {
  ++finite_;
  if (error == 0) {
    ++zeros_;
    return;
  }
  const Fields fields = fields_of(error);
  Binade& binade = at(fields.exponent);
  binade.sum += fields.significand;
  binade.sum_squares += static_cast<Wide>(fields.significand) * fields.significand;
  ++binade.bins[fields.bin];
  max_ = std::max(max_, error);
}

void Tally::add(std::span<const double> errors) {
  for (const double error : errors)
    if (std::isfinite(error))
      add(error);
    else
      add_infinite();
}

void Tally::merge(const Tally& other) {
  for (std::size_t k = 0; k < other.binades_.size(); ++k) {
    const Binade& from = other.binades_[k];
    if (from.sum == 0) continue;
    Binade& to = at(other.first_exponent_ + static_cast<int>(k));
    to.sum += from.sum;
    to.sum_squares += from.sum_squares;
    for (std::size_t bin = 0; bin < bins_per_binade; ++bin) to.bins[bin] += from.bins[bin];
  }
  zeros_ += other.zeros_;
  finite_ += other.finite_;
  infinite_ += other.infinite_;
  max_ = std::max(max_, other.max_);
}

double Tally::mean() const {
  if (infinite_ > 0) return std::numeric_limits<double>::infinity();
  if (finite_ == 0) return 0;
  reference::Rational sum;
  for (std::size_t k = 0; k < binades_.size(); ++k)
    sum = sum + reference::Rational{to_mpz(binades_[k].sum), 1, first_exponent_ + static_cast<long>(k) - precision};
  return reference::quotient(reference::binary64, sum, {mpz_class(finite_), 1, 0});
}

double Tally::root_mean_square() const {
  if (infinite_ > 0) return std::numeric_limits<double>::infinity();
  if (finite_ == 0) return 0;
  reference::Rational sum;
  for (std::size_t k = 0; k < binades_.size(); ++k)
    sum = sum + reference::Rational{to_mpz(binades_[k].sum_squares), 1,
                                    2 * (first_exponent_ + static_cast<long>(k) - precision)};
  sum.denominator *= mpz_class(finite_);
  return reference::square_root(reference::binary64, sum);
}

double Tally::quantile(double q) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(q * static_cast<double>(count())));
  std::uint64_t seen = zeros_;
  if (count() == 0 || seen >= wanted) return 0;
  for (std::size_t k = 0; k < binades_.size(); ++k)
    for (std::size_t bin = 0; bin < bins_per_binade; ++bin) {
      seen += binades_[k].bins[bin];
      if (seen < wanted) continue;
      const int exponent = first_exponent_ + static_cast<int>(k);
      return std::ldexp(static_cast<double>((1ULL << bin_bits) + bin), exponent - bin_bits - 1);
    }
  return std::numeric_limits<double>::infinity();
}

double Tally::max() const { return infinite_ > 0 ? std::numeric_limits<double>::infinity() : max_; }

void Tally::save(number::ByteWriter& bytes) const {
  bytes(zeros_, finite_, infinite_, max_);
  std::uint64_t used = 0;
  for (const Binade& binade : binades_) used += binade.sum != 0 ? 1 : 0;
  bytes(used);
  for (std::size_t k = 0; k < binades_.size(); ++k) {
    const Binade& binade = binades_[k];
    if (binade.sum == 0) continue;
    bytes(first_exponent_ + static_cast<int>(k));
    save_wide(bytes, binade.sum);
    save_wide(bytes, binade.sum_squares);
    std::size_t gap = 0;  // a run of empty bins is written as a 0 and its length
    for (const std::uint64_t count : binade.bins) {
      if (count == 0) {
        ++gap;
        continue;
      }
      if (gap > 0) bytes(std::uint64_t{0}, gap);
      gap = 0;
      bytes(count);
    }
    if (gap > 0) bytes(std::uint64_t{0}, gap);
  }
}

void Tally::load(number::ByteReader& bytes) {
  *this = Tally();
  std::uint64_t used = 0;
  bytes(zeros_, finite_, infinite_, max_, used);
  for (; used > 0; --used) {
    int exponent = 0;
    bytes(exponent);
    if (exponent < lowest_exponent || exponent > highest_exponent) throw number::MalformedBytes();
    Binade& binade = at(exponent);
    binade.sum = load_wide(bytes);
    binade.sum_squares = load_wide(bytes);
    for (std::size_t bin = 0; bin < bins_per_binade;) {
      std::size_t gap = 1;
      bytes(binade.bins[bin]);
      if (binade.bins[bin] == 0) bytes(gap);
      if (gap > bins_per_binade - bin) throw number::MalformedBytes();
      bin += gap;
    }
  }
}

double size_of(const CurveView<double>& curve, double scale) {
  if (curve.form == Form::power) return 0;
  double size = 0;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    double low = curve(axis, 0);
    double high = low;
    for (int i = 1; i <= curve.degree; ++i) {
      low = std::min(low, curve(axis, i));
      high = std::max(high, curve(axis, i));
    }
    size = std::max(size, scale * high - scale * low);
  }
  return size;
}

}  // namespace bezierbench::metric
