// SPDX-License-Identifier: MIT
// The words for the enumerations of a suite; the only list of them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

template <class Enum>
struct Word {
  Enum value;
  std::string_view word;
};

/// All values of `Enum` with their words, in the order of their declaration; specialised below.
template <class Enum>
inline constexpr std::array<Word<Enum>, 0> words{};

/// The forms in which a curve is given.
template <>
inline constexpr std::array<Word<Form>, 3> words<Form>{{{Form::bernstein, bezierbench::name(Form::bernstein)},
                                                        {Form::power, bezierbench::name(Form::power)},
                                                        {Form::rational, bezierbench::name(Form::rational)}}};

/// Words that are read as well: those of suites and tables before schema version 3.
template <class Enum>
inline constexpr std::array<Word<Enum>, 0> earlier_words{};

template <>
inline constexpr std::array<Word<Form>, 2> earlier_words<Form>{
    {{Form::bernstein, "bezier"}, {Form::power, "polynomial"}}};

template <>
inline constexpr std::array<Word<ScalarKind>, 2> words<ScalarKind>{
    {{ScalarKind::float32, "float"}, {ScalarKind::float64, "double"}}};

template <>
inline constexpr std::array<Word<Mode>, 4> words<Mode>{
    {{Mode::one_shot, "one_shot"}, {Mode::point, "point"}, {Mode::latency, "latency"}, {Mode::batch, "batch"}}};

template <>
inline constexpr std::array<Word<ParameterSource>, 3> words<ParameterSource>{
    {{ParameterSource::drawn, "drawn"}, {ParameterSource::grid, "grid"}, {ParameterSource::stored, "stored"}}};

template <>
inline constexpr std::array<Word<Placement>, 3> words<Placement>{
    {{Placement::stored, "stored"}, {Placement::scaled, "scaled"}, {Placement::translated, "translated"}}};

template <>
inline constexpr std::array<Word<Counting>, 3> words<Counting>{
    {{Counting::none, "none"}, {Counting::beside_times, "beside_times"}, {Counting::only, "only"}}};

template <class Enum>
concept Worded = words<Enum>
.size() > 0;

/// The word for `value`.
template <Worded Enum>
constexpr std::string_view name(Enum value) {
  for (const auto& entry : words<Enum>) {
    if (entry.value == value) return entry.word;
  }
  return "unknown";
}

/// The value that `word`, also an earlier one, stands for; empty for any other word. Case matters.
template <Worded Enum>
constexpr std::optional<Enum> parse(std::string_view word) {
  for (const auto& entry : words<Enum>) {
    if (entry.word == word) return entry.value;
  }
  for (const auto& entry : earlier_words<Enum>) {
    if (entry.word == word) return entry.value;
  }
  return std::nullopt;
}

/// All words, for messages.
template <Worded Enum>
std::vector<std::string> all_words() {
  std::vector<std::string> all;
  for (const auto& entry : words<Enum>) all.emplace_back(entry.word);
  return all;
}

}  // namespace bezierbench::suite
