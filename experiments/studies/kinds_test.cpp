// SPDX-License-Identifier: MIT
// What holds of every kind of study: the order of its blocks changes nothing, it refuses what its inputs do not name, and
// it takes curve sets or says why not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/study_test.hpp"

namespace bezierbench::studies {
namespace {

/// A study with the keys that its kind requires.
suite::Study study_of(const suite::Kind& kind) {
  auto study = small_study(kind.id);
  if (suite::find_field(kind, "order") != nullptr) study.order = {1};
  if (suite::find_field(kind, "points") != nullptr) study.points = {9};
  if (suite::find_field(kind, "tolerance") != nullptr) study.tolerance = {1e-6};
  if (suite::find_field(kind, "budget") != nullptr) study.budget = 50;
  return study;
}

suite::Study study_of_two_curves(const suite::Kind& kind) {
  const bool eases = kind.id.starts_with("easing");
  const auto outline = eases ? std::array<double, 8>{0, 0, 0.25, 0.1, 0.25, 1, 1, 1}
                             : std::array<double, 8>{604, 1010, 604, 1010.5, 622, 1013, 640, 1009};
  const std::array<double, 6> curve{-3, 0.5, 1, 7, 2, 2};
  auto set = std::make_shared<sample::LoadedSet>();
  set->id = "two";
  set->curves.add("outline", {Form::bernstein, 2, 3, outline});
  set->curves.add("curve", {Form::bernstein, 2, 2, curve});
  auto study = study_of(kind);
  study.curves = {"two"};
  study.sets = {set};
  study.dimension.clear();
  study.parameters = 7;
  if (kind.id == "exhaustive" || kind.id == "easing_floats") study.t_interval = {{0x1.ffcp-2, 0x1p-1}};
  if (kind.id == "exhaustive" || kind.id == "search" || kind.id == "guarantees") study.methods = {"de_casteljau"};
  if (eases) study.methods = {"easing_halley"};
  return study;
}

bool is_companion(const suite::Kind& kind) { return kind.problem && *kind.problem != Problem::evaluation; }

/// A study of a companion problem on drawn curves.
suite::Study study_of_drawn_curves(const suite::Kind& kind) {
  auto study = study_of(kind);
  if (kind.inputs.degree != suite::DegreeUse::not_a_key) study.degree = {3};
  return study;
}

/// Integers as coordinates give cusps, curves that turn back, equal distances and points that coincide.
TEST(Kinds, TheOrderOfBlocksAndInterruptionsChangeNoByte) {
  for (const auto* kind : kinds()) {
    if (!is_companion(*kind)) continue;
    for (const Form form : kind->inputs.forms) {
      SCOPED_TRACE(fmt::format("{} {}", kind->id, name(form)));
      auto study = study_of_drawn_curves(*kind);
      study.form = form;
      study.generator = {form == Form::rational ? "weights_wild" : "integer"};
      if (kind->problem == Problem::flattening) study.methods = {"equal_errors", "halving_area"};
      study.trials = 6;
      while (make_job(study, {1})->blocks_per_part() < 2) study.trials += 10;  // the last block is short
      std::size_t rows = 0;
      for (const auto& [file, text] : run::expect_order_changes_nothing(make_job, study))
        if (file.starts_with(kind->id) && !file.ends_with("_example.csv"))
          rows += bundle::parse_csv(text, file).row_count();
      EXPECT_EQ(make_job(study, {1})->extent().rows, rows);
    }
  }
}

TEST(Kinds, RefuseWhatTheirInputsDoNotName) {
  for (const auto* kind : kinds()) {
    if (!is_companion(*kind)) continue;
    SCOPED_TRACE(kind->id);
    const auto& takes = kind->inputs;
    const auto expect_refused = [&](bool refused, auto change) {
      auto study = study_of_drawn_curves(*kind);
      change(study);
      if (refused)
        EXPECT_THROW(make_job(study, {1}), Failure);
      else
        EXPECT_NO_THROW(make_job(study, {1}));
    };
    expect_refused(false, [](auto& /*study*/) {});
    for (const Form form : suite::given_forms)
      expect_refused(std::ranges::count(takes.forms, form) == 0, [&](auto& study) {
        study.form = form;
        if (form == Form::rational) study.generator = {"weights_mild"};
      });
    expect_refused(takes.double_only, [](auto& study) { study.scalar = {suite::ScalarKind::float32}; });
    expect_refused(takes.least_degree > 0, [](auto& study) { study.degree = {0}; });
    expect_refused(takes.parameters != suite::Parameters::any, [](auto& study) { study.t_interval = {{-1, 1}}; });
    expect_refused(takes.parameters == suite::Parameters::whole, [](auto& study) { study.t_interval = {{0, 0.5}}; });
    expect_refused(takes.independent_points, [](auto& study) { study.generator = {"multiple_root"}; });
    expect_refused(true, [](auto& study) { study.methods = {"de_casteljau"}; });
  }
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
  EXPECT_EQ(taken, 16U) << "a new kind either takes curve sets or says why not";
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
