// SPDX-License-Identifier: MIT
// A choice in words and tables. The methods of the race must be sorted, the fastest first.
#pragma once

#include <string>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/cli/choose/choice.hpp"

namespace bezierbench::cli {

/// The largest error seen of a method, in short and with its unit.
std::string error_text(const tables::Choice& choice, const Wish& wish);

/// The methods within the tolerance, in the order of the race.
std::vector<const tables::Choice*> within(const JudgedRace& race, const Wish& wish);

/// These methods as CSV.
bundle::CsvTable csv_table(const JudgedRace& race, const Wish& wish);

/// The first of them and why it is the first, and what speaks for others. Empty where there is none.
std::string winner_text(const JudgedRace& race, const Wish& wish);

/// The class, the cells that the errors are of, and an explanation of the words in the table.
std::string heading_text(const JudgedRace& race, const Wish& wish);

/// The methods within the tolerance for people, in columns that a narrow terminal has room for.
std::string methods_table(const JudgedRace& race, const Wish& wish);

}  // namespace bezierbench::cli
