// SPDX-License-Identifier: MIT
// The studies of suites that are about one method.
#pragma once

#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// The methods with this id, one for each problem and form that it stands for. Throws Failure(Exit::usage) where there
/// is none.
std::vector<const MethodInfo*> methods_named(const std::string& id);

/// The studies of errors that have the method, with no other methods in them; suites without one are left out. A cell's
/// inputs do not depend on its methods, so these give the rows that the whole suite gives.
std::vector<suite::Suite> studies_that_judge(const std::vector<suite::Suite>& suites, const std::string& id);

/// The timing studies that name the method or, where none does, all of its problem, with this method in the place of
/// theirs.
std::vector<suite::Suite> studies_that_time(const std::vector<suite::Suite>& suites, const std::string& id);

/// The suite `quick`, which comes with the program.
std::vector<suite::Suite> quick_suite();

}  // namespace bezierbench::cli
