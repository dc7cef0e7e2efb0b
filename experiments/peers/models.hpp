// SPDX-License-Identifier: MIT
// Models of CAD, STEP and IGES, as sets of curves. Open CASCADE reads them, where it is in this build.
#pragma once

#include <string>

#include "reference/curves/read.hpp"

namespace bezierbench::peers {

/// Reads the edges of the model in the file `path`, in millimetres, each once. Ids are `EDGE:SEGMENT`, counted from 0.
/// B-splines become the Bezier spans of the part that the edge has of them, exact for the knots and poles that Open
/// CASCADE gives, rounded once; equal weights are those of a polynomial. Arcs of circles and ellipses are rational
/// quadratics of at most a quarter of their ellipse, straight edges are curves of degree 1. All other edges are counted
/// in `left_out`. Messages call the file `name`. Throws curves::Unreadable, but Open CASCADE may crash or not end on
/// what others write, so call it in a process of its own.
using ModelReader = curves::Read (*)(const std::string& path, const std::string& name);

/// Null in a build without Open CASCADE.
ModelReader model_reader();

}  // namespace bezierbench::peers
