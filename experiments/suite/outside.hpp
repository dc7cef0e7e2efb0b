// SPDX-License-Identifier: MIT
// The methods from outside that a run had, as suite.toml records them: [[outside]] tables. A record says what a method
// was; nothing is loaded or started because a file names it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::suite {

/// The way in which a method from outside was given. Its id begins with this word and an underscore.
enum class OutsideKind {
  own,      ///< compiled into the user's program, with the harness
  plugin,   ///< a shared object
  program,  ///< a command
  answers   ///< a file of answers
};

template <>
inline constexpr std::array<Word<OutsideKind>, 4> words<OutsideKind>{{{OutsideKind::own, "own"},
                                                                      {OutsideKind::plugin, "plugin"},
                                                                      {OutsideKind::program, "program"},
                                                                      {OutsideKind::answers, "answers"}}};

struct OutsideMethod {
  std::string id;
  OutsideKind kind = OutsideKind::program;
  std::string label;  ///< for people; may be empty
  Form form = Form::bernstein;
  int min_degree = 0;
  int max_degree = bezierbench::max_degree;
  std::string source;  ///< the command, or the file as it was named; empty for `own`
  std::string sha256;  ///< of the file, or of what `sha256sum` says of the files that the command names; may be empty
  friend bool operator==(const OutsideMethod&, const OutsideMethod&) = default;
};

/// Whether the id is that of a method from outside, present or not.
bool is_outside(std::string_view id);

/// What is wrong with the id of a method of this kind; empty where nothing is.
std::string outside_id_problem(std::string_view id, OutsideKind kind);

/// One [[outside]] table each, after a blank line; they belong at the end of suite.toml.
std::string to_toml(std::span<const OutsideMethod> methods);

/// The [[outside]] tables of a suite file. Throws Failure(usage) as parse_suites() does.
std::vector<OutsideMethod> parse_outside(std::string_view text, std::string_view file_name);

}  // namespace bezierbench::suite
