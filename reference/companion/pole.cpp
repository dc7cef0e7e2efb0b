// SPDX-License-Identifier: MIT
#include "reference/companion/pole.hpp"

#include <algorithm>
#include <vector>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

std::optional<double> pole(const CurveView<double>& curve, double from, double to) {
  if (curve.form != Form::rational) return std::nullopt;
  if (std::ranges::all_of(curve.weights, [](double w) { return w > 0; })) return std::nullopt;
  if (std::ranges::all_of(curve.weights, [](double w) { return w < 0; })) return std::nullopt;
  std::vector<Rational> weights;
  for (const double w : curve.weights) weights.push_back(exactly(w));
  long exponent = 0;
  const auto denominator = from_bernstein(weights, exponent);
  if (denominator.empty()) return from;
  const auto p = square_free(denominator);
  constexpr unsigned long bits_of_a_double = 1075;  // every double in [0, 1] is an end of such an interval
  for (auto root : isolate_roots(p)) {
    refine(p, root, bits_of_a_double);
    const Rational low{root.t.k, 1, -static_cast<long>(root.t.shift)};
    const Rational high{root.t.k + (root.exact ? 0 : 1), 1, low.exponent};
    if (!less(low, exactly(from)) && !less(exactly(to), high)) return round_to(binary64, low);
  }
  return std::nullopt;
}

}  // namespace bezierbench::reference
