// SPDX-License-Identifier: MIT
// A batch kernel is right where its points have the bits of the scalar kernel's: all else is tested there.
#include "core/batch/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "core/batch/batch_test.hpp"
#include "core/evaluate/methods/barycentric_chebyshev.hpp"
#include "core/evaluate/methods/barycentric_uniform.hpp"

namespace bezierbench::batch {
namespace {

template <class Scalar>
std::vector<Scalar> batch_points(const BatchKernel<Scalar>& batch, const Kernel<Scalar>& kernel,
                                 const CurveView<Scalar>& curve, const std::vector<Scalar>& t) {
  const PreparedState<Scalar> prepared(kernel, curve);
  const auto d = static_cast<std::size_t>(curve.dimension);
  constexpr Scalar untouched = 77;
  std::vector<Scalar> by_axis(t.size() * d + 1, untouched);
  batch(prepared.get(), t, by_axis.data());
  EXPECT_EQ(by_axis.back(), untouched) << "wrote past the end";
  std::vector<Scalar> points(t.size() * d);
  for (std::size_t k = 0; k < t.size(); ++k)
    for (std::size_t axis = 0; axis < d; ++axis) points[k * d + axis] = by_axis[axis * t.size() + k];
  return points;
}

constexpr auto any = [](const auto& /*kernel*/) { return true; };

/// The batch kernel against the scalar one, on one curve.
template <class Scalar>
void expect_same_bits(const BatchKernel<Scalar>& batch, const Kernel<Scalar>& kernel, const CurveView<Scalar>& curve,
                      const std::vector<Scalar>& t) {
  const auto right = evaluate(kernel, curve, t);
  const auto ours = batch_points(batch, kernel, curve, t);
  for (std::size_t k = 0; k < right.size(); ++k)
    ASSERT_EQ(bits(ours[k]), bits(right[k]))
        << name(kernel.info->form) << " " << kernel.info->id << ", degree " << curve.degree << ", dimension "
        << curve.dimension << ", t = " << t[k / static_cast<std::size_t>(curve.dimension)] << ": " << ours[k] << " for "
        << right[k];
}

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
    for (const std::size_t length : lengths) expect_same_bits(batch, kernel, curve, parameters<Scalar>(length, inputs));
  }
}

class BatchTarget : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    if (!target().is_usable()) GTEST_SKIP() << "this processor has no " << target().name;
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

/// The nodes of both barycentric methods at this degree, among their neighbours, and each of them in all lanes.
template <class Scalar>
std::vector<Scalar> nodes_and_neighbours(int degree) {
  const Curve<Form::bernstein, Scalar, 1> any_curve = [degree] {
    Curve<Form::bernstein, Scalar, 1> zero(degree);
    for (int i = 0; i <= degree; ++i) zero(0, i) = 0;
    return zero;
  }();
  std::vector<Scalar> t;
  for (const auto& nodes :
       {BarycentricChebyshev::prepare(any_curve).nodes, BarycentricUniform::prepare(any_curve).nodes})
    for (const Scalar node : nodes)
      for (const Scalar each : {node, std::nextafter(node, Scalar(-1)), std::nextafter(node, Scalar(2)), node})
        t.push_back(each);
  constexpr std::size_t largest_block = 128;  // eight vectors of float
  for (const auto& nodes :
       {BarycentricChebyshev::prepare(any_curve).nodes, BarycentricUniform::prepare(any_curve).nodes})
    t.insert(t.end(), 2 * largest_block, nodes[degree / 2]);
  return t;
}

TEST_P(BatchTarget, HasThemAtNodes) {
  const auto expect_at_nodes = []<class Scalar>(Scalar /*type*/, int dimension, int degree) {
    Inputs inputs(static_cast<std::uint64_t>(degree));
    const auto t = nodes_and_neighbours<Scalar>(degree);
    for (const auto& kernel : kernels<Scalar>(dimension)) {
      const auto batch = find(target(), kernel);
      if (!batch || !kernel.evaluator->id.starts_with("barycentric")) continue;
      const auto drawn = coefficients<Scalar>(degree, dimension, inputs);
      expect_same_bits(batch, kernel, view<Scalar>(kernel.info->form, dimension, degree, drawn), t);
    }
  };
  for (int dimension = 1; dimension <= max_dimension; ++dimension)
    for (const int degree : {0, 1, 2, 5, 10, 33}) {
      expect_at_nodes(1.0, dimension, degree);
      expect_at_nodes(1.0F, dimension, degree);
    }
}

/// Curves that overflow, underflow or have coefficients that are not finite; with weights of both signs, and zero.
TEST_P(BatchTarget, HasThemForCurvesOfAllSizes) {
  const auto expect_on_curve = []<class Scalar>(Scalar /*type*/, std::size_t place, int dimension, int degree) {
    Inputs inputs(place);
    for (const auto& kernel : kernels<Scalar>(dimension)) {
      const auto batch = find(target(), kernel);
      if (!batch || kernel.converted != nullptr || !kernel.info->template supports<Scalar>(degree)) continue;
      const auto drawn = any_coefficients<Scalar>(place, degree, dimension, inputs);
      auto weights = any_coefficients<Scalar>(place / 2, degree, 1, inputs);
      weights[place % weights.size()] = 0;
      auto curve = view<Scalar>(kernel.info->form, dimension, degree, drawn);
      if (kernel.info->form == Form::rational && place % 2 != 0) curve.weights = weights;
      expect_same_bits(batch, kernel, curve, parameters<Scalar>(40, inputs));
    }
  };
  for (std::size_t place = 0; place < 32; ++place)
    for (const int degree : {1, 4, 11}) {
      expect_on_curve(1.0, place, 1 + degree % max_dimension, degree);
      expect_on_curve(1.0F, place, 1 + degree % max_dimension, degree);
    }
}

/// All methods but those whose last bits the library's pow decides.
TEST(Batch, OffersWhatItPromises) {
  for (const auto& target : built_targets())
    for (int dimension = 1; dimension <= max_dimension; ++dimension)
      for (const auto& kernel : kernels<double>(dimension))
        EXPECT_EQ(static_cast<bool>(find(target, kernel)), kernel.evaluator->bit_stable)
            << target.name << " " << name(kernel.info->form) << " " << kernel.info->id;
}

TEST(Batch, UsesTheTargetsThatTheKernelOfTheSystemNames) {
  std::ifstream file("/proc/cpuinfo");
  const std::string processor{std::istreambuf_iterator<char>(file), {}};
  const auto has = [&processor](const char* flag) { return processor.find(flag) != std::string::npos; };
  const auto usable = usable_targets();
  for (const auto& target : built_targets())  // every ARM processor has NEON
    EXPECT_EQ(std::count(usable.begin(), usable.end(), &target) == 1,
              target.name == "NEON" || has(target.name == "AVX2" ? " avx2" : " avx512vl"));
}

/// Every chain ends in the value that all of its steps, taken in its scalar type, lead to. A chain that the compiler
/// shortened would end in another one.
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
      for (std::size_t kind = 0; kind < operation_kinds; ++kind) {
        expect_work(works.side_by_side[kind]);
        expect_work(works.one_by_one[kind]);
        EXPECT_EQ(works.one_by_one[kind].chains[0].values, works.lanes);
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
