// SPDX-License-Identifier: MIT
// Formula: coefficients without a change of sign have no root; those with more than one are halved, by de Casteljau;
//   one change is one root, which is bisected. A coefficient 0 at an end is a root there.
// Cost: a halving takes n(n+1)/2 midpoints.
// Bound: none.
// Fails: a root of even multiplicity is found twice, once or not at all, as the roundings of the halves decide; so are
//   two roots whose distance is about sqrt(u).
#pragma once

#include "core/roots/roots.hpp"
#include "core/roots/subdivision.hpp"

namespace bezierbench {

struct LaneRiesenfeld {
  static constexpr MethodInfo info{.id = "lane_riesenfeld",
                                   .label = "Subdivision by sign changes, bisection",
                                   .problem = Problem::roots,
                                   .flops = "104n(n+1) a root",
                                   .cost_exponent = 3,
                                   .citation = "[Lane and Riesenfeld 1981]"};

  static FoundRoots find(const std::vector<double>& b) {
    FoundRoots found;
    if (b.front() == 0) found.t.push_back(0);
    found.evaluations = each_root_inside(b, 0, 1, [&](double t) { found.t.push_back(t); });
    if (b.back() == 0 && b.size() > 1) found.t.push_back(1);
    return found;
  }
};

}  // namespace bezierbench
