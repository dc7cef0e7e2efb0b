// SPDX-License-Identifier: MIT
#include "experiments/number/bytes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace bezierbench::number {
namespace {

struct Everything {
  std::uint64_t natural = 0;
  std::int64_t whole = 0;
  int small = 0;
  bool truth = false;
  double real = 0;
  std::string text;
  std::vector<bool> bits;
  std::vector<std::vector<double>> nested;
  std::optional<std::int64_t> perhaps;
  std::map<std::int64_t, std::string> entries;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.natural, self.whole, self.small, self.truth, self.real, self.text, self.bits, self.nested, self.perhaps,
          self.entries);
  }
  friend bool operator==(const Everything&, const Everything&) = default;
};

template <class T>
std::string bytes_of(const T& value) {
  ByteWriter writer;
  writer(value);
  return writer.bytes();
}

template <class T>
T read(const std::string& bytes) {
  ByteReader reader(bytes);
  T value{};
  reader(value);
  reader.finish();
  return value;
}

const Everything sample{.natural = 1ULL << 63U,
                        .whole = -5,
                        .small = std::numeric_limits<int>::min(),
                        .truth = true,
                        .real = 0.1,
                        .text = std::string("a\0b", 3),
                        .bits = {true, false, true},
                        .nested = {{}, {-0.0, 5e-324}},
                        .perhaps = 7,
                        .entries = {{-1, "x"}, {2, ""}}};

TEST(Bytes, ReadBackToTheSameValue) { EXPECT_EQ(read<Everything>(bytes_of(sample)), sample); }

TEST(Bytes, IntegersOfEveryLength) {
  std::mt19937_64 random(1);
  for (unsigned shift = 0; shift < 64; ++shift) {
    for (const std::uint64_t value : {random() >> shift, std::uint64_t{1} << shift, (std::uint64_t{1} << shift) - 1}) {
      EXPECT_EQ(read<std::uint64_t>(bytes_of(value)), value);
      const auto whole = static_cast<std::int64_t>(value);
      EXPECT_EQ(read<std::int64_t>(bytes_of(whole)), whole);
    }
  }
  EXPECT_EQ(bytes_of(127U).size(), 1U);
  EXPECT_EQ(bytes_of(128U).size(), 2U);
}

TEST(Bytes, KeepTheBitsOfADouble) {
  for (const std::uint64_t bits : {0x8000000000000000UL, 0x7ff8000000000123UL, 0x7ff0000000000000UL, 0x1UL})
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read<double>(bytes_of(std::bit_cast<double>(bits)))), bits);
}

TEST(Bytes, EveryCutIsNoticed) {
  const std::string all = bytes_of(sample);
  for (std::size_t size = 0; size < all.size(); ++size)
    EXPECT_THROW(read<Everything>(all.substr(0, size)), MalformedBytes) << size;
  EXPECT_THROW(read<Everything>(all + '\0'), MalformedBytes);
}

}  // namespace
}  // namespace bezierbench::number
