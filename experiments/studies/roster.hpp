// SPDX-License-Identifier: MIT
// Every kind of study. One line in roster.cpp makes a kind exist.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The work of one study. Throws Failure(usage) where the kind has no implementation or the methods do not fit.
std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context);

/// The tables that a study of this kind writes wherever it has rows, by file name: one of each list.
[[nodiscard]] std::vector<std::vector<std::string>> tables_of(const suite::Study& study);

}  // namespace bezierbench::studies
