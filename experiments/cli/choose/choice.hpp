// SPDX-License-Identifier: MIT
// What a user wants of a method, the methods that a bundle has for it, and both in words and tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/choose/class_choice.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {

struct Wish {
  std::string bundle;
  int degree = 0;
  std::string tolerance_text;
  double tolerance = 0;
  std::string unit = "u";
  std::optional<std::string> range_text;
  std::optional<double> range;
  std::string form = "bernstein";
  std::string mode = "point";
  std::string scalar = "double";
  int dimension = 2;
  std::string study;
  std::string accuracy_study;
  std::string format = "text";
  bool use_damaged = false;
  std::vector<std::string> damaged;  ///< damaged files of the bundle that were used nevertheless

  [[nodiscard]] const tables::LargestError& error_of(const tables::Choice& choice) const {
    return unit == "u" ? choice.errors.in_u : choice.errors.absolute;
  }
};

/// The methods of one race, and the class of curves of the choice.
struct JudgedRace {
  tables::ChoiceGroup group;
  DrawnClass of;
  std::vector<std::string> cells;        ///< in which the methods were judged
  std::vector<std::string> others = {};  ///< races that could have been taken, in words
};

/// The timing study and how its curves were drawn: `speed-bezier: coordinates in [-1, 1], t in [0, 1], continuous`.
std::string timed_curves(const JudgedRace& race);

/// `coordinates in [-1, 1], t in [0, 1]`.
std::string in_words(const DrawnClass& of);

/// The command that makes a bundle in which such a choice can be made, as the end of a message. Empty where no suite
/// that comes with the program has errors and times of such methods.
std::string remedy(const Wish& wish);

/// The largest error seen of a method, in short and with its unit.
std::string error_text(const tables::Choice& choice, const Wish& wish);

/// The methods within the tolerance, in the order of the race. This function and those below expect the methods sorted,
/// the fastest first.
std::vector<const tables::Choice*> within(const JudgedRace& race, const Wish& wish);

/// These methods as CSV.
bundle::CsvTable csv_table(const JudgedRace& race, const Wish& wish);

/// The same for people: the fastest and its rivals, the class and the cells that the errors are of, and a table. Without
/// the first where no method is within the tolerance.
std::string choice_text(const JudgedRace& race, const Wish& wish);

}  // namespace bezierbench::cli
