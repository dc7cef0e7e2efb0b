// SPDX-License-Identifier: MIT
// The most operations that a target can do: fused multiply-adds in chains, enough of them side by side to hide their
// latency (a product and a sum where the hardware has no fused multiply-add). The chains load and store nothing.
#pragma once

#include "core/batch/lanes.hpp"
#include "core/batch/target_table.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

inline constexpr int peak_steps = 256;

/// `Fmas` chains of multiply-adds and `Adds` of additions, a vector in each.
template <class S, int Fmas, int Adds>
class Chains {
 public:
  static void run(S factor, S addend, S* values) {
    advance(factor, addend, values, std::make_integer_sequence<int, Fmas>(), std::make_integer_sequence<int, Adds>());
  }
  static constexpr PeakWork<S> work() {
    return {run, Fmas * lanes, Adds * lanes, static_cast<double>((2 * Fmas + Adds) * lanes * peak_steps)};
  }

 private:
  static constexpr std::size_t lanes = Lanes<S, 1>::size;

  template <int... F, int... A>
  static HWY_INLINE void advance(S factor, S addend, S* values, std::integer_sequence<int, F...> /*fmas*/,
                                 std::integer_sequence<int, A...> /*adds*/) {
    using Vector = typename Lanes<S, 1>::Vector;
    const typename Lanes<S, 1>::Tag tag;
    const auto multiplier = hn::Set(tag, factor);
    const auto summand = hn::Set(tag, addend);
    Vector x[Fmas];
    [[maybe_unused]] Vector y[Adds + 1];  // no array is empty
    ((x[F] = hn::LoadU(tag, values + F * lanes)), ...);
    ((y[A] = hn::LoadU(tag, values + (Fmas + A) * lanes)), ...);
    for (int step = 0; step < peak_steps; ++step) {
      ((x[F] = hn::MulAdd(x[F], multiplier, summand)), ...);
      ((y[A] = hn::Add(y[A], summand)), ...);
    }
    (hn::StoreU(x[F], tag, values + F * lanes), ...);
    (hn::StoreU(y[A], tag, values + (Fmas + A) * lanes), ...);
  }
};

}  // namespace bezierbench::batch::HWY_NAMESPACE
