// SPDX-License-Identifier: MIT
// What the tests of all kinds share.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/failure.hpp"
#include "experiments/run/job_test.hpp"
#include "experiments/sample/curve_slice.hpp"
#include "experiments/studies/roster.hpp"
#include "reference/curves/read.hpp"

namespace bezierbench::studies {

/// A study of this kind, with these methods or else all.
inline suite::Study small_study(std::string_view kind_id, std::vector<std::string> methods = {}) {
  suite::Study study;
  study.id = "small";
  study.kind = &kind(kind_id);
  study.methods = std::move(methods);
  return study;
}

/// Takes some curves of the shipped set `named`.
inline void take_named(suite::Study& study, const std::vector<std::string>& ids) {
  const std::string name = BEZIERBENCH_SOURCE_DIR "/reference/curves/sets/named.csv";
  std::ifstream file(name);
  const auto all = curves::read(std::string(std::istreambuf_iterator<char>(file), {}), name).set;
  auto set = std::make_shared<sample::LoadedSet>();
  set->id = "named";
  for (const auto& id : ids) set->curves.add(id, all[all.find(id)]);
  study.curves = {"named"};
  study.sets = {set};
}

/// The rows of a file that the study writes; no promise and no bound is broken.
inline bundle::CsvDocument rows_of(const suite::Study& study, const std::string& file) {
  const auto job = make_job(study, {1});
  run::run_all(*job);
  EXPECT_TRUE(job->violations().empty());
  return bundle::parse_csv(run::text_of(*job).at(file), file);
}

}  // namespace bezierbench::studies
