// SPDX-License-Identifier: MIT
// The conversions behind the erased interface, all axes at once and with degrees known at compile time, against the
// methods for numbers; and paths, which prepare what their evaluator prepares of the converted curve.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/convert/roster.hpp"
#include "core/evaluate/evaluation_test.hpp"
#include "core/evaluate/kernel/kernel_of.hpp"
#include "core/evaluate/via.hpp"

namespace bezierbench {
namespace {

constexpr int largest_degree = 9;

/// Numbers that no conversion keeps exact.
template <class Scalar>
std::vector<Scalar> coefficients(int count) {
  std::vector<Scalar> values;
  for (int k = 0; k < count; ++k) values.push_back(static_cast<Scalar>((k * 7919) % 1009) / Scalar(503) - Scalar(1));
  return values;
}

template <class Scalar>
bool same_bits(const std::vector<Scalar>& a, const std::vector<Scalar>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Scalar)) == 0;
}

template <class C, class Scalar, int Dimension>
void expect_same_conversion() {
  const auto* kernel = find_conversion<Scalar>(C::info.id, C::info.form, Dimension);
  ASSERT_NE(kernel, nullptr) << C::info.id;
  for (int n = C::info.min_degree; n <= largest_degree; ++n) {
    const auto given = coefficients<Scalar>((n + 1) * Dimension);
    const auto expected =
        C::convert(instantiate::load<C::info.form, Dimension>(view(C::info.form, Dimension, n, given)));
    std::vector<Scalar> wanted;
    instantiate::append(expected, wanted);
    std::vector<Scalar> converted(wanted.size());
    kernel->convert(view(C::info.form, Dimension, n, given), converted.data());
    EXPECT_TRUE(same_bits(converted, wanted)) << C::info.id << ", degree " << n << ", dimension " << Dimension;
  }
}

template <class Scalar, class... Cs>
void expect_same_conversions(TypeList<Cs...> /*conversions*/) {
  (expect_same_conversion<Cs, Scalar, 1>(), ...);
  (expect_same_conversion<Cs, Scalar, 2>(), ...);
  (expect_same_conversion<Cs, Scalar, 3>(), ...);
}

TEST(ConversionKernels, HaveTheBitsOfTheMethodForNumbers) {
  expect_same_conversions<double>(GivenTargets<Conversions>::Type());
  expect_same_conversions<float>(GivenTargets<Conversions>::Type());
}

/// Points of a path are those of its evaluator on the converted coefficients.
template <class Scalar>
void expect_paths_to_be_compositions(int dimension) {
  const std::vector<Scalar> t{0, Scalar(0.3), Scalar(0.5), 1};
  for (const auto& path : kernels<Scalar>(dimension)) {
    if (path.conversion == nullptr || !is_given(path.evaluated_form)) continue;
    const auto& second = *find_kernel<Scalar>(path.evaluator->id, path.evaluated_form, dimension);
    for (int n = path.info->min_degree; n <= 5; ++n) {
      const auto given = coefficients<Scalar>((n + 1) * dimension);
      std::vector<Scalar> converted;
      path.converted(view(path.info->form, dimension, n, given), converted);
      EXPECT_TRUE(same_bits(evaluate(path, view(path.info->form, dimension, n, given), t),
                            evaluate(second, view(path.evaluated_form, dimension, n, converted), t)))
          << path.info->id << ", degree " << n << ", dimension " << dimension;
    }
  }
}

TEST(ConversionKernels, PathsAreCompositions) {
  for (const int dimension : {1, 2, 3}) {
    expect_paths_to_be_compositions<double>(dimension);
    expect_paths_to_be_compositions<float>(dimension);
  }
}

}  // namespace
}  // namespace bezierbench
