// SPDX-License-Identifier: MIT
// The work of accuracy and timing studies on a method from outside. Its inputs are those of the study, so its rows stand
// beside those of our own methods; no other row depends on it.
#pragma once

#include <memory>
#include <string>

#include "experiments/outside/method.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/outside.hpp"

namespace bezierbench::studies {

/// Why a study asks nothing of the method, a sentence about the study; empty where it asks it.
[[nodiscard]] std::string why_unasked(const suite::Study& study, const suite::OutsideMethod& record);

/// Null where the study asks nothing of the method. `at_hand` may be null where the job
/// is not to be run; else it must outlive the job and be the method of the record.
std::unique_ptr<run::Job> outside_job(const suite::Study& study, const suite::OutsideMethod& record,
                                      const outside::Method* at_hand, const run::JobContext& context);

}  // namespace bezierbench::studies
