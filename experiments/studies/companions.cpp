// SPDX-License-Identifier: MIT
#include "experiments/studies/companions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/project/kernel.hpp"
#include "experiments/failure.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::studies {
namespace {

using Infos = std::span<const MethodInfo* const> (*)();

/// One entry for each problem's roster.
constexpr std::array<Infos, 4> rosters{derivative_infos, arc_length_infos, inverse_arc_length_infos, projection_infos};

}  // namespace

std::vector<const MethodInfo*> companion_infos() {
  std::vector<const MethodInfo*> all;
  for (const auto& infos : rosters)
    for (const auto* info : infos()) all.push_back(info);
  return all;
}

std::vector<const MethodInfo*> chosen_companions(const suite::Study& study, Problem problem) {
  auto infos = companion_infos();
  std::erase_if(infos, [&](const MethodInfo* info) { return info->problem != problem; });
  if (study.methods.empty()) return infos;
  const auto means = [](const MethodInfo* info) {
    return [info](const std::string& pattern) { return suite::means(pattern, info->id); };
  };
  for (const auto& pattern : study.methods)
    if (std::ranges::none_of(infos, [&](const MethodInfo* info) { return suite::means(pattern, info->id); }))
      throw Failure(Exit::usage, fmt::format("study \"{}\": \"{}\" is no method for the problem {}; see `list methods`",
                                             study.id, pattern, name(problem)));
  std::erase_if(infos, [&](const MethodInfo* info) { return std::ranges::none_of(study.methods, means(info)); });
  return infos;
}

}  // namespace bezierbench::studies
