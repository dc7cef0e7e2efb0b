// SPDX-License-Identifier: MIT
// The words of the contract for the enumerations of a suite; the only list of them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

template <>
inline constexpr std::array<Word<Kind>, 12> words<Kind>{{{Kind::accuracy, "accuracy"},
                                                         {Kind::search, "search"},
                                                         {Kind::conversion, "conversion"},
                                                         {Kind::timing, "timing"},
                                                         {Kind::roofline, "roofline"},
                                                         {Kind::derivative, "derivative"},
                                                         {Kind::arc_length, "arc_length"},
                                                         {Kind::inverse_arc_length, "inverse_arc_length"},
                                                         {Kind::projection, "projection"},
                                                         {Kind::interpolation, "interpolation"},
                                                         {Kind::fitting, "fitting"},
                                                         {Kind::subdivision, "subdivision"}}};

template <>
inline constexpr std::array<Word<CurveKind>, 3> words<CurveKind>{
    {{CurveKind::bezier, "bezier"}, {CurveKind::polynomial, "polynomial"}, {CurveKind::rational, "rational"}}};

template <>
inline constexpr std::array<Word<ScalarKind>, 2> words<ScalarKind>{
    {{ScalarKind::float32, "float"}, {ScalarKind::float64, "double"}}};

template <>
inline constexpr std::array<Word<Mode>, 4> words<Mode>{
    {{Mode::one_shot, "one_shot"}, {Mode::point, "point"}, {Mode::latency, "latency"}, {Mode::batch, "batch"}}};

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

/// The value that `word` stands for; empty for any other word. Case matters.
template <Worded Enum>
constexpr std::optional<Enum> parse(std::string_view word) {
  for (const auto& entry : words<Enum>) {
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
