// SPDX-License-Identifier: MIT
// The options of `choose`, its two other forms, and numbers and lines of a choice, for people.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cli/terminal/text.hpp"
#include "experiments/failure.hpp"
#include "experiments/metric/class_bound.hpp"
#include "experiments/metric/pareto.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/choices.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::cli {

/// The options as they were given, and the numbers in their texts.
struct Wish {
  std::string bundle;
  std::vector<std::string> curves;  ///< files, or ids of shipped sets
  bool measure = false;             ///< times of now
  std::optional<std::string> degree_text;
  int degree = 0;
  std::string tolerance_text;
  double tolerance = 0;
  std::string unit = "u";
  std::optional<std::string> range_text;
  std::optional<double> range;
  std::string problem;  ///< a kind of study whose methods are timed
  std::string form = "bernstein";
  std::string mode = "point";
  std::string scalar = "double";
  int dimension = 2;
  std::string study;           ///< of the times; empty for any
  std::string accuracy_study;  ///< of the errors and faults; empty for all
  std::string format = "text";

  [[nodiscard]] const tables::LargestError& error_of(const tables::Choice& choice) const {
    return unit == "u" ? choice.errors.in_u : choice.errors.absolute;
  }
  [[nodiscard]] std::string_view unit_words() const { return unit == "u" ? "u p~" : "coordinate units"; }
};

/// `choose --curves` prints one ranking for each form, dimension and degree of the curves, the most frequent non-linear
/// one first. Accuracy is measured on them, times come from the shipped answers or from a race on them. Returns
/// `finding` where a tolerance is given that no method keeps in one of the rankings. Throws Failure as load_curves()
/// does.
Exit choose_on_curves(const Wish& wish);

/// The problems that `choose --problem` takes, such as arc length or flattening: the kinds of studies whose table
/// declares faults.
std::vector<std::string> companion_problems();

/// Prints the methods of a companion problem that were timed and judged, those without a fault first, each part the
/// fastest first. Returns `finding` where every method has a fault. Throws Failure(usage) where the bundle has no such
/// rows, with the available values.
Exit choose_companion(const Wish& wish);

/// The value to four digits.
inline std::string brief(double value) { return fmt::format("{:.4g}", value); }

/// The value to three digits, for tables; whole numbers up to a million.
inline std::string in_table(double value) {
  constexpr double least_whole = 1000;
  constexpr double most_whole = 1e6;
  return value >= least_whole && value < most_whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// `0.244 [0.24, 0.25]`; empty where there is no ratio.
inline std::string ratio_text(const tables::Choice& choice) {
  if (!choice.ratio) return "";
  const auto& [median, low, high] = *choice.ratio;
  return fmt::format("{} [{}, {}]", in_table(median), in_table(low), in_table(high));
}

/// The id of a method, after a mark where it is on the Pareto front: `* de_casteljau`.
inline std::string marked(const std::string& method, metric::Front front) {
  const auto* mark = front == metric::Front::on ? "* " : front == metric::Front::off ? "  " : "? ";
  return mark + method;
}

/// The median, or an end, of an interval; empty where there is none.
inline std::optional<double> end_of(const std::optional<metric::Interval>& interval, double metric::Interval::*end) {
  return interval ? std::optional((*interval).*end) : std::nullopt;
}

/// Lines in the width of the terminal, those after the first four characters to the right.
inline std::string paragraph(const std::string& text) { return wrapped("", printable(text), 4); }
inline std::string indented(const std::string& text) { return wrapped("  ", printable(text), 4); }

/// The curves with coordinates in [-range, range], at parameters in the interval.
struct DrawnClass {
  double range = 0;
  suite::Interval t;
  /// What is known of it is known of coordinates in [-range, range] 2^-exponent: no method's roundings depend on a
  /// power of two, as long as no number leaves the range of normal ones.
  int exponent = 0;

  [[nodiscard]] double judged_range() const { return std::ldexp(range, -exponent); }
};

/// The class that was timed, with another range if one is given. Empty where timing.csv does not state it in numbers.
std::optional<DrawnClass> class_of(const tables::ChoiceGroup& group, std::optional<double> range);

/// The ranges of the curves on which methods of the group were judged, ascending. Only `accuracy_study` counts, unless
/// it is empty.
std::vector<double> judged_ranges(const tables::ChoiceGroup& group, const tables::JudgedTables& judged,
                                  const std::string& accuracy_study);

/// The class itself, where its range is one of those that were judged, else the smallest that contains it and has one
/// of these ranges times a power of two. Empty where the curves are so large or small that methods may overflow or
/// underflow. Of several such ranges that of the timed curves is taken, `timed`, then the nearest.
std::optional<DrawnClass> scaled_to(DrawnClass of, double timed, const std::vector<double>& judged, bool in_float);

/// Sets the errors of the group's methods over all rows whose range and interval lie within the class, and the bounds
/// of the class. Only rows of `accuracy_study` count, unless it is empty. Removes methods without a row for the class
/// itself. `methods` is methods.csv: a bound is used only if the one stated there is that of this program. Returns the
/// cells of these rows in words, each once: `truth: R 1, t in [0, 1], continuous, 1000 trials`.
std::vector<std::string> judge_class(tables::ChoiceGroup& group, const DrawnClass& of,
                                     const tables::JudgedTables& judged,
                                     const std::optional<bundle::CsvDocument>& methods,
                                     const std::string& accuracy_study);

/// The least p~ to which bounds in units of u p~ apply in the class.
double least_p_tilde(const tables::ChoiceGroup& group, const DrawnClass& of);

}  // namespace bezierbench::cli
