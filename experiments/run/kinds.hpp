// SPDX-License-Identifier: MIT
// The functions by which the engine uses kinds of studies. It knows no kind by name; the roster in studies/ passes
// them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/run/job.hpp"
#include "experiments/suite/outside.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::run {

struct Kinds {
  /// The work of one study. Throws Failure(usage) where its methods do not fit.
  std::unique_ptr<Job> (*make_job)(const suite::Study& study, const JobContext& context) = nullptr;
  /// The tables that the study writes wherever it has rows, by file name: one of each list.
  std::vector<std::vector<std::string>> (*tables_of)(const suite::Study& study) = nullptr;
  /// The work of one study on a method from outside; null where studies of this kind take none, or not this one. A
  /// method that is not at hand can be written and merged, but not run.
  std::function<std::unique_ptr<Job>(const suite::Study& study, const suite::OutsideMethod& method,
                                     const JobContext& context)>
      make_outside_job = nullptr;
  /// Why there is no such job, a sentence about the study; empty where there is one.
  std::string (*why_unasked)(const suite::Study& study, const suite::OutsideMethod& method) = nullptr;
};

}  // namespace bezierbench::run
