// SPDX-License-Identifier: MIT
#include "bindings/c/curve.hpp"

namespace bezierbench::c {

void require_shape(int dimension, int degree) {
  require(dimension >= 1 && dimension <= max_dimension, BB_ERROR_DIMENSION);
  require(degree >= 0 && degree <= max_degree, BB_ERROR_DEGREE);
}

Form form_at(int form) {
  switch (form) {
    case BB_BERNSTEIN: return Form::bernstein;
    case BB_POWER: return Form::power;
    case BB_RATIONAL: return Form::rational;
    default: throw Refused{BB_ERROR_FORM};
  }
}

CurveView<double> curve_of(const bb_curve* curve) {
  require_pointers(curve);
  const Form form = form_at(curve->form);
  auto view = bezier_curve(curve->dimension, curve->degree, curve->points);
  view.form = form;
  if (form != Form::rational) return view;
  view.weights = weights_of(curve->weights, curve->degree);
  return view;
}

CurveView<double> bernstein_curve_of(const bb_curve* curve) {
  const auto view = curve_of(curve);
  require(view.form == Form::bernstein, BB_ERROR_FORM);
  return view;
}

bb_form form_of(Form form) {
  switch (form) {
    case Form::power: return BB_POWER;
    case Form::rational: return BB_RATIONAL;
    default: return BB_BERNSTEIN;
  }
}

}  // namespace bezierbench::c
