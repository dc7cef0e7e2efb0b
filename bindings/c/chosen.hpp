// SPDX-License-Identifier: MIT
// The method of an id in the table of a problem.
#pragma once

#include <span>
#include <string_view>

#include "bindings/c/curve.hpp"
#include "core/api/recommended.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/method.hpp"

namespace bezierbench::c {

/// The entry of the table (entries have an `info`) that takes the curve. Throws Refused that says whether the id, the
/// form or the degree is wrong.
template <class Table, class Scalar>
const typename Table::element_type& chosen(const Table& table, const char* id, const CurveView<Scalar>& curve) {
  require_pointers(id);
  const std::string_view wanted = id;
  bb_status reason = BB_ERROR_METHOD;
  for (const auto& entry : table) {
    if (entry.info->id != wanted) continue;
    if (entry.info->form != curve.form) {
      if (reason == BB_ERROR_METHOD) reason = BB_ERROR_FORM;  // another entry of this id may take the form
    } else if (entry.info->template supports<Scalar>(curve.degree)) {
      return entry;
    } else {
      reason = BB_ERROR_DEGREE;
    }
  }
  throw Refused{reason};
}

/// The id of the evaluator that a null id stands for: that of the C++ function evaluate().
template <class Scalar>
const char* recommended_id(Form form, int degree) {
  switch (form) {
    case Form::power: return recommended<Form::power, Scalar>(degree).id.data();
    case Form::rational: return recommended<Form::rational, Scalar>(degree).id.data();
    default: return recommended<Form::bernstein, Scalar>(degree).id.data();
  }
}

/// The evaluator of this id for the curve; the recommended one for a null id. Throws as chosen().
template <class Scalar>
const Kernel<Scalar>& evaluator(const char* id, const CurveView<Scalar>& curve) {
  return chosen(kernels<Scalar>(curve.dimension), id != nullptr ? id : recommended_id<Scalar>(curve.form, curve.degree),
                curve);
}

/// Throws Refused unless the parameters are finite and in the domain of the method.
template <class Scalar>
void require_parameters(const MethodInfo& info, std::span<const Scalar> t) {
  require_finite(t);
  if (!info.unit_interval_only) return;
  bool inside = true;
  for (const Scalar x : t) inside = inside & (x >= 0) & (x <= 1);
  require(inside, BB_ERROR_PARAMETER);
}

/// `count` finite parameters in the domain of the method.
template <class Scalar>
std::span<const Scalar> parameters(const MethodInfo& info, const Scalar* t, std::size_t count) {
  if (count == 0) return {};
  require_pointers(t);
  require_parameters(info, std::span(t, count));
  return {t, count};
}

}  // namespace bezierbench::c
