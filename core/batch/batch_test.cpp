// SPDX-License-Identifier: MIT
// A batch kernel is right where its points have the bits of the scalar kernel's: all else is tested there.
#include "core/batch/batch.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "core/batch/batch_test.hpp"

namespace bezierbench::batch {
namespace {

template <class Scalar>
std::vector<Scalar> batch_points(const BatchKernel<Scalar>& batch, const Kernel<Scalar>& kernel,
                                 const CurveView<Scalar>& curve, const std::vector<Scalar>& t) {
  const std::size_t room = kernel.prepared_size + kernel.prepared_alignment;
  const auto memory = std::make_unique<std::byte[]>(room);
  void* prepared = memory.get();
  std::size_t space = room;
  std::align(kernel.prepared_alignment, kernel.prepared_size, prepared, space);
  kernel.prepare(curve, prepared);
  const auto d = static_cast<std::size_t>(curve.dimension);
  constexpr Scalar untouched = 77;
  std::vector<Scalar> by_axis(t.size() * d + 1, untouched);
  batch(prepared, t, by_axis.data());
  EXPECT_EQ(by_axis.back(), untouched) << "wrote past the end";
  std::vector<Scalar> points(t.size() * d);
  for (std::size_t k = 0; k < t.size(); ++k)
    for (std::size_t axis = 0; axis < d; ++axis) points[k * d + axis] = by_axis[axis * t.size() + k];
  return points;
}

constexpr auto any = [](const auto& /*kernel*/) { return true; };

/// Every kernel of the roster that has a batch kernel, against it.
template <class Scalar, class Wanted = decltype(any)>
void expect_same_bits(const Target& target, int dimension, int degree, const std::vector<std::size_t>& lengths,
                      Wanted wanted = any) {
  Inputs inputs(static_cast<std::uint64_t>(degree * max_dimension + dimension));
  for (const auto& kernel : kernels<Scalar>(dimension)) {
    const auto batch = find(target, kernel);
    if (!batch || !wanted(kernel) || !kernel.info->template supports<Scalar>(degree)) continue;
    const auto drawn = coefficients<Scalar>(degree, dimension, inputs);
    const auto curve = view<Scalar>(kernel.info->form, dimension, degree, drawn);
    for (const std::size_t length : lengths) {
      const auto t = parameters<Scalar>(length, inputs);
      const auto right = evaluate(kernel, curve, t);
      const auto ours = batch_points(batch, kernel, curve, t);
      for (std::size_t k = 0; k < right.size(); ++k)
        ASSERT_EQ(bits(ours[k]), bits(right[k]))
            << kernel.info->id << ", degree " << degree << ", dimension " << dimension
            << ", t = " << t[k / static_cast<std::size_t>(dimension)] << ": " << ours[k] << " for " << right[k];
    }
  }
}

class BatchTarget : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    if (!is_usable(target())) GTEST_SKIP() << "this processor has no " << target().name;
  }
  [[nodiscard]] static const Target& target() { return built_targets()[GetParam()]; }
};

constexpr int last_degree = 40;  // five sweeps of a triangle

TEST_P(BatchTarget, HasTheBitsOfTheScalarKernelInDouble) {
  for (int dimension = 1; dimension <= max_dimension; ++dimension)
    for (int degree = 0; degree <= last_degree; ++degree) expect_same_bits<double>(target(), dimension, degree, {150});
}

TEST_P(BatchTarget, HasTheBitsOfTheScalarKernelInFloat) {
  for (int dimension = 1; dimension <= max_dimension; ++dimension)
    for (int degree = 0; degree <= last_degree; ++degree) expect_same_bits<float>(target(), dimension, degree, {290});
}

/// Blocks, single vectors and what is left of one, in every combination; nothing at all.
TEST_P(BatchTarget, HasThemForEveryLength) {
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length <= 140; ++length) lengths.push_back(length);
  for (int dimension = 1; dimension <= max_dimension; ++dimension) {
    expect_same_bits<double>(target(), dimension, 11, lengths);
    expect_same_bits<float>(target(), dimension, 11, lengths);
  }
}

/// Exact conversion would take minutes there.
TEST_P(BatchTarget, HasThemAtHighDegreesOnCurvesAsGiven) {
  const auto as_given = [](const auto& kernel) { return kernel.converted == nullptr; };
  for (const int degree : {100, 131, 500, 1023}) {
    expect_same_bits<double>(target(), 2, degree, {40}, as_given);
    expect_same_bits<float>(target(), 2, degree, {40}, as_given);
  }
}

std::set<std::string_view> offered(const Target& target) {
  std::set<std::string_view> ids;
  for (const auto& kernel : kernels<double>(2))
    if (find(target, kernel)) ids.insert(kernel.evaluator->id);
  return ids;
}

TEST(Batch, OffersWhatItPromises) {
  const std::set<std::string_view> promised{"de_casteljau",
                                            "de_casteljau_fma",
                                            "de_casteljau_lerp",
                                            "de_casteljau_lerp_fma",
                                            "de_casteljau_two_sided",
                                            "horner_bernstein",
                                            "horner_bernstein_fma",
                                            "volk_schumaker",
                                            "compensated_volk_schumaker",
                                            "correctly_rounded",
                                            "horner",
                                            "horner_fma",
                                            "compensated_horner",
                                            "horner_dd"};
  for (const auto& target : built_targets()) EXPECT_EQ(offered(target), promised) << target.name;
}

TEST(Batch, UsesEveryTargetThatThisProcessorHas) {
  std::vector<const Target*> usable;
  for (const auto& target : built_targets())
    if (is_usable(target)) usable.push_back(&target);
  EXPECT_EQ(usable_targets(), usable);
}

/// The last values are worked out in the type of the chains: no step of any of them is left out.
template <class Scalar>
void expect_work(const OperationWork<Scalar>& work) {
  const auto [chains, beside] = work.chains;
  std::vector<Scalar> values(chains.values, chains.first);
  values.resize(chains.values + beside.values, beside.first);
  values.push_back(0);
  work.run(work.operand, values.data());
  for (std::size_t k = 0; k < chains.values; ++k) EXPECT_EQ(values[k], chains.last);
  for (std::size_t k = 0; k < beside.values; ++k) EXPECT_EQ(values[chains.values + k], beside.last);
  EXPECT_EQ(values.back(), 0) << "wrote past the end";
}

TEST_P(BatchTarget, DoesTheWorkOfEveryKindOfOperation) {
  const auto expect_all = []<class Scalar>(WorksOfWidths<Scalar> widths) {
    for (const auto& works : widths) {
      const auto lanes = static_cast<double>(works.lanes);
      for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
        expect_work(works.side_by_side[kind]);
        expect_work(works.one_by_one[kind]);
        const double each = Operation(kind) == Operation::fused ? 2 : 1;
        EXPECT_EQ(works.one_by_one[kind].chains[0].values, works.lanes);
        EXPECT_EQ(works.side_by_side[kind].flops, each * lanes * works.side_by_side[kind].operations);
      }
      expect_work(works.multiply_add_and_add);
      EXPECT_GT(works.multiply_add_and_add.chains[1].values, 0U);
    }
    EXPECT_EQ(widths.front().lanes * sizeof(Scalar), 16U);
  };
  expect_all(works_of<float>(target()));
  expect_all(works_of<double>(target()));
}

INSTANTIATE_TEST_SUITE_P(All, BatchTarget, testing::Range(std::size_t(0), built_targets().size()), name_of_target);

}  // namespace
}  // namespace bezierbench::batch
