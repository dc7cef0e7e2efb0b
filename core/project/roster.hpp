// SPDX-License-Identifier: MIT
// Every method for point projection. One line here makes it exist everywhere.
#pragma once

#include "core/project/quintic_companion.hpp"
#include "core/project/quintic_durand_kerner.hpp"
#include "core/project/quintic_isolate.hpp"
#include "core/project/quintic_jenkins_traub.hpp"
#include "core/project/quintic_seed_002.hpp"
#include "core/project/scan_bisect.hpp"
#include "core/project/scan_length.hpp"
#include "core/project/scan_refine.hpp"
#include "core/project/seed_004_scan.hpp"
#include "core/project/seed_004_subdivide.hpp"
#include "core/project/subdivide_hull.hpp"

namespace bezierbench {

using ProjectionMethods = TypeList<QuinticIsolate,                       //
                                   QuinticCompanion,                     //
                                   SubdivideHull,                        //
                                   ScanBisect,                           //
                                   ScanRefine,                           //
                                   QuinticSeed002,                       //
                                   QuinticDurandKerner,                  //
                                   QuinticJenkinsTraub,                  //
                                   ScanLength,                           //
                                   Seed004Scan,                          //
                                   Seed004Subdivide,                     //
                                   ProjectionOfRational<SubdivideHull>,  //
                                   ProjectionOfRational<ScanBisect>,     //
                                   ProjectionOfRational<ScanRefine>>;

}  // namespace bezierbench
