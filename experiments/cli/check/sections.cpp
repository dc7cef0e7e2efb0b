// SPDX-License-Identifier: MIT
#include "experiments/cli/check/sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/cli/terminal/wrapped.hpp"

namespace bezierbench::cli {
namespace {

constexpr std::size_t indent = 12;

/// `shown` details of each section.
std::string text_with(const std::vector<Section>& sections, const std::vector<std::size_t>& shown, std::size_t width) {
  std::string text;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const auto& section = sections[k];
    const auto left = section.details.size() - shown[k];
    const auto head = left > 0 ? fmt::format("{}; {} more with --all", section.head, left) : section.head;
    text += wrapped(padded(section.label, indent), head, indent, width);
    for (std::size_t i = 0; i < shown[k]; ++i)
      text += wrapped(std::string(indent, ' '), section.details[i], indent, width);
  }
  return text;
}

}  // namespace

std::string text_of(const std::vector<Section>& sections, std::size_t lines, std::size_t width) {
  std::vector<std::size_t> shown(sections.size(), 0);
  std::string text = text_with(sections, shown, width);
  bool any = true;
  while (any) {
    any = false;
    for (const bool finding : {true, false})
      for (std::size_t k = 0; k < sections.size(); ++k) {
        const auto& section = sections[k];
        if (section.is_finding != finding || shown[k] == std::min(section.most, section.details.size())) continue;
        ++shown[k];
        auto longer = text_with(sections, shown, width);
        if (static_cast<std::size_t>(std::ranges::count(longer, '\n')) <= lines) {
          text = std::move(longer);
          any = true;
        } else {
          --shown[k];
        }
      }
  }
  return text;
}

std::string whole_text_of(const std::vector<Section>& sections, std::size_t width) {
  std::vector<std::size_t> shown;
  for (const auto& section : sections) shown.push_back(section.details.size());
  return text_with(sections, shown, width);
}

}  // namespace bezierbench::cli
