// SPDX-License-Identifier: MIT
// A key of a [[study]] table: what it means and where its value is kept. Reader, overrides, writer, the descriptions
// of the kinds and the JSON Schema go through it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/suite/suite.hpp"

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

}  // namespace bezierbench::suite
