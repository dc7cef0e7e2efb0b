// SPDX-License-Identifier: MIT
#include "experiments/judge/study_inputs.hpp"

#include <string>
#include <vector>

#include "experiments/sample/draw.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::judge {
namespace {

const std::vector<suite::KnownGenerator>& known_generators() {
  static const auto all = [] {
    std::vector<suite::KnownGenerator> known;
    for (const auto& generator : sample::generators()) known.push_back({std::string(generator.id), generator.limits});
    return known;
  }();
  return all;
}

}  // namespace

void check_inputs(const suite::Study& study) {
  if (const auto fault = suite::check_inputs(study, known_generators())) suite::refuse(study, *fault);
}

void check_timed(const suite::Study& study, const suite::Kind& judged) {
  if (const auto fault = suite::check_timed(study, judged, known_generators())) suite::refuse(study, *fault);
}

}  // namespace bezierbench::judge
