// SPDX-License-Identifier: MIT
// What a method from outside is asked, and what came of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"

namespace bezierbench::outside {

/// Curves of one form, dimension and degree, each with one parameter.
struct Batch {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::vector<double> t;
  std::vector<double> coefficients;  ///< curve by curve, each point by point
  std::vector<double> weights;       ///< curve by curve, of rational curves

  [[nodiscard]] std::size_t count() const { return t.size(); }
  [[nodiscard]] CurveView<double> curve(std::size_t k) const {
    const std::size_t values = static_cast<std::size_t>(degree) + 1;
    const std::size_t each = values * static_cast<std::size_t>(dimension);
    CurveView<double> view{form, dimension, degree, std::span(coefficients).subspan(k * each, each)};
    if (form == Form::rational) view.weights = std::span(weights).subspan(k * values, values);
    return view;
  }
};

/// What came of a batch, in the order of precedence: of several batches the last in this order counts.
enum class Status : std::uint8_t {
  ok,
  non_finite,           ///< no point was finite
  missing,              ///< a file of answers has none for some input
  refused,              ///< the method does not take one of the curves
  leaked,               ///< the memory that it holds grows from curve to curve
  changed_rounding,     ///< it left another floating-point environment behind
  wrote_out_of_bounds,  ///< beyond its results, or into its inputs
  malformed,            ///< its answers cannot be read, or there are too few or too many
  exited,               ///< the process ended by itself before it had answered, or with another code than 0
  threw,                ///< an exception left it
  crashed,              ///< a signal ended the process
  timed_out             ///< it took longer than the limit
};

/// The word for a status in tables.
constexpr std::string_view name(Status status) {
  switch (status) {
    case Status::ok: return "ok";
    case Status::non_finite: return "non_finite";
    case Status::missing: return "missing";
    case Status::refused: return "refused";
    case Status::leaked: return "leaked";
    case Status::changed_rounding: return "changed_rounding";
    case Status::wrote_out_of_bounds: return "wrote_out_of_bounds";
    case Status::malformed: return "malformed";
    case Status::exited: return "exited";
    case Status::threw: return "threw";
    case Status::crashed: return "crashed";
    case Status::timed_out: return "timed_out";
  }
  return "";
}

struct Answer {
  Status status = Status::ok;
  std::vector<double> points;  ///< point by point; of every input where the status is ok
  std::string detail;          ///< for people: what the method said, or how it ended
};

}  // namespace bezierbench::outside
