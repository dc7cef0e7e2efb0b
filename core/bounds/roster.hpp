// SPDX-License-Identifier: MIT
// Every method for boxes. One line here makes it exist everywhere.
#pragma once

#include "core/bounds/bisection_box.hpp"
#include "core/bounds/conic_box.hpp"
#include "core/bounds/control_box.hpp"
#include "core/bounds/exact_box.hpp"
#include "core/bounds/halved_polygon_box.hpp"
#include "core/bounds/quadratic_formula_box.hpp"
#include "core/bounds/split_box.hpp"

namespace bezierbench {

using BoundsMethods = TypeList<ControlBox<Form::bernstein>,    //
                               HalvedPolygonBox,               //
                               QuadraticFormulaBox<false>,     //
                               QuadraticFormulaBox<true>,      //
                               BisectionBox<Form::bernstein>,  //
                               SplitBox,                       //
                               ExactBox<Form::bernstein>,      //
                               ControlBox<Form::rational>,     //
                               ConicBox,                       //
                               BisectionBox<Form::rational>,   //
                               ExactBox<Form::rational>>;

}  // namespace bezierbench
