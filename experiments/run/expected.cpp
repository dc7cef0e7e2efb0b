// SPDX-License-Identifier: MIT
#include "experiments/run/expected.hpp"

#include "experiments/failure.hpp"

namespace bezierbench::run {
namespace {

bool gives_rows(const suite::Study& study, std::uint64_t seed, const Kinds& kinds) {
  try {
    return kinds.make_job(study, {seed, reference::Tier::exact})->extent().rows > 0;
  } catch (const Failure&) {  // this build lacks its methods
    return false;
  }
}

}  // namespace

bundle::Expected expected_of(const std::vector<suite::Suite>& suites, const Kinds& kinds) {
  bundle::Expected expected;
  expected.seed = suites.front().seed;
  for (const auto& suite : suites) {
    expected.suites.push_back(suite.id);
    for (const auto& study : suite.studies) {
      expected.studies.push_back(study.id);
      if (!gives_rows(study, suite.seed, kinds)) continue;
      for (auto& tables : kinds.tables_of(study)) expected.tables.push_back(std::move(tables));
    }
  }
  return expected;
}

}  // namespace bezierbench::run
