// SPDX-License-Identifier: MIT
// Every promise of a method for subdivision is kept on many curves. Every promise that it does not make is broken by
// some curve.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/subdivide/split_test.hpp"

namespace bezierbench {
namespace {

/// One curve split at one t, with a check for each promise. 0 and -0 count as equal, except where bits are compared.
struct Trial {
  const SplitKernel& kernel;
  const Drawn& drawn;
  double t;
  SplitNumbers halves;
  int columns;
  int n;

  [[nodiscard]] std::vector<double> given() const { return numbers(drawn.curve()); }
  [[nodiscard]] bool all_are(const std::vector<double>& half, const std::vector<double>& wanted) const {
    for (int i = 0; i <= n; ++i)
      if (point(half, columns, i) != wanted) return false;
    return true;
  }
  [[nodiscard]] bool keeps_ends() const {
    return same_bits(point(halves.left, columns, 0), point(given(), columns, 0)) &&
           same_bits(point(halves.right, columns, n), point(given(), columns, n));
  }
  [[nodiscard]] bool shares_junction() const {
    return same_bits(point(halves.left, columns, n), point(halves.right, columns, 0));
  }
  [[nodiscard]] bool exact_at_zero() const {
    return t != 0 || (halves.right == given() && all_are(halves.left, point(given(), columns, 0)));
  }
  [[nodiscard]] bool exact_at_one() const {
    return t != 1 || (halves.left == given() && all_are(halves.right, point(given(), columns, n)));
  }
  [[nodiscard]] bool reproduces_constants() const {
    Drawn constant = drawn;
    for (double& value : constant.c) value = drawn.c[0];
    const auto of_constant = split(kernel, constant.curve(), t);
    for (std::size_t k = 0; k < of_constant.left.size(); k += static_cast<std::size_t>(columns))
      if (of_constant.left[k] != drawn.c[0] || of_constant.right[k] != drawn.c[0]) return false;
    return true;
  }
  [[nodiscard]] bool mirrors() const {
    if (1 - (1 - t) != t) return true;  // 1 - t is not exact
    return reversed(split(kernel, drawn.reversed().curve(), 1 - t), columns) == halves;
  }
};

/// The number of trials that break a promise.
int broken(const SplitKernel& kernel, bool (Trial::*promise)() const) {
  Inputs inputs(8);
  int count = 0;
  for (const int degree : {0, 1, 2, 3, 5, 12, 30})
    for (int repeat = 0; repeat < 20; ++repeat)
      for (std::size_t k = 0; k < split_parameters.size() + 3; ++k) {
        Drawn drawn(kernel.info->form, degree, inputs);
        if (repeat % 5 == 4)
          for (double& value : drawn.c) value = std::ldexp(value, static_cast<int>(80 * inputs.symmetric()));
        const double t = k < split_parameters.size() ? split_parameters[k] : inputs.unit();
        const Trial trial{kernel, drawn, t, split(kernel, drawn.curve(), t), split_columns(drawn.form, 1), degree};
        count += (trial.*promise)() ? 0 : 1;
      }
  return count;
}

struct Promise {
  const char* name;
  bool SplitPromises::*made;
  bool (Trial::*kept)() const;
};
const std::vector<Promise> all_promises{
    {"keeps_ends", &SplitPromises::keeps_ends, &Trial::keeps_ends},
    {"shares_junction", &SplitPromises::shares_junction, &Trial::shares_junction},
    {"exact_at_zero", &SplitPromises::exact_at_zero, &Trial::exact_at_zero},
    {"exact_at_one", &SplitPromises::exact_at_one, &Trial::exact_at_one},
    {"reproduces_constants", &SplitPromises::reproduces_constants, &Trial::reproduces_constants},
    {"mirrors", &SplitPromises::mirrors, &Trial::mirrors},
};

class SplitPromise : public testing::TestWithParam<std::size_t> {};

TEST_P(SplitPromise, IsKeptAndNoneIsLeftOut) {
  const auto& kernel = split_kernels(1)[GetParam()];
  for (const auto& promise : all_promises) {
    const int count = broken(kernel, promise.kept);
    if (kernel.promises->*promise.made)
      EXPECT_EQ(count, 0) << promise.name;
    else
      EXPECT_GT(count, 0) << promise.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Roster, SplitPromise, testing::Range<std::size_t>(0, split_kernels(1).size()),
                         [](const auto& parameter) {
                           const auto& method = *split_kernels(1)[parameter.param].info;
                           return std::string(method.id) + "_" + std::string(name(method.form));
                         });

}  // namespace
}  // namespace bezierbench
