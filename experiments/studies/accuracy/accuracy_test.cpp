// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/batch/batch.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/study_test.hpp"
#include "reference/exact_curve.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

suite::Study small_accuracy_study() {
  auto study = small_study("accuracy");
  study.degree = {3, 171};
  study.generator = {"continuous"};
  study.methods = {"direct", "de_casteljau", "direct_pow"};
  study.trials = 2500;  // three blocks a replicate, the last one short
  study.replicates = 2;
  study.baseline = {"exact", "direct"};
  return study;
}

TEST(Accuracy, OrderAndInterruptionsChangeNoByte) {
  run::expect_order_changes_nothing(make_job, small_accuracy_study());
}

/// The mean and maximum of every replicate, recomputed here without tallies.
void expect_errors_of_the_trials(Form kind, const std::string& generator) {
  auto study = small_accuracy_study();
  study.degree = {3};
  study.form = kind;
  study.generator = {generator};
  study.methods = {"direct", "de_casteljau"};
  const Form form = kind;
  const auto job = make_job(study, {5});
  run::run_all(*job);
  const sample::Cell cell{kind, 2, 3, 1, {}, generator};
  const sample::Sampler sampler(5, study.id, cell);
  const auto& kernel = *find_kernel<double>("de_casteljau", form, 2);
  reference::ExactCurve exact;
  sample::Trial trial;
  for (const auto& series : job->series()) {
    if (series.method != "de_casteljau" || series.baseline != "exact") continue;
    for (std::size_t replicate = 0; replicate < 2; ++replicate) {
      double sum = 0;
      double largest = 0;
      for (std::uint64_t k = 0; k < 2500; ++k) {
        sampler.draw(replicate * 2500 + k, trial);
        const CurveView<double> curve{form, 2, 3, trial.coefficients, trial.weights};
        std::array<double, 2> point{};
        PreparedState<double>(kernel, curve).evaluate({&trial.t, 1}, point.data());
        const double error = reference::Distance(exact.point(curve, trial.t)).to(point);
        sum += error;
        largest = std::max(largest, error);
      }
      if (series.statistic == "mean_error")
        EXPECT_NEAR(series.values[replicate] / (sum / 2500), 1, 1e-12);
      else
        EXPECT_EQ(series.values[replicate], largest);
    }
  }
}

TEST(Accuracy, RowsAreTheErrorsOfTheTrials) {
  expect_errors_of_the_trials(Form::bernstein, "continuous");
  expect_errors_of_the_trials(Form::rational, "weights_wild");
}

TEST(Accuracy, SaysWhereADegreeIsNotSupported) {
  const auto csv = rows_of(small_accuracy_study(), "accuracy.csv");
  int unsupported = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    if (csv.at(row, "degree") != "171") {
      EXPECT_EQ(csv.at(row, "status"), "ok");
      continue;
    }
    const bool direct = csv.at(row, "method") == "direct";
    const bool against_direct = csv.at(row, "baseline") == "direct";
    EXPECT_EQ(csv.at(row, "status"), direct           ? "degree_unsupported"
                                     : against_direct ? "baseline_degree_unsupported"
                                                      : "ok");
    if (direct || against_direct) {
      ++unsupported;
      EXPECT_EQ(csv.at(row, "mean_error"), "");
    }
  }
  EXPECT_EQ(unsupported, 2);
}

/// accuracy.csv: the Euclidean error over the spacing of doubles at |p|. audit.csv has the largest error of an axis.
TEST(Accuracy, UlpsAreOfTheLengthOfThePoint) {
  auto study = small_accuracy_study();
  study.degree = {9};
  study.methods = {"direct"};
  study.baseline = {"exact"};
  study.trials = 1;
  study.replicates = 1;
  const auto job = make_job(study, {5});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("accuracy.csv"), "accuracy.csv");
  sample::Trial trial;
  sample::draw(5, sample::key(study.id), {Form::bernstein, 2, 9, 1, {}, "continuous"}, 0, trial);
  reference::ExactCurve exact;
  const auto& truth = exact.point({Form::bernstein, 2, 9, trial.coefficients}, trial.t);
  const double length = std::hypot(reference::round_to(reference::binary64, truth.coordinate(0)),
                                   reference::round_to(reference::binary64, truth.coordinate(1)));
  const double ulp = std::ldexp(1.0, std::ilogb(length) - 52);
  const double error = *number::parse_number(csv.at(0, "max_error"));
  EXPECT_GT(error, 0);
  EXPECT_NEAR(*number::parse_number(csv.at(0, "max_error_ulp")) / (error / ulp), 1, 0x1p-20);
  const auto audit = bundle::parse_csv(run::text_of(*job).at("audit.csv"), "audit.csv");
  EXPECT_TRUE(audit.has_column("max_axis_error_ulp"));
  EXPECT_FALSE(audit.has_column("max_error_ulp"));
}

