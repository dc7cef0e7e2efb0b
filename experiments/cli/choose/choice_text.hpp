// SPDX-License-Identifier: MIT
// Numbers and lines of a choice, for people.
#pragma once

#include <fmt/format.h>

#include <string>

#include "experiments/cli/startup/diagnostics.hpp"
#include "experiments/cli/terminal/wrapped.hpp"
#include "experiments/tables/choices.hpp"

namespace bezierbench::cli {

/// The value to four digits.
inline std::string brief(double value) { return fmt::format("{:.4g}", value); }

/// `0.244 [0.24, 0.25]`; empty where there is no ratio.
inline std::string ratio_text(const tables::Choice& choice) {
  if (!choice.ratio) return "";
  return fmt::format("{:.3g} [{:.3g}, {:.3g}]", choice.ratio->median, choice.ratio->low, choice.ratio->high);
}

/// Lines in the width of the terminal, those after the first four characters to the right.
inline std::string paragraph(const std::string& text) { return wrapped("", printable(text), 4); }
inline std::string indented(const std::string& text) { return wrapped("  ", printable(text), 4); }

}  // namespace bezierbench::cli
