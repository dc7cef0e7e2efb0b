// SPDX-License-Identifier: MIT
// Every method for roots. One line here makes it exist everywhere.
#pragma once

#include "core/roots/bezier_clipping.hpp"
#include "core/roots/certified.hpp"
#include "core/roots/closed_form.hpp"
#include "core/roots/companion_eigenvalues.hpp"
#include "core/roots/lane_riesenfeld.hpp"
#include "core/roots/sampled_newton.hpp"

namespace bezierbench {

using RootsMethods = TypeList<LaneRiesenfeld,        //
                              BezierClipping,        //
                              ClosedForm,            //
                              CompanionEigenvalues,  //
                              SampledNewton,         //
                              Certified>;

}  // namespace bezierbench