TEST(Accuracy, LibmMethodsStayOutOfTheDigest) {
  const auto job = make_job(small_accuracy_study(), {1});
  run::run_all(*job);
  EXPECT_EQ(run::text_of(*job).at("accuracy.csv").find("direct_pow"), std::string::npos);
  EXPECT_NE(run::text_of(*job).at("unstable.csv").find("direct_pow"), std::string::npos);
}

TEST(Accuracy, FloatIsJudgedInItsOwnUnit) {
  auto study = small_accuracy_study();
  study.degree = {3};
  study.scalar = {suite::ScalarKind::float32, suite::ScalarKind::float64};
  study.methods = {"de_casteljau"};
  study.baseline = {"exact"};
  const auto csv = rows_of(study, "accuracy.csv");
  ASSERT_EQ(csv.row_count(), 2U);
  const double float_error = *number::parse_number(csv.at(0, "mean_error"));
  const double double_error = *number::parse_number(csv.at(1, "mean_error"));
  EXPECT_EQ(csv.at(0, "scalar"), "float");
  EXPECT_NEAR(float_error / double_error, 0x1p29, 0x1p28);
  EXPECT_NEAR(*number::parse_number(csv.at(0, "mean_error_u")) / *number::parse_number(csv.at(1, "mean_error_u")), 1,
              0.2);
}

/// Bounds are proved for such weights, and hold; float weights are rounded like the coordinates.
TEST(Accuracy, RationalCurvesKeepTheirBounds) {
  auto study = small_accuracy_study();
  study.degree = {1, 4, 12};
  study.form = Form::rational;
  study.generator = {"weights_mild", "weights_wild"};
  study.methods = {};
  study.baseline = {"exact"};
  study.scalar = {suite::ScalarKind::float32, suite::ScalarKind::float64};
  study.trials = 500;
  study.decomposed_trials = 50;
  const auto csv = rows_of(study, "accuracy.csv");
  std::size_t bounded = 0;
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    EXPECT_EQ(csv.at(row, "non_finite"), "0");
    if (csv.at(row, "bound_u").empty()) continue;
    ++bounded;
    EXPECT_LE(*number::parse_number(csv.at(row, "max_error_u")), *number::parse_number(csv.at(row, "bound_u")));
  }
  EXPECT_GT(bounded, csv.row_count() / 2);
}

/// wozny_chudy_positive has a bound for t in [0,1] only, the degree and range of double allow every one.
TEST(Accuracy, CountsTrialsWithoutABound) {
  auto study = small_accuracy_study();
  study.degree = {3};
  study.methods = {"de_casteljau", "de_casteljau_lerp", "wozny_chudy_positive"};
  study.baseline = {"exact"};
  study.t_interval = {{-1, 3}};
  study.trials = 400;
  study.replicates = 1;
  const auto job = make_job(study, {5});
  run::run_all(*job);
  std::int64_t outside = 0;
  sample::Trial trial;
  for (std::uint64_t k = 0; k < 400; ++k) {
    sample::draw(5, sample::key(study.id), {Form::bernstein, 2, 3, 1, {-1, 3}, "continuous"}, k, trial);
    outside += trial.t < 0 || trial.t > 1 ? 1 : 0;
  }
  EXPECT_GT(outside, 0);
  EXPECT_LT(outside, 400);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("accuracy.csv"), "accuracy.csv");
  std::map<std::string, std::string> counts;
  for (std::size_t row = 0; row < csv.row_count(); ++row)
    counts[csv.at(row, "method")] = csv.at(row, "unbounded_trials");
  EXPECT_EQ(counts, (std::map<std::string, std::string>{{"de_casteljau", "0"},
                                                        {"de_casteljau_lerp", "400"},  // states none
                                                        {"wozny_chudy_positive", std::to_string(outside)}}));
}

