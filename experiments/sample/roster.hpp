// SPDX-License-Identifier: MIT
// Every generator. One line here makes it exist: in suites, `list generators` and tests.
#pragma once

#include <tuple>

#include "experiments/sample/bspline.hpp"
#include "experiments/sample/cusp.hpp"
#include "experiments/sample/independent_points.hpp"
#include "experiments/sample/roots.hpp"
#include "experiments/sample/thin.hpp"
#include "experiments/sample/weights.hpp"

namespace bezierbench::sample {

using Generators = std::tuple<Continuous,      //
                              Dyadic,          //
                              Integer,         //
                              Report,          //
                              WeightsMild,     //
                              WeightsWild,     //
                              MultipleRoot,    //
                              ClusteredRoots,  //
                              Cusp,            //
                              Distant,         //
                              Local,           //
                              Graded,          //
                              Thin,            //
                              Bspline>;

}  // namespace bezierbench::sample
