// SPDX-License-Identifier: MIT
// What the tests of arc length and inverse arc length share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/number/number.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {

/// A small study of the kind.
inline suite::Study small_length_study(std::string_view id, std::vector<std::string> generators) {
  suite::Study study;
  study.id = "small";
  study.kind = &kind(id);
  study.tolerance = {1e-3, 1e-9};
  study.degree = {3};
  study.coordinate_range = {1};
  study.t_interval = {{0, 1}, {0.25, 0.75}};
  study.generator = std::move(generators);
  study.trials = 20;  // two blocks, the last one short
  return study;
}

/// Expects no broken promise and, where every trial converged, a largest error within the tolerance.
inline void expect_kept(const bundle::CsvDocument& csv, std::size_t row) {
  EXPECT_EQ(csv.at(row, "broken_promises"), "0");
  EXPECT_EQ(csv.at(row, "non_finite"), "0");
  const double tolerance = *number::parse_number(csv.at(row, "tolerance"));
  if (csv.at(row, "non_converged") == "0") {
    EXPECT_LE(*number::parse_number(csv.at(row, "max_relative")), tolerance * 1.001);
  }
}

}  // namespace bezierbench::studies
