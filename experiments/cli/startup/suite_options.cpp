// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/suite_options.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>
#include <utility>

#include "experiments/cli/startup/curve_sets.hpp"
#include "experiments/cli/startup/suites_folder.hpp"
#include "experiments/cli/startup/vocabulary.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/validate.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::cli {
namespace {

/// The number in an option, from 0 on. CLI11 would turn a number beyond the range of the type into the largest one of the
/// type. Throws Failure(Exit::usage).
std::int64_t whole_number(std::string_view option, const std::string& text) {
  const auto number = number::parse_integer(text);
  if (!number || *number < 0)
    throw Failure(Exit::usage, fmt::format("{} {}: must be a whole number from 0 to 2^63-1", option, text));
  return *number;
}

}  // namespace

void SuiteOptions::add_suites(Command& command) {
  command.option("SUITE", words_, "id of a shipped suite, or a file: a word with / or ending in .toml")
      .required()
      .takes(suite_value, shipped_suites);
}

void SuiteOptions::add_changes(Command& command) {
  command.option("--seed", seed_, "seed; default: that of the suite");
  command.option("--trials", trials_, "trials per cell and replicate").takes("N");
  command
      .option("--set", overrides_.set,
              "set an axis or key of every study, which each must have; an interval is written 0:0.2")
      .takes("KEY=V1,V2", known_settings);
  command.option("--only", overrides_.only, "run only studies whose id matches this pattern").takes("GLOB");
}

void SuiteOptions::add_curves(Command& command) {
  command
      .option("--curves", curves_,
              "curve files, or ids of shipped curve sets, whose curves are the inputs of every study that takes curves")
      .takes("FILE", shipped_curves);
}

void SuiteOptions::add_no_timing(Command& command) {
  command.flag("--no-timing", overrides_.no_timing, "skip timing studies");
}

std::vector<std::filesystem::path> SuiteOptions::files() const {
  std::vector<std::filesystem::path> files;
  for (const auto& word : words_) files.push_back(suite_file(word));
  return files;
}

std::vector<suite::Suite> SuiteOptions::read(const suite::Vocabulary& known) const {
  auto overrides = overrides_;
  if (seed_) overrides.seed = static_cast<std::uint64_t>(whole_number("--seed", *seed_));
  if (trials_) overrides.trials = whole_number("--trials", *trials_);
  std::vector<suite::Suite> suites;
  for (const auto& file : files()) {
    for (auto& one : suite::read_suites(file, known)) suites.push_back(std::move(one));
    suite::check_unique_ids(suites, file.string());
  }
  if (!curves_.empty()) take_curves(suites, curves_);
  suite::apply(overrides, suites, known);
  if (!curves_.empty())
    for (const auto& one : suites)
      for (const auto& study : one.studies)
        if (const auto fault = suite::validate(study, known)) suite::refuse(study, *fault);
  load_curves(suites);
  if (!curves_.empty()) drop_without_curves(suites);
  return suites;
}

}  // namespace bezierbench::cli
