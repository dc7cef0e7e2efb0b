// SPDX-License-Identifier: MIT
// Every kind of study that takes curve sets, on a set of two curves.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "experiments/run/job_test.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

suite::Study study_of_two_curves(const suite::Kind& kind) {
  const bool eases = kind.id.starts_with("easing");
  const auto outline = eases ? std::array<double, 8>{0, 0, 0.25, 0.1, 0.25, 1, 1, 1}
                             : std::array<double, 8>{604, 1010, 604, 1010.5, 622, 1013, 640, 1009};
  const std::array<double, 6> curve{-3, 0.5, 1, 7, 2, 2};
  auto set = std::make_shared<sample::LoadedSet>();
  set->id = "two";
  set->curves.add("outline", {Form::bernstein, 2, 3, outline});
  set->curves.add("curve", {Form::bernstein, 2, 2, curve});
  suite::Study study;
  study.id = "sets";
  study.kind = &kind;
  study.curves = {"two"};
  study.sets = {set};
  study.dimension.clear();
  study.parameters = 7;
  if (suite::find_field(kind, "order") != nullptr) study.order = {1};
  if (suite::find_field(kind, "points") != nullptr) study.points = {9};
  if (suite::find_field(kind, "tolerance") != nullptr) study.tolerance = {1e-6};
  if (suite::find_field(kind, "budget") != nullptr) study.budget = 50;
  if (kind.id == "exhaustive" || kind.id == "easing_floats") study.t_interval = {{0x1.ffcp-2, 0x1p-1}};
  if (kind.id == "exhaustive" || kind.id == "search" || kind.id == "guarantees") study.methods = {"de_casteljau"};
  if (eases) study.methods = {"easing_halley"};
  return study;
}

TEST(CurveSets, EveryKindWhoseInputsAreCurvesTakesThem) {
  std::size_t taken = 0;
  for (const auto* kind : kinds()) {
    if (kind->inputs.sets == suite::SetUse::none || kind->timed) continue;
    SCOPED_TRACE(kind->id);
    ++taken;
    std::size_t rows = 0;
    for (const auto& study : sample::studies_of(study_of_two_curves(*kind)))
      for (const auto& [file, text] : run::expect_order_changes_nothing(make_job, study)) {
        const auto table = bundle::parse_csv(text, file);
        for (std::size_t row = 0; row < table.row_count(); ++row, ++rows) {
          EXPECT_EQ(table.at(row, "curves"), "two") << file;
          if (table.has_column("coordinate_range")) {
            EXPECT_EQ(table.at(row, "coordinate_range"), "") << file;
          }
          if (table.has_column("trials") && kind->id != "guarantees") {
            EXPECT_EQ(table.at(row, "trials"), "7") << file;
          }
        }
      }
    EXPECT_GT(rows, 0U);
  }
  EXPECT_EQ(taken, 15U) << "a new kind either takes curve sets or says why not";
}

/// On one curve, whose size is 36.
TEST(CurveSets, MisroundedAndErrorsOverTheSizeAreThoseOfTheDefinition) {
  auto study = study_of_two_curves(accuracy_kind.asks);
  study.methods = {"de_casteljau", "correctly_rounded"};
  study.degree = {3};
  study.scalar = {suite::ScalarKind::float32};
  const auto slice = sample::studies_of(study).front();
  const auto table =
      bundle::parse_csv(run::expect_order_changes_nothing(make_job, slice).at("accuracy.csv"), "accuracy.csv");
  ASSERT_EQ(table.row_count(), 2U);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_NEAR(run::number_at(table, row, "max_error_size"), run::number_at(table, row, "max_error") / 36, 1e-9)
        << "the outline is 36 wide and 4 high";
    if (table.at(row, "method") == "correctly_rounded") {
      EXPECT_EQ(run::number_at(table, row, "misrounded"), 0);
    } else {
      EXPECT_GT(run::number_at(table, row, "misrounded"), 0);
    }
  }
}

}  // namespace
}  // namespace bezierbench::studies
