// SPDX-License-Identifier: MIT
// The external methods of a run, as suite.toml records them: [[external]] tables. A record describes a method; nothing
// is loaded or started because a file names it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "core/method.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// The way in which an external method was given. Its id begins with this word and an underscore.
enum class ExternalKind {
  own,      ///< compiled into the user's program, with the harness
  plugin,   ///< a shared object
  program,  ///< a command
  answers   ///< a file of answers
};

template <>
inline constexpr std::array<Word<ExternalKind>, 4> words<ExternalKind>{{{ExternalKind::own, "own"},
                                                                        {ExternalKind::plugin, "plugin"},
                                                                        {ExternalKind::program, "program"},
                                                                        {ExternalKind::answers, "answers"}}};

/// The problems that external methods can solve.
template <>
inline constexpr std::array<Word<Problem>, 4> words<Problem>{
    {{Problem::evaluation, bezierbench::name(Problem::evaluation)},
     {Problem::arc_length, bezierbench::name(Problem::arc_length)},
     {Problem::projection, bezierbench::name(Problem::projection)},
     {Problem::subdivision, bezierbench::name(Problem::subdivision)}}};

struct ExternalMethod {
  std::string id;
  ExternalKind kind = ExternalKind::program;
  std::string label;  ///< for people; may be empty
  Form form = Form::bernstein;
  int min_degree = 0;
  int max_degree = bezierbench::max_degree;
  std::vector<ScalarKind> scalars{ScalarKind::float64};  ///< in which it answers
  std::vector<Problem> problems{Problem::evaluation};    ///< that it solves
  std::string source;                                    ///< the command, or the file as it was named; empty for `own`
  std::string sha256;  ///< of the file, or of the `sha256sum` lines of the files that the command names; may be empty
  friend bool operator==(const ExternalMethod&, const ExternalMethod&) = default;
};

/// Whether the id is that of an external method, present or not.
bool is_external(std::string_view id);

/// Why the id is invalid for a method of this kind; empty where it is valid.
std::string external_id_problem(std::string_view id, ExternalKind kind);

/// One [[external]] table each, after a blank line; for the end of suite.toml.
std::string to_toml(std::span<const ExternalMethod> methods);

/// The [[external]] tables of a suite file. Throws Failure(usage) as parse_suites() does.
std::vector<ExternalMethod> parse_external(std::string_view text, std::string_view file_name);

}  // namespace bezierbench::suite
