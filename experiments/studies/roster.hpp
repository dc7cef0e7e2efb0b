// SPDX-License-Identifier: MIT
// Every kind of study. A kind is one object, in the folder of its name, and one line in roster.cpp.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/method.hpp"
#include "experiments/external/method.hpp"
#include "experiments/race/race.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/kind.hpp"

namespace bezierbench::studies {

struct StudyKind {
  suite::Kind asks;  ///< what suites may ask of it
  /// The work of one study. Throws Failure(usage) for inputs that the kind does not take, and where the methods do not
  /// fit.
  std::unique_ptr<run::Job> (*make)(const suite::Study& study, const run::JobContext& context);
  std::optional<race::TimedProblem> timed = {};  ///< how timing studies race the methods of `asks.problem`
  /// The methods of a companion problem; null for any other kind.
  std::vector<const MethodInfo*> (*methods)() = nullptr;
  /// The work of one study on an external method (studies/external); null where such methods do not solve its problem.
  std::unique_ptr<run::Job> (*make_external)(const suite::Study& study, const suite::ExternalMethod& record,
                                             const external::Method* given, const run::JobContext& context) = nullptr;
};

extern const StudyKind accuracy_kind;
extern const StudyKind timing_kind;

/// All kinds, as suites see them, in the order of lists.
std::span<const suite::Kind* const> kinds();
/// Throws std::out_of_range for an id that is not one of a kind.
const suite::Kind& kind(std::string_view id);
/// The methods of every companion problem, kind by kind in roster order, then those of other libraries.
std::vector<const MethodInfo*> companion_infos();
const StudyKind& study_kind(const suite::Study& study);
/// Whether the study is of this kind.
bool is_kind(const suite::Study& study, const StudyKind& kind);

/// The work of one study, as StudyKind::make.
std::unique_ptr<run::Job> make_job(const suite::Study& study, const run::JobContext& context);

/// The kind that decides which inputs the study takes: of a timing study that of its problem, else its own.
const suite::Kind& kind_of_inputs(const suite::Study& study);

/// The kind of the problem whose methods a timing study names, else accuracy; a glob that matches evaluators means
/// evaluation. Throws Failure(usage) for inputs and axes that the problem does not take.
const StudyKind& timed_kind(const suite::Study& study);
inline const race::TimedProblem& timed_problem(const suite::Study& study) { return *timed_kind(study).timed; }

}  // namespace bezierbench::studies
