// SPDX-License-Identifier: MIT
// A method that does something wrong must be found by the properties that it breaks, and by no others.
#include "experiments/requirements/requirements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace bezierbench::requirements {
namespace {

/// What is wrong with a method: changes a coordinate of the point at t[k].
using Fault = double (*)(double value, std::size_t k, std::span<const double> t);
Fault fault;

template <int Dimension>
void evaluate_wrongly(const void* prepared, std::span<const double> t, double* points) {
  // The function for max_degree evaluates curves of every degree.
  static const auto right = find_kernel<double>("de_casteljau", Form::bernstein, Dimension)->evaluate_for(max_degree);
  right(prepared, t, points);
  for (std::size_t k = 0; k < t.size(); ++k) points[k * Dimension] = fault(points[k * Dimension], k, t);
}

/// The properties that de Casteljau's algorithm loses by a fault in the first coordinate.
std::vector<std::string_view> lost_by(Fault one) {
  fault = one;
  std::array<Kernel<double>, 3> wrong{*find_kernel<double>("de_casteljau", Form::bernstein, 1),
                                      *find_kernel<double>("de_casteljau", Form::bernstein, 2),
                                      *find_kernel<double>("de_casteljau", Form::bernstein, 3)};
  wrong[0].evaluate_for = for_every_degree<double, evaluate_wrongly<1>>;
  wrong[1].evaluate_for = for_every_degree<double, evaluate_wrongly<2>>;
  wrong[2].evaluate_for = for_every_degree<double, evaluate_wrongly<3>>;
  const Evaluator method{{&wrong[0], &wrong[1], &wrong[2]}, find_kernel<float>("de_casteljau", Form::bernstein, 2)};
  std::vector<std::string_view> lost;
  for (const auto& property : properties()) {
    EXPECT_TRUE(property.concerns(method.info())) << property.id;
    const auto outcome = property.decide(method);
    EXPECT_EQ(outcome.broken() == 0, outcome.first().empty());
    if (outcome.broken() > 0) lost.push_back(property.id);
  }
  return lost;
}

TEST(Properties, AreKeptByARightMethod) {
  EXPECT_THAT(lost_by([](double value, std::size_t, std::span<const double>) { return value; }), testing::IsEmpty());
}

TEST(Properties, AreLostByAConstantOffset) {
  EXPECT_THAT(lost_by([](double value, std::size_t, std::span<const double>) { return value + 1e-6; }),
              testing::ElementsAre("bound", "bound_underflow", "mild_curves", "constants", "affine_maps",
                                   "powers_of_two", "axes", "end_points"));
}

TEST(Properties, AreLostByAnErrorThatGrowsWithT) {
  EXPECT_THAT(lost_by([](double value, std::size_t k, std::span<const double> t) { return value * (1 + 1e-6 * t[k]); }),
              testing::ElementsAre("bound", "bound_underflow", "bound_overflow", "mild_curves", "constants",
                                   "affine_maps", "reversal", "axes", "end_points"));
}

template <int Dimension>
void prepare_cubic(const CurveView<double>& curve, void* prepared) {
  ASSERT_EQ(curve.degree, 3);
  find_kernel<double>("de_casteljau", Form::bernstein, Dimension)->prepare(curve, prepared);
}

void prepare_cubic_in_float(const CurveView<float>& curve, void* prepared) {
  ASSERT_EQ(curve.degree, 3);
  find_kernel<float>("de_casteljau", Form::bernstein, 2)->prepare(curve, prepared);
}

TEST(Properties, AreDecidedAtTheDegreesOfTheMethod) {
  auto info = *find_kernel<double>("de_casteljau", Form::bernstein, 2)->info;
  info.min_degree = info.max_degree = info.max_degree_float = 3;
  std::array<Kernel<double>, 3> cubic{*find_kernel<double>("de_casteljau", Form::bernstein, 1),
                                      *find_kernel<double>("de_casteljau", Form::bernstein, 2),
                                      *find_kernel<double>("de_casteljau", Form::bernstein, 3)};
  cubic[0].prepare = prepare_cubic<1>;
  cubic[1].prepare = prepare_cubic<2>;
  cubic[2].prepare = prepare_cubic<3>;
  for (auto& kernel : cubic) kernel.info = &info;
  auto in_float = *find_kernel<float>("de_casteljau", Form::bernstein, 2);
  in_float.prepare = prepare_cubic_in_float;
  in_float.info = &info;
  for (const auto& property : properties()) {
    const auto outcome = property.decide({{&cubic[0], &cubic[1], &cubic[2]}, &in_float});
    EXPECT_EQ(outcome.broken(), 0) << property.id << ": " << outcome.first();
  }
}

TEST(Properties, AreLostByTheLastOfMany) {
  EXPECT_THAT(lost_by([](double value, std::size_t k, std::span<const double> t) {
                return k > 0 && k + 1 == t.size() ? value / 2 : value;
              }),
              testing::IsSupersetOf({"bound", "batches", "end_points"}));
}

}  // namespace
}  // namespace bezierbench::requirements
