// SPDX-License-Identifier: MIT
// The option --truth of the `curve` commands whose truth takes long at high degrees. Answers do not wait for it.
#pragma once

#include <functional>
#include <string>

#include "experiments/cli/command.hpp"

namespace bezierbench::cli {

class TruthOption {
 public:
  void add_to(Command command);

  /// Computes the truth of the curve in `file`, of this degree. Returns false where it was stopped: above degree 20
  /// without --truth it has a second, and a line on standard error says what to do. With --truth a line says that it
  /// takes longer than some seconds.
  [[nodiscard]] bool finishes(const std::string& file, int degree, const std::function<void()>& compute) const;

 private:
  bool wanted_ = false;
};

}  // namespace bezierbench::cli
