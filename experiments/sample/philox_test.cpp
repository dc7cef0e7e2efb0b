// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "experiments/sample/words.hpp"

namespace bezierbench::sample {
namespace {

// The lines `philox4x64 10` of kat_vectors in the Random123 distribution (Salmon, Moraes, Dror, Shaw, SC'11).
TEST(Philox, GivesThePublishedKnownAnswers) {
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (Block{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Block{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(philox({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                   {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Block{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

TEST(Words, AreTheBlocksOfATrialInOrder) {
  Words words(1, 2, 3, 4);
  for (std::uint64_t block = 0; block < 3; ++block) {
    for (const std::uint64_t expected : philox({2, 3, 4, block}, {1, 0})) EXPECT_EQ(words.next(), expected);
  }
}

TEST(Words, UniformHasTheHighWordFirst) {
  Words words(1, 2, 3, 4);
  Words same(1, 2, 3, 4);
  const Uniform128 u = words.next_uniform();
  EXPECT_EQ(u.high, same.next());
  EXPECT_EQ(u.low, same.next());
}

}  // namespace
}  // namespace bezierbench::sample
