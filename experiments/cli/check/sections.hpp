// SPDX-License-Identifier: MIT
// A text of labelled sections that fits into a number of lines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bezierbench::cli {

/// Its head is always shown.
struct Section {
  std::string label;
  std::string head;
  std::vector<std::string> details;  ///< the most important first
  std::size_t most = 3;              ///< of the details that are worth a line
  bool is_finding = false;           ///< something is wrong, so that its details come before those of other sections
};

/// The sections, each with as many details as `lines` lines of `width` characters have room for. Sections take turns,
/// findings first. A head says how many details are left out.
std::string text_of(const std::vector<Section>& sections, std::size_t lines, std::size_t width);

/// The sections with all details.
std::string whole_text_of(const std::vector<Section>& sections, std::size_t width);

}  // namespace bezierbench::cli
