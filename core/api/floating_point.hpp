// SPDX-License-Identifier: MIT
// Bounds and bits hold for IEEE arithmetic, one rounding for each operation that is written. This file refuses
// compilers with other options, as far as they report these. They do not report whether a product and a sum may become
// one operation: -ffp-contract=off, which the CMake targets and the pkg-config files carry, or `keeps_arithmetic()` in
// a test.
#pragma once

#if defined(__FAST_MATH__) || (defined(_MSC_VER) && defined(_M_FP_FAST))
#error \
    "bezierbench: compiled with -ffast-math; bounds and bits hold without it. Remove it, or add -fno-fast-math after it."
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "bezierbench: compiled with -ffinite-math-only; bounds and bits hold without it."
#endif
#if defined(__GCC_IEC_559) && __GCC_IEC_559 == 0
#error \
    "bezierbench: compiled with an option that leaves IEEE arithmetic, such as -funsafe-math-optimizations, -fassociative-math, -freciprocal-math or -fno-signed-zeros."
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "bezierbench: double is computed in a wider format here; on x86 compile with -mfpmath=sse -msse2."
#endif

namespace bezierbench {

/// Whether this translation unit, as it runs now, rounds each operation once, to nearest, and keeps subnormal numbers.
/// Static, for each unit has options of its own.
static inline bool keeps_arithmetic() {
  // Read through volatile, so that the compiler cannot compute them; in one expression, so that it may contract them.
  const volatile double factor = 1 + 0x1p-30;
  const volatile double rounded_square = 1 + 0x1p-29;  // of factor, whose last bit is lost
  const volatile double tiny = 0x1p-1022;
  const volatile double half = 0.5;
  const volatile double one = 1;
  const volatile double below_half_ulp = 0x1p-54;
  const double f = factor;
  const bool apart = f * f - rounded_square == 0;
  const bool subnormal = tiny * half != 0;
  const bool nearest = one + below_half_ulp == 1 && one - below_half_ulp == 1 && -one - below_half_ulp == -1;
  return apart && subnormal && nearest;
}

}  // namespace bezierbench
