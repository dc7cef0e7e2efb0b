// SPDX-License-Identifier: MIT
// Studies of kind `bounds`: boxes of random curves; every side is judged against the extrema of the curve, exactly.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "experiments/judge/input_fields.hpp"
#include "experiments/studies/bounds/problem.hpp"
#include "experiments/studies/trial/companion_kind.hpp"

namespace bezierbench::studies {
namespace {

/// The number of a double among all of them, ascending; that of both zeros is 0.
std::int64_t place(double x) {
  const auto magnitude = std::bit_cast<std::int64_t>(std::abs(x));
  return x < 0 ? -magnitude : magnitude;
}

/// How many doubles `to` is above `from`; rounded where the zero is between them.
double doubles_from(double from, double to) {
  const auto first = place(from);
  const auto last = place(to);
  return (first < 0) == (last < 0) ? static_cast<double>(last - first)
                                   : static_cast<double>(last) - static_cast<double>(first);
}

/// Calls use(error) for both sides of every axis.
template <class Use>
void each_side(const BoundsProblem::Drawn& drawn, const BoundsProblem::Answer& box, Use use) {
  for (std::size_t axis = 0; axis < drawn.truth.size(); ++axis) {
    use(side_error(box[2 * axis], drawn.truth[axis].low));
    use(side_error(-box[2 * axis + 1], -drawn.truth[axis].high));
  }
}

bool has_numbers(const BoundsProblem::Answer& box) {
  return std::ranges::none_of(box, [](double side) { return std::isnan(side); });
}

}  // namespace

SideError side_error(double computed, double tightest) {
  if (std::isinf(computed)) return {-computed, -computed};
  return {doubles_from(computed, tightest), tightest - computed};
}

void BoundsProblem::draw(std::uint64_t number, Drawn& drawn) const {
  curves_.draw(number, drawn);
  find_truth(drawn);
}

void BoundsProblem::find_truth(Drawn& drawn) {
  drawn.truth.clear();
  drawn.size = 0;
  for (int axis = 0; axis < drawn.curve.dimension; ++axis) {
    const auto range = drawn.truth.emplace_back(reference::exact_range(drawn.curve, axis));
    drawn.size = std::max(drawn.size, range.high - range.low);
  }
}

void BoundsProblem::ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& box) {
  box.resize(2 * static_cast<std::size_t>(drawn.curve.dimension));
  method.box(drawn.curve, box.data());
}

void BoundsProblem::judge(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& box,
                          std::uint64_t number, Errors& errors) {
  if (!has_numbers(box)) {
    ++errors.non_finite;
    if (method.promises->contains) errors.violations.add(number);
    return;
  }
  double inside = 0;
  bool loose = false;
  each_side(drawn, box, [&](const SideError& error) {
    const double over_size = error.distance == 0 ? 0 : std::abs(error.distance) / drawn.size;
    if (error.ulp < 0) {
      inside = std::max(inside, -error.distance);
      errors.inside_ulp.add(-error.ulp);
      errors.inside_size.add(over_size);
      return;
    }
    metric::add_rounded(error.ulp, errors.excess_ulp);
    metric::add_rounded(over_size, errors.excess_size);
    loose = loose || error.ulp > 1;
  });
  if (loose && method.promises->within_one_ulp) errors.loose.add(number);
  if (inside == 0) return;
  errors.too_small.add(number);
  if (method.promises->contains) errors.violations.add(number);
  if (!errors.smallest.yields_to(inside, number)) return;
  const auto fields = judge::input_fields(drawn.trial, drawn.curve.dimension);
  errors.smallest = {inside, number, fields[1], fields[2]};
}

bool BoundsProblem::is_right(const Kernel& method, const Drawn& drawn, double /*tolerance*/, const Answer& box) {
  if (!has_numbers(box)) return false;
  constexpr double half_of_the_digits = 0x1p-26;
  bool right = true;
  each_side(drawn, box, [&](const SideError& error) {
    const double allowed = method.promises->contains ? 0 : half_of_the_digits * drawn.size;
    right = right && error.distance >= -allowed && (!method.promises->within_one_ulp || error.ulp <= 1);
  });
  return right;
}

extern constexpr StudyKind bounds_kind =
    companion_kind<BoundsProblem>({.id = "bounds",
                                   .about = "boxes of curves, and points of curves outside",
                                   .own = {},
                                   .methods_example = "[\"exact_box\"]",
                                   .inputs = {.forms = suite::forms_with_control_points,
                                              .forms_reason = "boxes are judged for curves with control points",
                                              .double_only = true,
                                              .parameters = suite::Parameters::whole,
                                              .parameters_reason = "boxes are of whole curves"}});

}  // namespace bezierbench::studies
