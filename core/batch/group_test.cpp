// SPDX-License-Identifier: MIT
// A group's points and coefficients have the bits of the scalar kernel's, curve by curve: all else is tested there.
#include <gtest/gtest.h>

#include <string_view>

#include "core/batch/batch.hpp"
#include "core/batch/batch_test.hpp"

namespace bezierbench::batch {
namespace {

/// A group as it is laid out, and as the scalar kernels take it.
template <class Scalar>
struct Group {
  Group(int group_degree, int group_dimension, Inputs& inputs) : degree(group_degree), dimension(group_dimension) {
    t = parameters<Scalar>(2 * curves_at_once, inputs);
    t.erase(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(inputs.unit() * curves_at_once));
    t.resize(curves_at_once);
    for (std::size_t k = 0; k < curves_at_once; ++k)
      curves.push_back(any_coefficients<Scalar>(k, degree, dimension, inputs));
  }

  std::vector<Scalar> side_by_side(const std::vector<std::vector<Scalar>>& each) const {
    std::vector<Scalar> all(each[0].size() * curves_at_once);
    for (std::size_t k = 0; k < curves_at_once; ++k)
      for (std::size_t i = 0; i < each[k].size(); ++i) all[i * curves_at_once + k] = each[k][i];
    return all;
  }

  int degree;
  int dimension;
  std::vector<Scalar> t;
  std::vector<std::vector<Scalar>> curves;
};

constexpr double untouched = 77;

template <class Scalar>
void expect_same(const std::vector<Scalar>& ours, const std::vector<Scalar>& right, const Kernel<Scalar>& kernel,
                 const Group<Scalar>& group, std::string_view what) {
  ASSERT_EQ(ours.size(), right.size() + 1);
  EXPECT_EQ(ours.back(), Scalar(untouched)) << kernel.info->id << " wrote past the end";
  for (std::size_t k = 0; k < right.size(); ++k)
    ASSERT_EQ(bits(ours[k]), bits(right[k]))
        << kernel.info->id << ", " << what << ", degree " << group.degree << ", dimension " << group.dimension
        << ", t = " << group.t[k % curves_at_once] << ": " << ours[k] << " for " << right[k];
}

/// The coefficients that the kernel evaluates, converted one by one; where there is a conversion of groups, it too.
template <class Scalar>
std::vector<Scalar> evaluated_coefficients(const GroupKernel<Scalar>& found, const Kernel<Scalar>& kernel,
                                           const Group<Scalar>& group) {
  const auto given = group.side_by_side(group.curves);
  if (kernel.converted == nullptr) return given;
  std::vector<std::vector<Scalar>> each(curves_at_once);
  for (std::size_t k = 0; k < curves_at_once; ++k)
    kernel.converted(view<Scalar>(kernel.info->form, group.dimension, group.degree, group.curves[k]), each[k]);
  auto right = group.side_by_side(each);
  if (found.convert == nullptr) return right;
  std::vector<Scalar> ours(right.size() + 1, Scalar(untouched));
  found.convert(group.degree, given.data(), ours.data());
  expect_same(ours, right, kernel, group, "conversion");
  return right;
}

template <class Scalar, class Wanted>
void expect_group_bits(const Target& target, int dimension, int degree, Wanted wanted) {
  Inputs inputs(static_cast<std::uint64_t>(degree * max_dimension + dimension));
  for (const auto& kernel : kernels<Scalar>(dimension)) {
    const auto found = find_group(target, kernel);
    if (!found.evaluate || !wanted(kernel) || !kernel.info->template supports<Scalar>(degree)) continue;
    Group<Scalar> group(degree, dimension, inputs);
    // Conversions to integers take finite numbers.
    if (kernel.converted != nullptr && found.convert == nullptr)
      for (auto& curve : group.curves) curve = coefficients<Scalar>(degree, dimension, inputs);
    std::vector<Scalar> right(static_cast<std::size_t>(dimension) * curves_at_once);
    for (std::size_t k = 0; k < curves_at_once; ++k) {
      const auto curve = view<Scalar>(kernel.info->form, dimension, degree, group.curves[k]);
      const auto point = evaluate(kernel, curve, std::vector<Scalar>{group.t[k]});
      for (std::size_t axis = 0; axis < point.size(); ++axis) right[axis * curves_at_once + k] = point[axis];
    }
    std::vector<Scalar> ours(right.size() + 1, Scalar(untouched));
    found.evaluate(degree, evaluated_coefficients(found, kernel, group).data(), group.t.data(), ours.data());
    expect_same(ours, right, kernel, group, "points");
  }
}

constexpr auto any_group = [](const auto& /*kernel*/) { return true; };

class GroupTarget : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    if (!target().is_usable()) GTEST_SKIP() << "this processor has no " << target().name;
  }
  [[nodiscard]] static const Target& target() { return built_targets()[GetParam()]; }
};

TEST_P(GroupTarget, HasTheBitsOfTheScalarKernel) {
  for (int dimension = 1; dimension <= max_dimension; ++dimension)
    for (int degree = 0; degree <= 26; ++degree) {
      expect_group_bits<double>(target(), dimension, degree, any_group);
      expect_group_bits<float>(target(), dimension, degree, any_group);
    }
}

/// Exact conversion would take minutes there.
TEST_P(GroupTarget, HasThemAtHighDegrees) {
  const auto in_floating_point = [&](const auto& kernel) {
    return kernel.converted == nullptr || find_group(target(), kernel).convert != nullptr;
  };
  for (const int degree : {54, 56, max_degree_of_groups}) {
    expect_group_bits<double>(target(), 2, degree, in_floating_point);
    expect_group_bits<float>(target(), 2, degree, in_floating_point);
  }
  const auto as_given = [](const auto& kernel) { return kernel.converted == nullptr; };
  for (int dimension = 1; dimension <= max_dimension; ++dimension)
    expect_group_bits<float>(target(), dimension, max_degree_of_groups, as_given);
}

/// What goes side by side on one curve does so on many, unless lanes come back to the curve, curves have weights,
/// `prepare` takes other scalars, or it asks for the places of its numbers. All conversions do but exact ones.
TEST(Group, OffersWhatBatchesDo) {
  for (const auto& target : built_targets())
    for (const auto& kernel : kernels<double>(2)) {
      const auto found = find_group(target, kernel);
      const bool comes_back = kernel.evaluator->id == "correctly_rounded";
      const bool has_weights = kernel.info->form == Form::rational;
      const bool is_barycentric = kernel.evaluator->id.starts_with("barycentric");
      const bool asks_for_places = kernel.evaluator->id == "de_casteljau_fixed_point";
      const bool is_left_out = comes_back || has_weights || is_barycentric || asks_for_places;
      EXPECT_TRUE(found.evaluate || is_left_out || !find(target, kernel)) << target.name << " " << kernel.info->id;
      EXPECT_TRUE(found.convert || kernel.conversion == nullptr || kernel.conversion->id.starts_with("exact"))
          << target.name << " " << kernel.info->id;
    }
}

INSTANTIATE_TEST_SUITE_P(All, GroupTarget, testing::Range(std::size_t(0), built_targets().size()), name_of_target);

}  // namespace
}  // namespace bezierbench::batch