/// Groups of trials go through kernels of their own, where a method has them, except the first group of each block.
TEST(Accuracy, CountsTrialsOfTheKernelThatIsTimed) {
  auto study = small_accuracy_study();  // 2 replicates of 3 blocks
  study.degree = {3};
  const auto job = make_job(study, {5});
  run::run_all(*job);
  const auto csv = bundle::parse_csv(run::text_of(*job).at("reference.csv"), "reference.csv");
  ASSERT_EQ(csv.row_count(), 3U);
  for (std::size_t row = 0; row < csv.row_count(); ++row) {
    const bool in_groups = csv.at(row, "method") != "direct_pow" && !batch::usable_targets().empty();
    EXPECT_EQ(csv.at(row, "own_kernel"), in_groups ? "6" : "5000") << csv.at(row, "method");
  }
}

/// The largest error in units of u p~ and the row of worst.csv come from the same trial, however blocks are merged.
TEST(Accuracy, KeepsTheWorstTrial) {
  auto study = small_accuracy_study();
  study.degree = {3};
  study.baseline = {"exact"};
  const auto job = make_job(study, {5});
  for (std::size_t block = job->blocks(); block-- > 0;) job->add(job->part_of(block), job->run_block(block));
  const auto rows = bundle::parse_csv(run::text_of(*job).at("accuracy.csv"), "accuracy.csv");
  const auto worst = bundle::parse_csv(run::text_of(*job).at("worst.csv"), "worst.csv");
  ASSERT_EQ(worst.row_count(), 2U);  // direct_pow is not bit-stable
  for (std::size_t row = 0; row < worst.row_count(); ++row) {
    EXPECT_EQ(worst.at(row, "worst_id"), "w" + std::to_string(row + 1));
    EXPECT_EQ(worst.at(row, "method"), rows.at(row, "method"));
    EXPECT_EQ(worst.at(row, "error_u"), rows.at(row, "max_error_u"));
    sample::Trial trial;
    sample::draw(5, sample::key(study.id), {Form::bernstein, 2, 3, 1, {}, "continuous"},
                 static_cast<std::uint64_t>(number::parse_integer(worst.at(row, "trial")).value()), trial);
    EXPECT_EQ(worst.at(row, "t"), number::hexadecimal(trial.t));
    std::string coefficients;
    for (const std::size_t k : {0U, 2U, 4U, 6U, 1U, 3U, 5U, 7U})
      coefficients += (k == 0 ? "" : " ") + number::hexadecimal(trial.coefficients[k]);
    EXPECT_EQ(worst.at(row, "coefficients"), coefficients);
  }
}

/// The certificate changes no byte, wherever it applies and wherever it gives up.
TEST(Accuracy, TiersAgreeByteForByte) {
  auto study = small_accuracy_study();
  study.degree = {0, 1, 20, 57};
  study.dimension = {1, 3};
  study.generator = {"continuous", "report"};
  study.coordinate_range = {1e-250, 1, 1e250};
  study.t_interval = {{0, 1}, {-20, 20}, {0, 0}, {0.5, 0.5}};
  study.scalar = {suite::ScalarKind::float64};
  study.trials = 70;
  study.replicates = 1;
  for (const auto curve : {Form::bernstein, Form::power}) {
    study.form = curve;
    study.methods = curve == Form::bernstein
                        ? std::vector<std::string>{"de_casteljau", "compensated_de_casteljau", "exact:horner"}
                        : std::vector<std::string>{"horner", "compensated_horner"};
    study.baseline = {"exact", study.methods.front()};
    const auto exact = make_job(study, {7, reference::Tier::exact});
    const auto certified = make_job(study, {7, reference::Tier::certified});
    run::run_all(*exact);
    run::run_all(*certified);
    for (const std::string file : {"accuracy.csv", "worst.csv", "audit.csv"})
      EXPECT_EQ(run::text_of(*exact).at(file), run::text_of(*certified).at(file)) << file;
    const auto reference = bundle::parse_csv(run::text_of(*certified).at("reference.csv"), "reference.csv");
    std::int64_t kept = 0;
    for (std::size_t row = 0; row < reference.row_count(); ++row) {
      kept += 70 - number::parse_integer(reference.at(row, "escalated")).value();
    }
    EXPECT_GT(kept, 0);
  }
}

}  // namespace
}  // namespace bezierbench::studies
