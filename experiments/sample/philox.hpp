// SPDX-License-Identifier: MIT
// Random words as a pure function of a counter, so that the order of execution cannot change an input.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace bezierbench::sample {

using Block = std::array<std::uint64_t, 4>;

/// Philox4x64 with 10 rounds. Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC'11.
inline Block philox(const Block& counter, const std::array<std::uint64_t, 2>& key) {
  const r123::Philox4x64::ctr_type in{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x64::ctr_type out = r123::Philox4x64()(in, {{key[0], key[1]}});
  return {out[0], out[1], out[2], out[3]};
}

}  // namespace bezierbench::sample
