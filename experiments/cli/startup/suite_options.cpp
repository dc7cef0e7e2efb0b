// SPDX-License-Identifier: MIT
#include "experiments/cli/startup/suite_options.hpp"

#include <utility>

#include "experiments/cli/startup/known_values.hpp"
#include "experiments/cli/startup/suites_folder.hpp"
#include "experiments/cli/terminal/whole_number.hpp"
#include "experiments/suite/text/reader.hpp"
#include "experiments/suite/validate.hpp"

namespace bezierbench::cli {

void SuiteOptions::add_suites(Command& command) {
  command.option("suites", words_, "ids of suites that come with the program, or files: words with a / or .toml")
      .required()
      .takes(suite_value, shipped_suites);
}

void SuiteOptions::add_changes(Command& command) {
  command.option("--seed", seed_, "another seed than the suite's");
  command.option("--trials", trials_, "trials per cell and replicate").takes("N");
  command
      .option("--set", overrides_.set,
              "for every study; intervals as 0:0.2; a key that one of them does not have is refused")
      .takes("KEY=V1,V2", known_settings);
  command.option("--only", overrides_.only, "only studies whose id matches this glob").takes("GLOB");
}

void SuiteOptions::add_no_timing(Command& command) {
  command.flag("--no-timing", overrides_.no_timing, "leave timing studies out");
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
  suite::apply(overrides, suites, known);
  return suites;
}

}  // namespace bezierbench::cli
