// SPDX-License-Identifier: MIT
// What the tests of all kinds share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {

/// A study of this kind, with these methods or else all.
inline suite::Study small_study(std::string_view kind_id, std::vector<std::string> methods = {}) {
  suite::Study study;
  study.id = "small";
  study.kind = &kind(kind_id);
  study.methods = std::move(methods);
  return study;
}

/// The rows of a file that the study writes; no promise and no bound is broken.
inline bundle::CsvDocument rows_of(const suite::Study& study, const std::string& file) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  return bundle::parse_csv(run::text_of(*job).at(file), file);
}

}  // namespace bezierbench::studies
