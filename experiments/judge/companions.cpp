// SPDX-License-Identifier: MIT
#include "experiments/judge/companions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/kernel.hpp"
#include "core/bspline/kernel.hpp"
#include "core/derivative/kernel.hpp"
#include "core/fit/kernel.hpp"
#include "core/grid/kernel.hpp"
#include "core/interpolate/kernel.hpp"
#include "core/project/kernel.hpp"
#include "core/subdivide/kernel.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::judge {
namespace {

/// One entry for each problem's roster, and one for the methods of other libraries.
constexpr std::array rosters{derivative_infos,    arc_length_infos,    inverse_arc_length_infos,
                             projection_infos,    interpolation_infos, fitting_infos,
                             split_infos,         grid_infos,          bspline_infos,
                             companion_peer_infos};

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
  for (std::size_t k = 0; k < study.methods.size(); ++k)
    if (std::ranges::none_of(infos, [&](const MethodInfo* info) { return suite::means(study.methods[k], info->id); }))
      suite::refuse(study, {"methods",
                            k,
                            {},
                            fmt::format("\"{}\" is no method for the problem {}; see `list methods`", study.methods[k],
                                        name(problem))});
  std::erase_if(infos, [&](const MethodInfo* info) { return std::ranges::none_of(study.methods, means(info)); });
  return infos;
}

void require_form(const suite::Study& study, bool any_method) {
  if (any_method) return;
  suite::refuse(study,
                {study.methods.empty() ? "curve" : "methods", 0, "curve",
                 fmt::format("none of its methods takes curves in {} form; see `list methods`", name(study.curve))});
}

}  // namespace bezierbench::judge
