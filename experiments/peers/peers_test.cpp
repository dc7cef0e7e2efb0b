// SPDX-License-Identifier: MIT
#include "experiments/peers/peers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "core/evaluate/evaluation_test.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::peers {
namespace {

constexpr double u = 0x1p-53;

std::vector<const Kernel<double>*> all_kernels() {
  std::vector<const Kernel<double>*> all;
  for (const auto& peer : present())
    for (int dimension = 1; dimension <= 3; ++dimension)
      for (const auto& kernel : peer.kernels(dimension)) all.push_back(&kernel);
  return all;
}

std::string describe(const Kernel<double>& kernel, int degree) {
  return std::string(kernel.info->id) + ", dimension " + std::to_string(kernel.dimension) + ", degree " +
         std::to_string(degree);
}

/// The distance from the true point over u times what rounding is amplified by on the way that the method takes: p~, or
/// for the one that leaves Bernstein form the sum |b_i| C(n,i) t^i (1+t)^(n-i) of a conversion to power form.
double error_in_u(const Kernel<double>& kernel, const CurveView<double>& curve, double t,
                  std::span<const double> point) {
  const bool converts = kernel.info->id == "peer_occt_cached";
  const ErrorBound unit{
      .text = "",
      .amplification = converts ? Amplification::bernstein_to_power : Amplification::p_tilde_bernstein,
      .factor = [](int, double) { return 1.0; },
      .underflow = [](int) { return 0.0; },
      .underflow_scales_with_coefficients = false};
  reference::ExactCurve exact;
  reference::TrialScale scale;
  scale.set(curve, t);
  return reference::Distance(exact.point(curve, t)).to(point) / scale.bound(unit, reference::double_arithmetic);
}

constexpr double allowed = 64;

TEST(Peers, AreThereOrSayHowToHaveThem) {
  std::set<std::string_view> ids;
  for (const auto& peer : present()) {
    EXPECT_TRUE(ids.insert(peer.id).second) << peer.id;
    EXPECT_FALSE(peer.library_version.empty()) << peer.id;
    EXPECT_EQ(peer.kernels(2).size() + peer.arc_length_kernels(2).size() + peer.projection_kernels(2).size(), 1U)
        << peer.id;
  }
  for (const auto& peer : absent()) {
    EXPECT_TRUE(ids.insert(peer.id).second) << peer.id;
    EXPECT_THAT(std::string(peer.remedy), testing::HasSubstr("-DBEZIERBENCH_PEERS=ON")) << peer.id;
  }
  EXPECT_FALSE(ids.empty());
}

TEST(Peers, GoByTheIdOfTheRosterAndPromiseNoBits) {
  for (const auto& peer : present())
    for (int dimension = 1; dimension <= 3; ++dimension)
      for (const auto& kernel : peer.kernels(dimension)) {
        EXPECT_EQ(kernel.info->id, peer.id);
        EXPECT_TRUE(kernel.info->id.starts_with("peer_"));
        EXPECT_EQ(kernel.dimension, dimension) << peer.id;
        EXPECT_FALSE(kernel.info->bit_stable) << peer.id;
        EXPECT_FALSE(kernel.info->bound) << peer.id;
      }
}

TEST(Peers, ErrAsLittleAsAMethodMayAtSmallDegrees) {
  Inputs inputs(1);
  for (const auto* kernel : all_kernels())
    for (int degree = kernel->info->min_degree; degree <= 5; ++degree)
      for (int trial = 0; trial < 50; ++trial) {
        const auto coefficients = inputs.coefficients(degree, kernel->dimension);
        const auto curve = view<double>(Form::bernstein, kernel->dimension, degree, coefficients);
        const double t = inputs.unit();
        EXPECT_LE(error_in_u(*kernel, curve, t, evaluate(*kernel, curve, {t})), allowed)
            << describe(*kernel, degree) << ", t = " << t;
      }
}

TEST(Peers, EndAtTheirFirstAndLastControlPoints) {
  Inputs inputs(2);
  for (const auto* kernel : all_kernels())
    for (const int degree : {1, 3, 10, 20}) {
      const auto coefficients = inputs.coefficients(degree, kernel->dimension);
      const auto curve = view<double>(Form::bernstein, kernel->dimension, degree, coefficients);
      const auto d = static_cast<std::size_t>(kernel->dimension);
      const auto points = evaluate(*kernel, curve, {0, 1});
      const std::span all(points);
      EXPECT_LE(error_in_u(*kernel, curve, 0, all.first(d)), allowed) << describe(*kernel, degree) << ", t = 0";
      EXPECT_LE(error_in_u(*kernel, curve, 1, all.last(d)), allowed) << describe(*kernel, degree) << ", t = 1";
    }
}

// (t, 3 t^2 - 2 t^3): control points of both axes are known from the definition.
TEST(Peers, EvaluateAKnownCubic) {
  const std::vector<double> coefficients{0, 0, 1.0 / 3, 0, 2.0 / 3, 1, 1, 1};
  const auto curve = view<double>(Form::bernstein, 2, 3, coefficients);
  for (const auto& peer : present())
    for (const auto& kernel : peer.kernels(2)) {
      const auto point = evaluate(kernel, curve, {0.25});
      EXPECT_NEAR(point[0], 0.25, 8 * u) << peer.id;
      EXPECT_NEAR(point[1], 0.15625, 8 * u) << peer.id;
    }
}

TEST(Peers, TakeTheLargestDegreeThatTheyPromise) {
  Inputs inputs(3);
  for (const auto* kernel : all_kernels()) {
    const int degree = kernel->info->max_degree;
    const auto coefficients = inputs.coefficients(degree, kernel->dimension);
    const auto curve = view<double>(Form::bernstein, kernel->dimension, degree, coefficients);
    for (const double t : {0.0, 0.25, 0.5, 1.0})
      for (const double value : evaluate(*kernel, curve, {t}))
        EXPECT_LE(std::abs(value), 1.001) << describe(*kernel, degree) << ", t = " << t;  // inside the convex hull
  }
}

TEST(Peers, OfOneLibraryDoNotDisturbEachOther) {
  Inputs inputs(4);
  const auto high = inputs.coefficients(20, 2);
  const auto low = inputs.coefficients(3, 2);
  const auto cubic = view<double>(Form::bernstein, 2, 3, low);
  for (const auto& peer : present())
    for (const auto& kernel : peer.kernels(2)) {
      (void)evaluate(kernel, view<double>(Form::bernstein, 2, 20, high), {0.3});
      EXPECT_LE(error_in_u(kernel, cubic, 0.3, evaluate(kernel, cubic, {0.3})), allowed) << peer.id;
    }
}

/// (t, t^2), whose length to t is known, with parts, and (3 u^2, 3 u^3), u = 2t - 1, whose cusp GSL cannot integrate to
/// every tolerance, which must not end the program.
TEST(Peers, MeasureKnownLengths) {
  const std::vector<double> parabola{0, 0, 0.5, 0, 1, 1};
  const std::vector<double> cusp{3, -3, -1, 3, -1, -3, 3, 3};
  const auto to = [](double t) { return t * std::sqrt(1 + 4 * t * t) / 2 + std::asinh(2 * t) / 4; };
  const double cusp_length = 2 * (13 * std::sqrt(13) - 8) / 9;
  for (const auto& peer : present())
    for (const auto& kernel : peer.arc_length_kernels(2)) {
      EXPECT_EQ(kernel.info->id, peer.id);
      EXPECT_FALSE(kernel.info->bit_stable) << peer.id;
      const auto whole = kernel.measure({Form::bernstein, 2, 2, parabola}, 0, 1, 1e-9);
      EXPECT_NEAR(whole.length, to(1), 1e-8) << peer.id;
      const auto part = kernel.measure({Form::bernstein, 2, 2, parabola}, 0.25, 0.75, 1e-9);
      EXPECT_NEAR(part.length, to(0.75) - to(0.25), 1e-8) << peer.id;
      EXPECT_NEAR(kernel.measure({Form::bernstein, 2, 3, cusp}, 0, 1, 1e-15).length, cusp_length, 1e-3) << peer.id;
    }
}

TEST(Peers, MeasureTheSameLengthInSpace) {
  const std::vector<double> parabola{0, 0, 0.5, 0, 1, 1};
  const std::vector<double> upright{0, 7, 0, 0.5, 7, 0, 1, 7, 1};
  for (const auto& peer : present())
    for (const auto& kernel : peer.arc_length_kernels(3)) {
      EXPECT_EQ(kernel.dimension, 3) << peer.id;
      EXPECT_NEAR(kernel.measure({Form::bernstein, 3, 2, upright}, 0.25, 1, 1e-9).length,
                  peer.arc_length_kernels(2)[0].measure({Form::bernstein, 2, 2, parabola}, 0.25, 1, 1e-9).length, 1e-12)
          << peer.id;
    }
}

/// (t, t^2) and (0, 5/4): the foot points are t = sqrt(3)/2 > 1/2 and, by symmetry, one outside [0, 1].
TEST(Peers, ProjectOntoAParabola) {
  const std::vector<double> parabola{0, 0, 0.5, 0, 1, 1};
  const std::vector<double> point{0, 1.25};
  for (const auto& peer : present())
    for (const auto& kernel : peer.projection_kernels(2)) {
      EXPECT_EQ(kernel.info->id, peer.id);
      EXPECT_FALSE(kernel.info->bit_stable) << peer.id;
      const auto foot = kernel.project({Form::bernstein, 2, 2, parabola}, point);
      EXPECT_NEAR(foot.t, std::sqrt(3) / 2, 1e-5) << peer.id;
      EXPECT_NEAR(foot.distance, 1, 1e-9) << peer.id;  // |(sqrt(3)/2, 3/4 - 5/4)|
    }
}

std::vector<double> point_of(const PreparedState<double>& prepared, double t) {
  std::vector<double> point(static_cast<std::size_t>(prepared.kernel().dimension));
  prepared.evaluate(std::span<const double>(&t, 1), point.data());
  return point;
}

TEST(Peers, EvaluateOnAnotherThreadThanTheyWerePreparedOn) {
  Inputs inputs(5);
  for (const auto* kernel : all_kernels()) {
    const auto coefficients = inputs.coefficients(7, kernel->dimension);
    const auto curve = view<double>(Form::bernstein, kernel->dimension, 7, coefficients);
    const PreparedState<double> prepared(*kernel, curve);  // which another thread may evaluate
    const auto here = point_of(prepared, 0.7);
    std::vector<double> there;
    std::thread([&] { there = point_of(prepared, 0.7); }).join();
    EXPECT_EQ(here, there) << describe(*kernel, 7);
  }
}

TEST(Peers, GiveTheSameBitsOnSeveralThreadsAtOnce) {
  constexpr int curves = 200;
  Inputs inputs(6);
  for (const auto* kernel : all_kernels()) {
    std::vector<std::vector<double>> coefficients;
    coefficients.reserve(curves);
    for (int k = 0; k < curves; ++k) coefficients.push_back(inputs.coefficients(3 + k % 8, kernel->dimension));
    const auto points = [&] {
      std::vector<std::vector<double>> all;
      all.reserve(curves);
      for (int k = 0; k < curves; ++k)
        all.push_back(evaluate(
            *kernel,
            view<double>(Form::bernstein, kernel->dimension, 3 + k % 8, coefficients[static_cast<std::size_t>(k)]),
            {0.1, 0.9}));
      return all;
    };
    const auto alone = points();
    std::array<std::vector<std::vector<double>>, 4> together;
    {
      std::vector<std::jthread> threads;
      threads.reserve(together.size());
      for (auto& one : together) threads.emplace_back([&] { one = points(); });
    }
    for (const auto& one : together) EXPECT_EQ(one, alone) << kernel->info->id;
  }
}

}  // namespace
}  // namespace bezierbench::peers
