// SPDX-License-Identifier: MIT
#include "experiments/sample/curve_slice.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "experiments/failure.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::sample {
namespace {

constexpr suite::Kind any_kind{.id = "any", .about = "", .own = {}, .methods_example = ""};

/// Two cubics, a line and a quarter circle; the first cubic has stored parameters.
std::shared_ptr<const LoadedSet> small_set() {
  auto set = std::make_shared<LoadedSet>();
  set->id = "small";
  set->sha256 = "0123";
  const std::array<double, 8> cubic{100, 200, 101, 203, 104.5, 202, 103, 200.25};
  const std::array<double, 8> other{-1, 0, 0, 1, 1, 0, 2, -3};
  const std::array<double, 4> line{0, 0, 5, 1};
  const std::array<double, 6> circle{1, 0, 1, 1, 0, 1};
  const std::array<double, 3> weights{1, 0.5, 1};
  const std::array<double, 3> stored{0, 0.25, 1};
  set->curves.add("first", {Form::bernstein, 2, 3, cubic}, true, stored);
  set->curves.add("line", {Form::bernstein, 2, 1, line});
  set->curves.add("second", {Form::bernstein, 2, 3, other});
  set->curves.add("circle", {Form::rational, 2, 2, circle, weights});
  return set;
}

suite::Study small_study() {
  suite::Study study;
  study.id = "s";
  study.kind = &any_kind;
  study.curves = {"small"};
  study.dimension.clear();
  study.sets = {small_set()};
  study.parameters = 5;
  return study;
}

Trial drawn(const suite::Study& study, std::uint64_t trial, std::uint64_t seed = 1) {
  Trial out;
  Sampler(seed, study.id, cells(study).front()).draw(trial, out);
  return out;
}

TEST(CurveSlice, AStudyOfASetIsOneOfEachFormAndDegree) {
  const auto studies = studies_of(small_study());
  ASSERT_EQ(studies.size(), 3U);
  EXPECT_EQ(studies[0].degree, std::vector{3});
  EXPECT_EQ(studies[0].trials, 2 * 5);
  EXPECT_EQ(studies[1].degree, std::vector{1});
  EXPECT_EQ(studies[2].form, Form::rational);
  auto cubics = small_study();
  cubics.degree = {3};
  EXPECT_EQ(studies_of(cubics).size(), 1U);
  cubics.degree = {7};
  EXPECT_THROW(studies_of(cubics), Failure);
}

TEST(CurveSlice, TrialsAreTheCurvesAtTheirParameters) {
  const auto study = studies_of(small_study()).front();
  std::set<double> parameters;
  for (std::uint64_t trial = 0; trial < 10; ++trial) {
    const auto one = drawn(study, trial);
    const auto curve = study.slice->curve(trial / 5);
    EXPECT_TRUE(std::ranges::equal(one.coefficients, curve.coefficients));
    EXPECT_TRUE(one.weights.empty());
    EXPECT_TRUE(one.t >= 0 && one.t <= 1);
    parameters.insert(one.t);
    EXPECT_EQ(one.t, drawn(study, trial).t);
    EXPECT_NE(one.t, drawn(study, trial, 2).t);
  }
  EXPECT_EQ(parameters.size(), 10U);
  EXPECT_EQ(drawn(study, 10).t, drawn(study, 0).t) << "they begin again";
}

TEST(CurveSlice, AGridHasBothEnds) {
  auto study = small_study();
  study.parameters_from = suite::ParameterSource::grid;
  const auto cubics = studies_of(study).front();
  for (std::uint64_t k = 0; k < 5; ++k) EXPECT_EQ(drawn(cubics, 5 + k).t, static_cast<double>(k) / 4);
}

TEST(CurveSlice, StoredParametersAreThoseOfTheCurvesThatHaveSome) {
  auto study = small_study();
  study.parameters_from = suite::ParameterSource::stored;
  const auto studies = studies_of(study);
  ASSERT_EQ(studies.size(), 1U);
  EXPECT_EQ(studies[0].trials, 3);
  EXPECT_EQ(studies[0].slice->curve_id(0), "first");
  EXPECT_EQ(drawn(studies[0], 1).t, 0.25);
}

TEST(CurveSlice, RationalCurvesKeepTheirWeights) {
  const auto one = drawn(studies_of(small_study()).back(), 0);
  EXPECT_EQ(one.weights, (std::vector<double>{1, 0.5, 1}));
}

/// Placement moves or scales a curve as a whole, the same at all of its parameters, and stays within the range.
TEST(CurveSlice, PlacementKeepsTheShape) {
  auto study = small_study();
  study.placement = {suite::Placement::stored, suite::Placement::scaled, suite::Placement::translated};
  const auto studies = studies_of(study);
  ASSERT_EQ(studies.size(), 9U);
  const auto stored = drawn(studies[0], 0).coefficients;
  const auto scaled = drawn(studies[1], 0).coefficients;
  const auto translated = drawn(studies[2], 0).coefficients;
  EXPECT_EQ(scaled, drawn(studies[1], 4).coefficients);
  EXPECT_NE(scaled[0] / stored[0], drawn(studies[1], 5).coefficients[0] / drawn(studies[0], 5).coefficients[0]);
  const double factor = scaled[0] / stored[0];
  EXPECT_TRUE(factor >= 0.5 && factor < 1);
  for (std::size_t k = 0; k < stored.size(); ++k) {
    EXPECT_NEAR(scaled[k], factor * stored[k], std::abs(scaled[k]) * 0x1p-50);
    EXPECT_NEAR(translated[k] - translated[k % 2], stored[k] - stored[k % 2], studies[2].slice->range() * 0x1p-51);
    EXPECT_LE(std::abs(translated[k]), studies[2].slice->range());
  }
  EXPECT_NE(translated, stored);
}

TEST(CurveSlice, FurtherPointsLieAboutTheCurve) {
  auto cell = cells(studies_of(small_study()).front()).front();
  ++cell.degree;
  const Sampler sampler(1, "s", cell);
  for (std::uint64_t trial = 0; trial < 10; ++trial) {
    Trial one;
    sampler.draw(trial, one);
    ASSERT_EQ(one.coefficients.size(), 10U);
    EXPECT_EQ(one.t, drawn(studies_of(small_study()).front(), trial).t);
    const bool is_first = trial < 5;
    EXPECT_TRUE(is_first ? one.coefficients[8] >= 95.5 && one.coefficients[8] <= 109
                         : one.coefficients[8] >= -5 && one.coefficients[8] <= 6);
    EXPECT_TRUE(is_first ? one.coefficients[9] >= 195.5 && one.coefficients[9] <= 207.5
                         : one.coefficients[9] >= -7 && one.coefficients[9] <= 5);
  }
}

TEST(CurveSlice, ItsIdentityIsThatOfTheNumbers) {
  auto study = small_study();
  const auto key_of = [](const suite::Study& of) { return key(cells(studies_of(of).front()).front()); };
  const auto before = key_of(study);
  study.parameters = 6;
  EXPECT_NE(key_of(study), before);
  study.parameters = 5;
  EXPECT_EQ(key_of(study), before);
  auto other = std::make_shared<LoadedSet>(*small_set());
  other->sha256 = "4567";
  study.sets = {other};
  EXPECT_NE(key_of(study), before);
}

}  // namespace
}  // namespace bezierbench::sample
