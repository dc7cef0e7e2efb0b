// SPDX-License-Identifier: MIT
// What the tests of batch kernels share: what counts as the same bits, and inputs that take every branch.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/batch/batch.hpp"
#include "core/evaluate/evaluation_test.hpp"

namespace bezierbench::batch {

/// The bits that stand for every NaN: which NaN results depends on the order of operands, which compilers choose.
template <class Scalar>
auto bits(Scalar value) {
  using Bits = std::conditional_t<sizeof(Scalar) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(std::isnan(value) ? std::numeric_limits<Scalar>::quiet_NaN() : value);
}

/// Ends, middle and its neighbours, zeros of both signs, subnormals, large numbers, infinities and NaN, then random t.
template <class Scalar>
std::vector<Scalar> parameters(std::size_t count, Inputs& inputs) {
  using Limits = std::numeric_limits<Scalar>;
  const Scalar half = 0.5;
  std::vector<Scalar> t{0,
                        1,
                        half,
                        std::nextafter(half, Scalar(0)),
                        std::nextafter(half, Scalar(1)),
                        -Scalar(0),
                        std::nextafter(Scalar(1), Scalar(0)),
                        std::nextafter(Scalar(1), Scalar(2)),
                        Limits::denorm_min(),
                        -Limits::denorm_min(),
                        Limits::min() / 2,
                        Scalar(-0.25),
                        Scalar(1.5),
                        Scalar(-30),
                        Scalar(1000),
                        Limits::infinity(),
                        Limits::quiet_NaN()};
  while (t.size() < count) {
    const double drawn = inputs.unit();
    t.push_back(static_cast<Scalar>(t.size() % 5 == 0 ? 3 * inputs.symmetric() : drawn));
  }
  std::swap(t[0], t[t.size() / 2]);
  t.resize(count);
  return t;
}

template <class Scalar>
std::vector<Scalar> coefficients(int degree, int dimension, Inputs& inputs) {
  std::vector<Scalar> result;
  for (const double value : inputs.coefficients(degree, dimension)) result.push_back(static_cast<Scalar>(value));
  return result;
}

/// Curves of all sizes: subnormal ones, large ones, ones that overflow, some coefficients zero, infinite or NaN.
template <class Scalar>
std::vector<Scalar> any_coefficients(std::size_t curve, int degree, int dimension, Inputs& inputs) {
  using Limits = std::numeric_limits<Scalar>;
  auto values = coefficients<Scalar>(degree, dimension, inputs);
  constexpr std::size_t kinds = 8;
  const Scalar scale = curve % kinds == 1   ? Limits::denorm_min() * 1000
                       : curve % kinds == 3 ? Limits::max() / 4
                       : curve % kinds == 5 ? Limits::min()
                                            : Scalar(1);
  for (Scalar& value : values) value *= scale;
  if (curve % kinds == 6) values[curve % values.size()] = curve < kinds ? Limits::infinity() : Limits::quiet_NaN();
  if (curve % kinds == 7) values[curve % values.size()] = -Scalar(0);
  return values;
}

/// For tests whose parameter is a place among built_targets(); GoogleTest takes no hyphen.
inline std::string name_of_target(const testing::TestParamInfo<std::size_t>& place) {
  std::string name(built_targets()[place.param].name);
  std::erase(name, '-');
  return name;
}

}  // namespace bezierbench::batch
