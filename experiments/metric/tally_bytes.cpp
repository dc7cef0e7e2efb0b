// SPDX-License-Identifier: MIT
// A tally as bytes: its integers, empty binades and empty bins left out.
#include "experiments/metric/tally.hpp"
#include "experiments/number/bytes.hpp"

namespace bezierbench::metric {
namespace {

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

}  // namespace bezierbench::metric
