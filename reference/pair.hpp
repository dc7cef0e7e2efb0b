// SPDX-License-Identifier: MIT
// Pairs of doubles (double-double arithmetic), with the errors that the fast references count with.
//
// A pair stands for high + low, and high is the double nearest to it, so |low| <= u |high|. All operations return such
// pairs. Errors in units of u^2 = 2^-106, to first order ([Joldes et al. 2017] bound such operations more tightly):
//   product of pairs        drops low low (1), rounds low high (1), the fused sum (2) and the last sum (3): 8 |x y|
//   pair times a double     rounds the fused sum (2): 3 |x y|
//   sum of pairs            rounds the sum of the low parts (1) and the last sum (2): 4 (|x| + |y|)
//   quotient of pairs       rounds the remainder, which is at most 3u |x|, three times (6) and what is divided by it
//                           (3), and divides it by high instead of y (3): 16 |x / y|
// each rounded up. An operation loses up to 2^-1072 more where a part of it is subnormal. Nothing may overflow.
#pragma once

#include "core/error_free.hpp"

namespace bezierbench::reference {

struct Pair {
  double high = 0;
  double low = 0;
};

inline Pair pair_of(Expansion2<double> sum) { return {sum.value, sum.error}; }

inline Pair product(Pair x, Pair y) {
  const auto high = two_prod(x.high, y.high);
  return pair_of(fast_two_sum(high.value, high.error + fused(x.high, y.low, x.low * y.high)));
}

inline Pair product(Pair x, double y) {
  const auto high = two_prod(x.high, y);
  return pair_of(fast_two_sum(high.value, fused(x.low, y, high.error)));
}

inline Pair sum(Pair x, Pair y) {
  const auto high = two_sum(x.high, y.high);
  return pair_of(two_sum(high.value, high.error + (x.low + y.low)));
}

inline Pair quotient(Pair x, Pair y) {
  const double first = x.high / y.high;
  const double rest = (fused(-first, y.high, x.high) + x.low) - first * y.low;
  return pair_of(fast_two_sum(first, rest / y.high));
}

}  // namespace bezierbench::reference
