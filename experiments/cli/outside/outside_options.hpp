// SPDX-License-Identifier: MIT
// The options that give a command methods from outside.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/cli/command.hpp"
#include "experiments/outside/method.hpp"
#include "experiments/outside/own.hpp"

namespace bezierbench::cli {

/// --plugin, --program and the limits of their processes.
class OutsideOptions {
 public:
  /// `own` are the methods that this program has compiled in.
  explicit OutsideOptions(std::span<const outside::OwnMethod> own) : own_(own.begin(), own.end()) {}

  void add(Command& command);
  /// Queries every method. Throws Failure(usage) for one that does not answer, and where two have the same id.
  [[nodiscard]] outside::Methods methods() const;

 private:
  std::vector<outside::OwnMethod> own_;
  std::vector<std::string> plugins_;
  std::vector<std::string> programs_;
  std::optional<std::string> seconds_;
  std::optional<std::string> megabytes_;
};

/// The answers of a file; without `id` they are named after the file.
std::shared_ptr<const outside::Method> read_answers(const std::string& file, const std::optional<std::string>& id);

/// Throws Failure(usage) where the suite file records a method from outside that was not given.
void require_recorded(const std::string& suite_file, const outside::Methods& given);

}  // namespace bezierbench::cli
