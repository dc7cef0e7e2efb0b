// SPDX-License-Identifier: MIT
#include "bindings/c/curve.hpp"

namespace bezierbench::c {
namespace {

Form form_at(int form) {
  switch (form) {
    case BB_BERNSTEIN: return Form::bernstein;
    case BB_POWER: return Form::power;
    case BB_RATIONAL: return Form::rational;
    default: throw Refused{BB_ERROR_FORM};
  }
}

}  // namespace

CurveView<double> curve_of(const bb_curve* curve) {
  require_pointers(curve);
  const Form form = form_at(curve->form);
  auto view = bezier_curve(curve->dimension, curve->degree, curve->points);
  view.form = form;
  if (form != Form::rational) return view;
  view.weights = finite_values(curve->weights, static_cast<std::size_t>(curve->degree) + 1);
  require(std::ranges::any_of(view.weights, [](double weight) { return weight != 0; }), BB_ERROR_NO_POINT);
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
