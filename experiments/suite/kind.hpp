// SPDX-License-Identifier: MIT
// The keys of a [[study]] table, and what a kind of study declares to suites: its keys, the curves that it takes, its
// checks. Kinds themselves are in experiments/studies, a folder each; the vocabulary holds all of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/curve_view.hpp"
#include "core/method.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/suite/validate.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

/// Where a study keeps the value of a key. The type determines what may be written.
using Slot = std::variant<const Kind**, std::string*, Form*, std::int64_t*, std::vector<int>*, std::vector<double>*,
                          std::vector<Interval>*, std::vector<std::string>*, std::vector<ScalarKind>*,
                          std::vector<Mode>*, ParameterSource*, std::vector<Placement>*, Counting*>;
using Value = std::variant<const Kind* const*, const std::string*, const Form*, const std::int64_t*,
                           const std::vector<int>*, const std::vector<double>*, const std::vector<Interval>*,
                           const std::vector<std::string>*, const std::vector<ScalarKind>*, const std::vector<Mode>*,
                           const ParameterSource*, const std::vector<Placement>*, const Counting*>;

/// Whether the values of a key are swept. They then distinguish the cells of a study, or the cases within each cell.
enum class Axis { none, of_cells, of_cases };

/// Which studies a key is for: all, those that draw their curves, or those whose curves are of sets.
enum class Curves { any, drawn, of_sets };

struct Field {
  std::string_view key;
  std::string_view meaning;        ///< for people
  std::string_view example;        ///< a value, as TOML
  std::string_view left_out = {};  ///< what applies without the key, where the default has no value to show
  bool required = false;
  Axis axis = Axis::none;
  bool settable = true;         ///< with `--set key=v1,v2`
  bool bare_if_single = false;  ///< a list of one value may be written without brackets
  Curves curves = Curves::any;
  /// The place and the value of the key in a study whose kind has it. field() sets both.
  Slot (*slot)(Study& study) = nullptr;
  Value (*value)(const Study& study) = nullptr;
};

/// The field of `Member`, a member of Study.
template <auto Member>
constexpr Field field(Field described) {
  described.slot = [](Study& study) -> Slot { return &(study.*Member); };
  described.value = [](const Study& study) -> Value { return &(study.*Member); };
  return described;
}

/// Whether the key has no value in the study: an empty text, an empty list, a count of 0.
bool is_empty(const Field& field, const Study& study);

/// The number of values that are swept; 1 for a key that is not an axis and for an axis without values.
std::size_t sweep_length(const Field& field, const Study& study);

/// The value as TOML; empty where is_empty() holds.
std::string to_text(const Field& field, const Study& study);

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
  /// The first fault in the kind's own keys, apart from missing ones and from values that no kind takes. May be null.
  Finding (*check)(const Study& study) = nullptr;
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
/// The first fault in the inputs and axes of a timing study: what the problem of its methods, that of the kind
/// `judged`, does not take, or requires.
Finding check_timed(const Study& study, const Kind& judged, std::span<const KnownGenerator> generators);

inline constexpr Field order_key{.key = "order",
                                 .meaning = "orders of the derivatives, 0 to 1023",
                                 .example = "[1, 2]",
                                 .required = true,
                                 .axis = Axis::of_cases};
static_assert(max_degree == 1023, "the meaning of order states it");

inline constexpr int most_points = 1000000;
inline constexpr Field points_key{.key = "points",
                                  .meaning = "numbers of data points, 2 to 1000000",
                                  .example = "[10, 100]",
                                  .required = true,
                                  .axis = Axis::of_cases};
static_assert(most_points == 1000000, "the meaning of points states it");

constexpr Field tolerance_key(std::string_view meaning, std::string_view example) {
  return {.key = "tolerance", .meaning = meaning, .example = example, .required = true, .axis = Axis::of_cases};
}

constexpr Field budget_key(std::string_view meaning) {
  return {
      .key = "budget", .meaning = meaning, .example = "20000", .left_out = "nothing: it is required", .required = true};
}

inline constexpr Field published_key{
    .key = "published",
    .meaning = "file of printed values in reference/published that the results are compared with",
    .example = "\"report_tables.csv\"",
    .left_out = "none",
    .settable = false};

/// A copy of `key` for a kind that does not require it. `left_out` says what applies without it.
constexpr Field optional(Field key, std::string_view left_out) {
  key.required = false;
  key.left_out = left_out;
  return key;
}

}  // namespace bezierbench::suite
