// SPDX-License-Identifier: MIT
// The options that give a command external methods.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/external/method.hpp"

namespace bezierbench::cli {

/// --plugin, --program and the limits of their processes.
class ExternalOptions {
 public:
  /// `own` are the methods that are compiled into this program.
  explicit ExternalOptions(std::span<const external::OwnMethod> own) : own_(own.begin(), own.end()) {}

  void add(Command& command);
  /// Opens every method. Throws Failure(usage) for an invalid one, and where two have the same id.
  [[nodiscard]] external::Methods methods() const;
  /// The words of these options, as another process of the program takes them on its command line.
  [[nodiscard]] std::vector<std::string> arguments() const;

 private:
  std::vector<external::OwnMethod> own_;
  std::vector<std::string> plugins_;
  std::vector<std::string> programs_;
  std::optional<std::string> seconds_;
  std::optional<std::string> megabytes_;
};

/// The answers of a file; without `id` the method is named after the file.
std::shared_ptr<const external::Method> read_answers(const std::string& file, const std::optional<std::string>& id);

/// Throws Failure(usage) where the suite file records an external method that was not given.
void require_recorded(const std::string& suite_file, const external::Methods& given);

}  // namespace bezierbench::cli
