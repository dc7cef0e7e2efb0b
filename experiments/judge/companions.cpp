// SPDX-License-Identifier: MIT
#include "experiments/judge/companions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/fit/kernel.hpp"
#include "core/interpolate/kernel.hpp"
#include "core/project/kernel.hpp"
#include "core/subdivide/kernel.hpp"
#include "experiments/failure.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::judge {
namespace {

using Infos = std::span<const MethodInfo* const> (*)();

/// One entry for each problem's roster, and one for the methods of other libraries.
constexpr std::array<Infos, 8> rosters{derivative_infos, arc_length_infos,    inverse_arc_length_infos,
                                       projection_infos, interpolation_infos, fitting_infos,
                                       split_infos,      companion_peer_infos};

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
  if (study.methods.empty()) {
    std::erase_if(infos, [](const MethodInfo* info) { return suite::is_peer(info->id); });
    return infos;
  }
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

void check_bezier_in_double(const suite::Study& study) {
  if (study.curve != suite::CurveKind::bezier)
    throw Failure(Exit::usage, fmt::format("study \"{}\": kind \"{}\" is for Bezier curves; write curve = \"bezier\"",
                                           study.id, suite::name(study.kind)));
  if (study.scalar != std::vector{suite::ScalarKind::float64})
    throw Failure(Exit::usage, fmt::format("study \"{}\": kind \"{}\" is in double only; write scalar = [\"double\"]",
                                           study.id, suite::name(study.kind)));
}

void check_independent_points(const suite::Study& study) {
  for (const auto& generator : sample::generators())
    if (generator.limits.exact_coefficients && std::ranges::count(study.generator, generator.id) > 0)
      throw Failure(Exit::usage, fmt::format("study \"{}\": generator \"{}\" draws a curve as a whole, not "
                                             "points; choose another, see `list generators`",
                                             study.id, generator.id));
}

}  // namespace bezierbench::judge
