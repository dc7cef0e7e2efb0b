// SPDX-License-Identifier: MIT
#include "experiments/metric/counts.hpp"

#include <gtest/gtest.h>

#include "experiments/number/bytes.hpp"

namespace bezierbench::metric {
namespace {

struct Inner {
  std::uint64_t count = 0;
  Largest<double> largest;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.count, self.largest);
  }
};

struct Outer {
  Tally error;
  TrialCount violations;
  Total steps;
  Inner inner;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.violations, self.steps, self.inner);
  }
};

Outer trial_fields(std::uint64_t trial, double error, std::uint64_t steps) {
  Outer one;
  one.error.add(error);
  one.violations.add(trial);
  one.steps.add(steps);
  one.inner.count = 1;
  one.inner.largest.add(error);
  return one;
}

template <class T>
std::string bytes_of(const T& value) {
  number::ByteWriter bytes;
  bytes(value);
  return bytes.bytes();
}

TEST(MergeFields, TakesEveryFieldByItsKind) {
  Outer sum = trial_fields(9, 2, 30);
  merge_fields(sum, trial_fields(4, 8, 5));
  EXPECT_EQ(sum.error.count(), 2U);
  EXPECT_EQ(sum.error.max(), 8);
  EXPECT_EQ(sum.violations.count, 2U);
  EXPECT_EQ(sum.violations.first, 4U);
  EXPECT_EQ(sum.steps.sum, 35U);
  EXPECT_EQ(sum.steps.largest, 30U);
  EXPECT_EQ(sum.inner.count, 2U);
  EXPECT_EQ(sum.inner.largest.value, 8);
}

TEST(MergeFields, IsFreeOfOrder) {
  const std::vector<Outer> trials{trial_fields(0, 4, 1), trial_fields(1, 0.5, 7), trial_fields(2, 0, 0)};
  Outer forwards = trials[0];
  for (const std::size_t k : {1U, 2U}) merge_fields(forwards, trials[k]);
  Outer backwards = trials[2];
  for (const std::size_t k : {1U, 0U}) merge_fields(backwards, trials[k]);
  EXPECT_EQ(bytes_of(forwards), bytes_of(backwards));
}

TEST(MergeFields, TakesContainersElementByElement) {
  using Counts = std::array<std::uint64_t, 2>;
  std::optional<Total> sum;
  merge_fields(sum, std::optional<Total>());
  EXPECT_FALSE(sum);
  merge_fields(sum, std::optional(Total{3, 3}));
  merge_fields(sum, std::optional(Total{4, 4}));
  EXPECT_EQ(sum->sum, 7U);
  EXPECT_EQ(sum->largest, 4U);
  std::map<int, Counts> by_key{{1, {1, 2}}, {2, {3, 4}}};
  merge_fields(by_key, {{0, {5, 6}}, {2, {10, 20}}});
  EXPECT_EQ(by_key, (std::map<int, Counts>{{0, {5, 6}}, {1, {1, 2}}, {2, {13, 24}}}));
  std::vector<std::uint64_t> row{1, 2};
  merge_fields(row, {10, 20});
  EXPECT_EQ(row, (std::vector<std::uint64_t>{11, 22}));
  EXPECT_THROW(merge_fields(row, {1}), std::invalid_argument);
}

TEST(Rows, MergeRowByRowAndRefuseAnotherPart) {
  Rows<Outer> sum{{trial_fields(0, 1, 1), trial_fields(0, 2, 2)}};
  sum.merge({{trial_fields(1, 3, 3), trial_fields(1, 4, 4)}});
  EXPECT_EQ(sum.rows[0].steps.sum, 4U);
  EXPECT_EQ(sum.rows[1].steps.sum, 6U);
  EXPECT_THROW(sum.merge({{trial_fields(1, 3, 3)}}), std::invalid_argument);
}

TEST(AddRounded, KeepsWhatIsNotFiniteAsInfinite) {
  Tally tally;
  add_rounded(1 + 0x1p-40, tally);
  EXPECT_EQ(tally.max(), 1);
  add_rounded(std::numeric_limits<double>::infinity(), tally);
  EXPECT_EQ(tally.count(), 2U);
  EXPECT_TRUE(std::isinf(tally.max()));
}

}  // namespace
}  // namespace bezierbench::metric
