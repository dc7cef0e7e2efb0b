// SPDX-License-Identifier: MIT
// The studies of suites that are about one method.
#pragma once

#include <string>
#include <vector>

#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// Throws Failure(Exit::usage) where there is no method with this id.
void require_method(const std::string& id);

/// The studies of errors that have the method, with no other methods in them; suites without one are left out. A cell's
/// inputs do not depend on its methods, so these give the rows that the whole suite gives.
std::vector<suite::Suite> studies_that_judge(const std::vector<suite::Suite>& suites, const std::string& id);

/// The timing studies that name the method or, where none does, all of its problem, with this method in the place of
/// theirs.
std::vector<suite::Suite> studies_that_time(const std::vector<suite::Suite>& suites, const std::string& id);

}  // namespace bezierbench::cli
