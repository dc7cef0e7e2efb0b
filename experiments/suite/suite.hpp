// SPDX-License-Identifier: MIT
// The values in a suite file: which studies, over which axes.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::sample {
struct LoadedSet;
class CurveSlice;
}  // namespace bezierbench::sample

namespace bezierbench::suite {

// Where a study and its keys are written, for messages about faults.

/// A place in a file; line and column count from 1.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct KeyPlace {
  Position key;
  Position value;
  std::vector<Position> elements;  ///< for a value that is an array
};

struct Places {
  std::string file;  ///< empty for a study that was not read from a file
  Position header;   ///< place of the [[study]] line
  std::map<std::string, KeyPlace, std::less<>> keys;
  std::map<std::string, std::string, std::less<>> options;  ///< by key: the option that has set it
};

// Types of the values of a suite's keys, other than numbers, texts and forms of curves.

enum class ScalarKind { float32, float64 };

/// What one timed call does: prepare and one point; one prepared point; a dependent chain of points; one curve at many
/// t.
enum class Mode { one_shot, point, latency, batch };

/// Which parameters a study takes on each curve of a set: drawn ones, a grid that has both ends of the interval, or
/// those that the set stores.
enum class ParameterSource { drawn, grid, stored };

/// Where the curves of a set lie: as stored; each multiplied by a drawn factor from [1/2, 1); each moved by a drawn
/// offset of at most 64 times the largest coordinate on every axis, like a glyph on a page. The results are rounded
/// once.
enum class Placement { stored, scaled, translated };

/// Whether a timing study counts instructions: `none`; `beside_times`; or `only`, without any times.
enum class Counting { none, beside_times, only };

struct Interval {
  double min = 0;
  double max = 1;
  friend auto operator<=>(const Interval&, const Interval&) = default;
};

struct Kind;

/// One [[study]] table. Axes are swept in the cross product.
struct Study {
  Places places;  ///< for messages
  std::string id;
  std::string title;
  const Kind* kind = nullptr;   ///< null only in studies that no one asks for their kind
  Form form = Form::bernstein;  ///< the form in which random curves are drawn, one of those that are given
  std::vector<int> degree;
  std::vector<double> coordinate_range{1.0};
  std::vector<Interval> t_interval{Interval{}};
  std::vector<std::string> generator{"continuous"};  ///< default of a rational study: the first that draws weights
  std::vector<int> dimension{2};
  std::vector<ScalarKind> scalar{ScalarKind::float64};
  std::vector<std::string> methods;            ///< ids or globs as written; empty: all that apply
  std::int64_t trials = 1000;                  ///< per replicate
  std::int64_t replicates = 1;                 ///< independent repetitions, for a band
  std::vector<std::string> baseline{"exact"};  ///< what errors are measured against: `exact` or a method id

  // Keys of studies whose curves are those of sets; none of them is drawn then.
  std::vector<std::string> curves;  ///< sets, each a file or the id of a shipped one; SET#GLOB: some of its curves
  std::vector<std::string> curves_sha256;  ///< the identities of the sets; empty: not stated
  std::int64_t parameters = 1;             ///< of each curve
  ParameterSource parameters_from = ParameterSource::drawn;
  std::vector<Placement> placement{Placement::stored};
  std::vector<std::shared_ptr<const sample::LoadedSet>> sets;  ///< those of `curves`, once they were read
  /// The inputs, where the study is one of those that sample::studies_of() makes of a study of sets; else null.
  std::shared_ptr<const sample::CurveSlice> slice;

  // Keys that not every kind has; the kind's own fields (kind.hpp) say which.
  std::vector<int> order;         ///< orders of derivatives
  std::vector<int> points;        ///< numbers of data points, or of points of a grid
  std::vector<double> tolerance;  ///< relative to a length, or distances from data
  std::vector<Mode> modes{Mode::one_shot, Mode::point, Mode::latency, Mode::batch};
  Counting counts = Counting::none;
  std::string published;                ///< file of printed values in reference/published; may be empty
  std::int64_t decomposed_trials = 0;   ///< trials per cell whose error is split into its parts
  std::int64_t budget = 0;              ///< inputs that a search may try per cell and method
  std::int64_t kept = 8;                ///< hard cases of each family and search
  std::vector<std::string> properties;  ///< guarantees that are searched for; empty: all of them
};

struct Suite {
  std::string id;
  std::string title;
  std::uint64_t seed = 1;
  std::vector<Study> studies;
};

// The words for the enumerations of a suite; the only list of them.

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
  for (const auto& entry : words<Enum>)
    if (entry.value == value) return entry.word;
  return "unknown";
}

/// The value that `word`, also an earlier one, stands for; empty for any other word. Case matters.
template <Worded Enum>
constexpr std::optional<Enum> parse(std::string_view word) {
  for (const auto& entry : words<Enum>)
    if (entry.word == word) return entry.value;
  for (const auto& entry : earlier_words<Enum>)
    if (entry.word == word) return entry.value;
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
