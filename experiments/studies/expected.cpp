// SPDX-License-Identifier: MIT
#include "experiments/studies/expected.hpp"

#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"

namespace bezierbench::studies {
namespace {

bool gives_rows(const suite::Study& study, std::uint64_t seed) {
  try {
    return make_job(study, {seed, reference::Tier::exact})->extent().rows > 0;
  } catch (const Failure&) {  // its methods are not in this build
    return false;
  }
}

}  // namespace

bundle::Expected expected_of(const std::vector<suite::Suite>& suites) {
  bundle::Expected expected;
  expected.seed = suites.front().seed;
  for (const auto& suite : suites) {
    expected.suites.push_back(suite.id);
    for (const auto& study : suite.studies) {
      expected.studies.push_back(study.id);
      if (!gives_rows(study, suite.seed)) continue;
      for (auto& tables : tables_of(study.kind)) expected.tables.push_back(std::move(tables));
    }
  }
  return expected;
}

}  // namespace bezierbench::studies
