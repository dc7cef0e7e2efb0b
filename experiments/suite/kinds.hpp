// SPDX-License-Identifier: MIT
// What the kinds of studies say of themselves: their keys, the curves that they take, their checks.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/method.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/field.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

inline constexpr std::array given_forms{Form::bernstein, Form::power, Form::rational};
inline constexpr std::array bernstein_form{Form::bernstein};
inline constexpr std::array polynomial_forms{Form::bernstein, Form::power};
inline constexpr std::array forms_with_control_points{Form::bernstein, Form::rational};

enum class DegreeUse {
  needed,
  not_a_key,
  optional  ///< the check of the kind says when it may be left out
};

/// Which t_interval a study may have.
enum class Parameters { any, from_0_to_1, whole };

/// The inputs that a kind of study takes of those that suites can describe.
struct Inputs {
  std::span<const Form> forms = given_forms;
  std::string_view forms_reason = {};  ///< why not all
  bool double_only = false;
  DegreeUse degree = DegreeUse::needed;
  std::string_view degree_reason = {};  ///< what the degree is, where it is not a key
  int least_degree = 0;
  std::string_view least_degree_reason = {};
  Parameters parameters = Parameters::any;
  std::string_view parameters_reason = {};  ///< what the interval is, or why there is none
  bool independent_points = false;          ///< no generator that draws a curve as a whole
};

struct Kind {
  std::string_view id;     ///< the word in suites
  std::string_view about;  ///< for people
  std::span<const Field> own;
  std::string_view methods_example;
  Inputs inputs = {};
  std::span<const std::string_view> without = {};  ///< keys of every kind that this kind does not have
  std::string_view without_reason = {};
  /// The companion problem that studies of this kind judge; also timing studies of its methods take these inputs, and
  /// need those of the own keys that are axes.
  std::optional<Problem> companion = {};
  bool timed = false;            ///< a clock decides
  bool chains = false;           ///< `methods` are chains of conversions
  bool has_baseline = false;     ///< measures against other methods as well
  KindKeys (*keys)() = nullptr;  ///< with their defaults
  /// What is wrong with the own keys besides what is missing. May be null.
  Finding (*check)(const Study& study, const Vocabulary& known) = nullptr;
};

template <class Keys>
KindKeys default_keys() {
  return Keys();
}

/// All kinds, in the order of KindKeys.
std::span<const Kind* const> kinds();
/// Null where there is none of that id.
const Kind* find_kind(std::string_view id);
const Kind& kind_of(const Study& study);

/// The keys of every kind, in the order in which they are written; after them come those of the kind itself.
std::span<const Field> shared_fields();
/// All keys of a kind, in the order in which they are written.
std::vector<const Field*> fields_of(const Kind& kind);
/// Whether a study of this kind cannot be without the key.
bool needs(const Kind& kind, const Field& field);
/// Null where the kind does not have the key.
const Field* find_field(const Kind& kind, std::string_view key);
/// Why a study of this kind cannot have `key`, and which kinds can; empty where there is no such key at all.
std::string foreign_key_problem(const Kind& kind, std::string_view key);

/// What of the inputs of a study its kind does not take.
Finding check_inputs(const Study& study, std::span<const KnownGenerator> generators);
/// What of the inputs and axes of a timing study the problem of its methods does not take or lacks.
Finding check_timed(const Study& study, Problem problem, std::span<const KnownGenerator> generators);

/// The file of printed values that a study names; empty where it names none.
std::string_view published_of(const Study& study);
/// The values that a study names on an axis of cases; empty where its kind has no such key.
const std::vector<int>& orders_of(const Study& study);
const std::vector<int>& points_of(const Study& study);
const std::vector<double>& tolerances_of(const Study& study);

}  // namespace bezierbench::suite
