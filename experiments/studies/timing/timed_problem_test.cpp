// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/bundle/csv.hpp"
#include "experiments/failure.hpp"
#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/arc_length/problem.hpp"
#include "experiments/studies/bspline/problem.hpp"
#include "experiments/studies/derivative/problem.hpp"
#include "experiments/studies/fitting/problem.hpp"
#include "experiments/studies/grid/problem.hpp"
#include "experiments/studies/interpolation/problem.hpp"
#include "experiments/studies/inverse_arc_length/problem.hpp"
#include "experiments/studies/projection/problem.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/subdivision/problem.hpp"
#include "experiments/studies/timing/timing_rows.hpp"

namespace bezierbench::studies {
namespace {

using testing::ElementsAre;

suite::Study study_of(std::vector<std::string> methods) {
  suite::Study study;
  study.id = "race";
  study.kind = &kind("timing");
  study.degree = {3};
  study.methods = std::move(methods);
  study.modes = {suite::Mode::one_shot};
  return study;
}

suite::Study derivatives(std::vector<std::string> methods, std::vector<int> order = {2}) {
  auto study = study_of(std::move(methods));
  study.order = std::move(order);
  return study;
}

suite::Study lengths(std::vector<std::string> methods, std::vector<double> tolerance = {1e-6}) {
  auto study = study_of(std::move(methods));
  study.tolerance = std::move(tolerance);
  return study;
}

suite::Study splines(std::vector<std::string> methods, std::vector<int> points = {12}) {
  auto study = study_of(std::move(methods));
  study.degree = {};
  study.points = std::move(points);
  return study;
}

suite::Study fits(std::vector<std::string> methods, std::vector<double> tolerance = {1e-2}) {
  auto study = lengths(std::move(methods), std::move(tolerance));
  study.points = {10};
  return study;
}

suite::Study grids(std::vector<std::string> methods) {
  auto study = study_of(std::move(methods));
  study.points = {17};
  return study;
}

race::JudgedRivals rivals_of(const suite::Study& study) {
  const auto& problem = timed_problem(study);
  std::shared_ptr<const void> trials;
  return problem.rivals(problem.races(study).front(), study, 1, trials);
}

std::vector<bool> right_of(const race::JudgedRivals& rivals) {
  std::vector<bool> right;
  for (const auto& one : rivals.judged) right.push_back(one.right);
  return right;
}

std::vector<bool> right(const suite::Study& study) { return right_of(rivals_of(study)); }

/// One of every problem, the first method a right one.
std::vector<suite::Study> one_of_each() {
  return {study_of({"de_casteljau", "direct"}),
          derivatives({"differences_de_casteljau", "differences_horner", "triangle_derivatives"}),
          lengths({"gauss_legendre_adaptive", "adaptive_simpson38"}),
          lengths({"bracketed_newton", "halley"}),
          study_of({"quintic_isolate", "scan_refine"}),
          splines({"c2_natural", "c2_natural_handles"}),
          fits({"schneider", "gauss_newton"}),
          grids({"pointwise_de_casteljau", "forward_differencing"}),
          study_of({"de_boor", "knot_insertion_span", "chudy_wozny_span"}),
          study_of({"de_casteljau_split", "lerp_split", "matrix_split"}),
          study_of({"easing_correctly_rounded", "easing_halley"})};
}

/// A study with the axes of the problem and these methods.
suite::Study study_for(Problem problem, const std::string& methods) {
  switch (problem) {
    case Problem::derivative: return derivatives({methods});
    case Problem::flattening:
    case Problem::arc_length:
    case Problem::inverse_arc_length: return lengths({methods});
    case Problem::interpolation: return splines({methods});
    case Problem::fitting: return fits({methods});
    case Problem::grid: return grids({methods});
    default: return study_of({methods});
  }
}

TEST(TimedProblem, EveryCompanionHasOne) {
  for (const auto* info : companion_infos())
    EXPECT_EQ(timed_kind(study_for(info->problem, std::string(info->id))).asks.problem, info->problem) << info->id;
}

TEST(TimedProblem, IsTheOneThatTheStudyNames) {
  const auto expect_named = [](Problem problem, const std::string& methods) {
    EXPECT_EQ(timed_kind(study_for(problem, methods)).asks.problem, problem) << methods;
  };
  expect_named(Problem::arc_length, "chord_sum");
  expect_named(Problem::arc_length, "gauss_legendre_*");
  expect_named(Problem::fitting, "schneider");
  expect_named(Problem::subdivision, "*_split");
  expect_named(Problem::grid, "forward_d*");
  expect_named(Problem::bspline, "*_span");
  expect_named(Problem::projection, "scan_?isect");
  expect_named(Problem::evaluation, "de_casteljau");
  expect_named(Problem::evaluation, "*");
  EXPECT_EQ(timed_kind(study_of({"*casteljau", "differences_*"})).asks.problem, Problem::evaluation);
}

TEST(TimedProblem, RivalsReproduceTheirResults) {
  for (const auto& study : one_of_each()) {
    const auto judged = rivals_of(study);
    ASSERT_EQ(judged.rivals.size(), study.methods.size()) << study.methods[0];
    EXPECT_THAT(right_of(judged), testing::Each(true)) << study.methods[0];
    for (const auto& rival : judged.rivals) {
      EXPECT_FALSE(rival.check()) << rival.name << ": nothing ran yet";
      rival.run();
      EXPECT_TRUE(rival.check()) << rival.name;
      EXPECT_FALSE(rival.check()) << rival.name << ": the results of the last run are spoilt";
    }
  }
}

TEST(TimedProblem, CountsTheAnswersOfACall) {
  const auto per_call = [](const std::string& method, std::size_t calls) {
    return rivals_of(study_of({method})).rivals.front().points_per_batch / calls;
  };
  EXPECT_EQ(per_call("easing_halley", 32), 97U) << "32 neighbours and k/64, k = 0..64";
  EXPECT_EQ(per_call("quintic_isolate", 64), 1U);
}

TEST(TimedProblem, TellsRivalsWhoseResultsAreWrong) {
  EXPECT_THAT(right(lengths({"gauss_legendre_24", "gauss_legendre_adaptive"}, {1e-10})), ElementsAre(false, true));
  EXPECT_THAT(right(study_of({"quintic_isolate", "quintic_seed_002"})), ElementsAre(true, false));
  EXPECT_THAT(right(derivatives({"differences_horner", "seed_000"}, {1})), ElementsAre(true, true));
  EXPECT_THAT(right(derivatives({"differences_horner", "seed_000"}, {2})), ElementsAre(true, false));
  EXPECT_THAT(right(lengths({"bracketed_newton", "chord_equalising"}, {1e-10})), ElementsAre(true, false));
}

/// Whether an answer is right, and still is with one of its numbers moved.
template <class P>
std::pair<bool, bool> before_and_after(const suite::Study& study, std::size_t moved, std::size_t span = 0) {
  const auto race = timed_problem(study).races(study).front();
  const race::CompanionTrials<P> trials(race, study, 1);
  const auto& kernel = *std::ranges::find(P::kernels(2), race.methods[0], &P::Kernel::info);
  typename P::Answer answer{};
  trials.ask(kernel, 0, answer);
  const bool before = trials.is_right(kernel, 0, answer);
  P::numbers(answer)[span][moved] += 8;
  return {before, trials.is_right(kernel, 0, answer)};
}

TEST(TimedProblem, AnAnswerThatIsOffIsNotRight) {
  constexpr std::pair caught(true, false);
  EXPECT_EQ(before_and_after<DerivativeProblem>(derivatives({"differences_horner"}), 1), caught);
  EXPECT_EQ(before_and_after<DerivativeProblem>(derivatives({"seed_000"}, {1}), 1), caught) << "without a bound";
  EXPECT_EQ(before_and_after<ArcLengthProblem>(lengths({"adaptive_simpson38"}), 0), caught);
  EXPECT_EQ(before_and_after<InverseArcLengthProblem>(lengths({"halley"}), 0), caught);
  EXPECT_EQ(before_and_after<ProjectionProblem>(study_of({"scan_refine"}), 0, 1), caught);
  EXPECT_EQ(before_and_after<InterpolationProblem>(splines({"c2_natural"}), 2), caught);
  EXPECT_EQ(before_and_after<InterpolationProblem>(splines({"c2_natural_handles"}), 2), caught) << "without a bound";
  EXPECT_EQ(before_and_after<FittingProblem>(fits({"schneider"}), 0), caught);
  EXPECT_EQ(before_and_after<BsplineProblem>(study_of({"de_boor"}), 1), caught);
  EXPECT_EQ(before_and_after<BsplineProblem>(study_of({"knot_insertion_span"}), 3), caught) << "a control point";
  EXPECT_EQ(before_and_after<BsplineProblem>(study_of({"chudy_wozny_span"}), 3), caught) << "without a bound";
  EXPECT_EQ(before_and_after<SubdivisionProblem>(study_of({"blossom_split"}), 3), caught);
  auto weighted = study_of({"two_sided_split"});
  weighted.form = Form::rational;
  weighted.generator = {"weights_mild"};
  EXPECT_EQ(before_and_after<SubdivisionProblem>(weighted, 2), caught) << "a weight";
}

TEST(TimedProblem, EveryCaseIsARace) {
  const auto races_of = [](const suite::Study& study) { return timed_problem(study).races(study); };
  EXPECT_EQ(races_of(derivatives({"seed_000"}, {1, 2, 3})).size(), 3U);
  EXPECT_EQ(races_of(lengths({"chord_sum"}, {1e-3, 1e-6})).size(), 2U);
  EXPECT_EQ(races_of(splines({"c2_natural"}, {3, 30, 300, 3000})).size(), 4U);
  EXPECT_EQ(races_of(fits({"schneider"}, {1e-2, 1e-3})).size(), 2U * 6) << "six kinds of data";
}

race::RivalTimes twice_timed(double ns) {
  race::RoundTimes repetition;
  repetition.ns_per_point = {ns, ns};
  return {{repetition, repetition}};
}

bundle::CsvDocument written(const suite::Study& study, const std::string& file, double (*ns)(const race::Race&)) {
  auto races = timed_problem(study).races(study);
  for (auto& race : races) {
    race.times.assign(race.methods.size(), twice_timed(ns(race)));
    race.times.insert(race.times.end(), 2, twice_timed(1));  // the sentinels
  }
  tables::Tables tables;
  studies::write_timing_rows(study, races, tables);
  studies::write_complexity_rows(study, races, timed_problem(study).size, tables);
  return bundle::parse_csv(tables.all().at(file).text(), file);
}

std::vector<std::string> case_values(const bundle::CsvDocument& csv, std::size_t row) {
  std::vector<std::string> fields;
  for (const auto& column : judge::case_columns()) fields.push_back(csv.at(row, column));
  return fields;
}

TEST(TimedProblem, RowsSayWhichCase) {
  const auto any = [](const race::Race&) { return 1.0; };
  EXPECT_THAT(case_values(written(study_of({"de_casteljau"}), "timing.csv", any), 0), ElementsAre("", "", "", ""));
  EXPECT_THAT(case_values(written(derivatives({"seed_000"}), "timing.csv", any), 0), ElementsAre("2", "", "", ""));
  EXPECT_THAT(case_values(written(lengths({"halley"}, {1e-3, 1e-9}), "timing.csv", any), 1),
              ElementsAre("", "1e-09", "", ""));
  const auto spline = written(splines({"c2_natural"}), "timing.csv", any);
  EXPECT_THAT(case_values(spline, 0), ElementsAre("", "", "12", ""));
  EXPECT_EQ(spline.at(0, "degree"), "3");
  const auto fit = written(fits({"schneider"}), "timing.csv", any);
  EXPECT_THAT(case_values(fit, 0), ElementsAre("", "0.01", "10", "samples"));
  EXPECT_THAT(case_values(fit, 6), ElementsAre("", "", "", "")) << "the sentinel";
}

TEST(TimedProblem, SplinesGrowWithTheirPoints) {
  const auto csv = written(splines({"c2_natural"}, {10, 100, 1000}), "complexity.csv",
                           [](const race::Race& race) { return 7.0 * *race.case_values.points; });
  ASSERT_EQ(csv.row_count(), 1U);
  EXPECT_NEAR(std::stod(csv.at(0, "exponent")), 1, 1e-12);
  EXPECT_EQ(csv.at(0, "verdict"), "within");
  EXPECT_EQ(csv.at(0, "first_points") + " " + csv.at(0, "last_points"), "10 1000");
  EXPECT_EQ(csv.at(0, "first_degree") + " " + csv.at(0, "last_degree"), "3 3");
}

TEST(TimedProblem, SizesOfOtherProblemsAreNotClaimed) {
  auto study = derivatives({"seed_000"});
  study.degree = {3, 5, 10};
  tables::Tables tables;
  studies::write_complexity_rows(study, timed_problem(study).races(study), timed_problem(study).size, tables);
  EXPECT_TRUE(tables.all().empty());
}

/// Adds a key that is missing, removes one that is there.
template <class T>
void toggle(std::vector<T>& key, T value) {
  if (key.empty())
    key.push_back(value);
  else
    key.clear();
}

TEST(TimedProblem, RefusesWhatIsNotTimed) {
  const auto refused = [](const suite::Study& study) { EXPECT_THROW(studies::make_job(study, {1}), Failure); };
  for (const auto& good : one_of_each()) {
    EXPECT_NO_THROW(studies::make_job(good, {1})) << good.methods[0];
    auto study = good;
    toggle(study.tolerance, 1e-3);
    refused(study);
    study = good;
    toggle(study.order, 1);
    refused(study);
    study = good;
    toggle(study.points, 10);
    refused(study);
    study = good;
    toggle(study.degree, 3);
    refused(study);
    if (good.methods[0] == "de_casteljau") continue;
    study = good;
    study.modes = {suite::Mode::one_shot, suite::Mode::point};
    refused(study);
    study = good;
    study.scalar = {suite::ScalarKind::float32};
    refused(study);
    const auto& forms = timed_kind(good).asks.inputs.forms;
    for (const Form form : suite::given_forms) {
      if (std::ranges::find(forms, form) != forms.end()) continue;
      study = good;
      study.form = form;
      refused(study);
    }
    study = good;
    study.methods.emplace_back("de_casteljau");
    refused(study);
  }
}

}  // namespace
}  // namespace bezierbench::studies
