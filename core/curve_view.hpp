// SPDX-License-Identifier: MIT
// A curve for the harness and the reference: form, degree and a view of its coefficients.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace bezierbench {

/// Representation of a curve. Curves are given in the first three; the others exist inside converted paths.
enum class Form {
  bernstein,            ///< sum b_i B_i,n(t)
  power,                ///< sum q_j t^j
  rational,             ///< sum w_i b_i B_i,n(t) / sum w_i B_i,n(t): a rational Bezier curve
  power_centered,       ///< sum q_j (t - 1/2)^j
  power_double_double,  ///< sum (high q_j + low q_j) t^j, each coefficient an unevaluated sum of two
};

/// True for the forms in which a curve can be given.
constexpr bool is_given(Form form) { return form == Form::bernstein || form == Form::power || form == Form::rational; }

/// The word for a form in files and messages.
constexpr std::string_view name(Form form) {
  switch (form) {
    case Form::bernstein: return "bernstein";
    case Form::power: return "power";
    case Form::rational: return "rational";
    case Form::power_centered: return "power_centered";
    case Form::power_double_double: return "power_double_double";
  }
  return "";
}

/// Largest degree that any curve can have: C(n, n/2) must stay finite in double (it does through n = 1029).
inline constexpr int max_degree = 1023;

/// A curve behind the erased interfaces: coefficients point by point (x0 y0 x1 y1 ...), not owned.
template <class Scalar>
struct CurveView {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::span<const Scalar> coefficients;  ///< (degree + 1) * dimension values; control points are not premultiplied
  std::span<const Scalar> weights = {};  ///< degree + 1 values for a rational curve, else empty

  [[nodiscard]] Scalar operator()(int axis, int i) const {
    return coefficients[static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension) +
                        static_cast<std::size_t>(axis)];
  }
};

}  // namespace bezierbench
