// SPDX-License-Identifier: MIT
// What a kind of study declares to suites: its keys, the curves that it takes, its checks. Kinds themselves are in
// experiments/studies, a folder each; the vocabulary holds all of them.
#pragma once

#include <array>
#include <cstdint>
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
  required,
  not_a_key,
  optional  ///< the check of the kind decides when it may be left out
};

/// Which values of t_interval a study may have; `whole`: only the default.
enum class Parameters { any, from_0_to_1, whole };

/// Whether curves may be those of sets.
enum class SetUse { optional, required, none };

inline constexpr std::int64_t most_replicates = 1000000;  ///< per cell: the results of every replicate are kept

/// The inputs that a kind of study takes, of all that suites can describe.
struct Inputs {
  std::span<const Form> forms = given_forms;
  std::string_view forms_reason = {};  ///< why it does not take all forms
  bool double_only = false;
  DegreeUse degree = DegreeUse::required;
  std::string_view degree_reason = {};  ///< what the degree is, where it is not a key
  int least_degree = 0;
  std::string_view least_degree_reason = {};
  Parameters parameters = Parameters::any;
  std::string_view parameters_reason = {};  ///< what the interval is, or why there is none
  SetUse sets = SetUse::optional;
  std::string_view sets_reason = {};  ///< why they may not
  bool independent_points = false;    ///< no generator that draws a curve as a whole
};

struct Kind {
  std::string_view id;     ///< the word in suites
  std::string_view about;  ///< for people
  std::span<const Field> own;
  std::string_view methods_example;
  Inputs inputs = {};
  std::span<const std::string_view> without = {};  ///< keys of every kind that this kind does not have
  std::string_view without_reason = {};
  /// The problem whose methods studies of this kind judge, if it is one that can be timed. A timing study of these
  /// methods takes the same inputs and requires the same axes.
  std::optional<Problem> problem = {};
  bool timed = false;         ///< the results are times
  bool chains = false;        ///< `methods` are chains of conversions
  bool has_baseline = false;  ///< errors may also be taken against other methods
  /// The first fault in the kind's own keys, apart from missing ones. May be null.
  Finding (*check)(const Study& study, const Vocabulary& known) = nullptr;
};

/// The kind of the study. Throws std::logic_error where it has none.
const Kind& kind_of(const Study& study);

/// The keys of every kind, in the order in which they are written; after them come those of the kind itself.
std::span<const Field> shared_fields();
/// All keys of a kind, in the order in which they are written.
std::vector<const Field*> fields_of(const Kind& kind);
/// Whether every study of this kind must have the key. With curve sets, axes of cells may be left out nevertheless.
bool is_required(const Kind& kind, const Field& field);
/// Whether the curves of the study are those of sets.
inline bool has_sets(const Study& study) { return !study.curves.empty(); }
/// Whether the key means something in this study: some are for drawn curves, some for those of sets.
bool applies(const Field& field, const Study& study);
/// The kind's field of this key; null where the kind does not have it.
const Field* find_field(const Kind& kind, std::string_view key);
/// Why a study of this kind cannot have `key`, with those of `kinds` that can; empty where none has it.
std::string foreign_key_problem(const Kind& kind, std::string_view key, std::span<const Kind* const> kinds);

/// The first fault in the inputs of a study: what its kind does not take.
Finding check_inputs(const Study& study, std::span<const KnownGenerator> generators);
/// The first fault in the inputs and axes of a timing study: what the problem of its methods, that of the kind `judged`,
/// does not take, or requires.
Finding check_timed(const Study& study, const Kind& judged, std::span<const KnownGenerator> generators);

}  // namespace bezierbench::suite
