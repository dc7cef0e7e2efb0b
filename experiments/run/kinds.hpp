// SPDX-License-Identifier: MIT
// The functions by which the engine uses kinds of studies. It knows no kind by name; the roster in studies/ passes
// them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/run/job.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::run {

struct Kinds {
  /// The work of one study. Throws Failure(usage) where its methods do not fit.
  std::unique_ptr<Job> (*make_job)(const suite::Study& study, const JobContext& context) = nullptr;
  /// The tables that the study writes wherever it has rows, by file name: one of each list.
  std::vector<std::vector<std::string>> (*tables_of)(const suite::Study& study) = nullptr;
};

}  // namespace bezierbench::run
