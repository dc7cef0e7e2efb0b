// SPDX-License-Identifier: MIT
// What this program is and knows: the facts that a run records, and the ids that suites may use, from the rosters.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/cli/command.hpp"
#include "experiments/external/method.hpp"
#include "experiments/run/run.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::cli {

/// A request with the facts of this build and the external methods filled in, and nothing else.
run::RunRequest request_of_this_build(const external::Methods& external = {});

/// Makes these the external methods that the request records.
void record_external(run::RunRequest& request, std::vector<suite::ExternalMethod> external);

/// What is known of every method: evaluators and converted paths, then conversions, then companions. An id that stands
/// for several forms or problems is there once for each.
std::vector<const MethodInfo*> every_method();

/// Ids of all methods, conversions, generators and published files.
suite::Vocabulary vocabulary();

/// The same ids, and those of methods that only other builds have; suites that come with the program may name these.
suite::Vocabulary vocabulary_of_all_builds();

/// The table of `list methods --format csv`, which every bundle contains, with these methods at its end.
std::string methods_csv(std::span<const suite::ExternalMethod> external);

/// The table of `list generators --format csv`, which every bundle contains.
std::string generators_csv();

/// Version, commit and compiler in one line.
std::string version_line();

// The words that options take, for completions. Each list is made when somebody asks for it.

/// The methods of one problem.
KnownValues methods_of(Problem problem);

/// The methods of every problem, conversions included.
KnownValues all_methods();

/// What --set takes: `key=` for every key that can be set, or `key=value` where the values are known.
std::vector<std::string> known_settings();

}  // namespace bezierbench::cli
