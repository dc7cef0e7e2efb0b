// SPDX-License-Identifier: MIT
#include "reference/exhausted_memory.hpp"

#include <gmp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace bezierbench::reference {
namespace {

/// As many bits as `size` bytes have, in a process that may have `limit` bytes.
[[noreturn]] void take(rlim_t limit, mp_bitcnt_t size) {
  constexpr int reported = 3;
  on_exhausted_memory([] { _exit(reported); });
  const rlimit memory{limit, limit};
  setrlimit(RLIMIT_AS, &memory);
  mpz_t number;
  mpz_init_set_ui(number, 1);
  mpz_mul_2exp(number, number, 8 * size);
  mpz_mul(number, number, number);
  const bool right = mpz_sizeinbase(number, 2) == 16 * size + 1;
  mpz_clear(number);
  _exit(right ? 0 : 1);
}

TEST(ExhaustedMemory, IsReported) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes more memory than any limit of this test";
#endif
  constexpr rlim_t gigabyte = 1U << 30U;
  EXPECT_EXIT(take(gigabyte, gigabyte), testing::ExitedWithCode(3), "^$");  // GMP itself would abort, with two lines
  EXPECT_EXIT(take(gigabyte, 1000), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace bezierbench::reference
