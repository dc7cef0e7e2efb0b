// SPDX-License-Identifier: MIT
// The random words of one trial.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace bezierbench::sample {

// Random words as a pure function of a counter, so that the order of execution cannot change an input.

using Block = std::array<std::uint64_t, 4>;

/// Philox4x64 with 10 rounds. Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC'11.
inline Block philox(const Block& counter, const std::array<std::uint64_t, 2>& key) {
  const r123::Philox4x64::ctr_type in{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x64::ctr_type out = r123::Philox4x64()(in, {{key[0], key[1]}});
  return {out[0], out[1], out[2], out[3]};
}

/// A uniform in [0, 1): (high 2^64 + low) / 2^128.
struct Uniform128 {
  std::uint64_t high;
  std::uint64_t low;
};

/// The stream of 64-bit words of (seed, study, cell, trial): the blocks philox((study, cell, trial, block), (seed, 0))
/// for block = 0, 1, ..., of four words each.
class Words {
 public:
  Words(std::uint64_t seed, std::uint64_t study_key, std::uint64_t cell_key, std::uint64_t trial)
      : counter_{study_key, cell_key, trial, 0}, key_{seed, 0} {}

  std::uint64_t next() {
    if (used_ == block_.size()) {
      block_ = philox(counter_, key_);
      ++counter_[3];
      used_ = 0;
    }
    return block_[used_++];
  }

  /// The next two words, the high one first.
  Uniform128 next_uniform() {
    const std::uint64_t high = next();
    return {high, next()};
  }

  /// floor(count U / 2^128) for the U of the next two words: uniform in [0, count). No value is rejected, so every draw
  /// takes two words; each probability has a relative error below count / 2^128.
  std::uint64_t next_below(std::uint64_t count) {
    __extension__ using Wide = unsigned __int128;
    const Uniform128 u = next_uniform();
    const Wide carry = (Wide{count} * u.low) >> 64U;
    return static_cast<std::uint64_t>((Wide{count} * u.high + carry) >> 64U);
  }

 private:
  Block counter_;
  std::array<std::uint64_t, 2> key_;
  Block block_{};
  std::size_t used_ = 4;
};

/// a + (b - a) (2U + 1) / 2^129 for the integer U = high 2^64 + low, correctly rounded (to nearest, ties to even) in
/// integer arithmetic, for all finite a <= b, also subnormal ones and those of opposite signs. The result is in [a, b]
/// and has a full mantissa also near zero. An exact zero is +0; a result that underflows keeps its sign.
///
/// The midpoints (2U + 1) / 2^129 make the image symmetric: U and its complement, with a and b exchanged, agree.
double affine(double a, double b, Uniform128 u);

}  // namespace bezierbench::sample
