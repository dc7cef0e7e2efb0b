// SPDX-License-Identifier: MIT
// The curve sets that suites name: files, or shipped sets by their ids.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/sample/curve_slice.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

/// The ids of the shipped sets, sorted.
std::vector<std::string> shipped_curves();

/// A set that is not read from a file; `id` as in the tables of a bundle.
std::shared_ptr<const sample::LoadedSet> set_of(std::string_view id, curves::CurveSet given);

/// Reads the sets of all studies into Study::sets. An entry with `/` or a known extension is a file, relative to the
/// suite's; any other is the id of a shipped set; SET#GLOB takes the curves whose ids match. States their SHA-256 in the
/// study. Throws Failure(usage) for what is not a set, for a set without curves and for another SHA-256 than the study
/// states, and Failure(input_output) for a file that cannot be read.
void load_curves(std::vector<suite::Suite>& suites);

/// Names the files by copies that are to lie beside the suites, in a bundle, and returns these, name and text. Shipped sets
/// keep their ids.
std::vector<std::pair<std::string, std::string>> curves_beside(std::vector<suite::Suite>& suites);

/// Replaces the inputs of every study that can take curve sets by those of `files`, and drops the other studies. Throws
/// Failure(usage) where none is left.
void take_curves(std::vector<suite::Suite>& suites, const std::vector<std::string>& files);

/// Drops the studies of sets that take none of the curves of their sets. Throws Failure(usage) where none is left.
void drop_without_curves(std::vector<suite::Suite>& suites);

}  // namespace bezierbench::cli
