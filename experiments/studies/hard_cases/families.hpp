// SPDX-License-Identifier: MIT
// Families of curves and t at which rounding once is hard: ties, numbers beside them, cancellation, underflow,
// overflow. Studies of kind `hard_cases` draw from them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "core/curve_view.hpp"
#include "experiments/sample/words.hpp"

namespace bezierbench::studies::hard {

/// Random numbers, made of a stream of random words.
template <class Scalar>
class Draw {
 public:
  using Limits = std::numeric_limits<Scalar>;
  explicit Draw(const sample::Words& words) : words_(words) {}

  std::uint64_t below(std::uint64_t count) { return words_.next() % count; }
  int between(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::uint64_t>(last - first) + 1));
  }
  Scalar sign() { return below(2) == 0 ? Scalar(-1) : Scalar(1); }
  Scalar unit() { return static_cast<Scalar>(std::ldexp(static_cast<double>(words_.next() >> 11U), -53)); }
  Scalar symmetric() { return 2 * unit() - 1; }
  /// An integer that takes all bits of a significand.
  Scalar long_integer() { return std::ldexp(1 + unit(), Limits::digits - 1); }
  /// A power of two so small that a pair of numbers near 1 cannot hold it beside them.
  Scalar tiny() { return sign() * std::ldexp(Scalar(1), -between(Limits::digits, smallest_exponent)); }

  static constexpr int smallest_exponent = Limits::digits - Limits::min_exponent;  // of the smallest subnormal, negated

 private:
  sample::Words words_;
};

template <class Scalar>
struct HardCase {
  std::vector<Scalar> coefficients;
  Scalar t;
};

/// Integers with all bits of a significand, at a t of two bits: the exact value has few bits more than the result.
template <class Scalar>
HardCase<Scalar> tie(Draw<Scalar>& draw, Form form) {
  HardCase<Scalar> drawn{{}, static_cast<Scalar>(draw.between(1, 3)) / 4};
  const int degree = draw.between(1, 3);
  for (int i = 0; i <= degree; ++i)
    drawn.coefficients.push_back(form == Form::power && i > 0 ? static_cast<Scalar>(draw.between(-8, 8))
                                                              : draw.long_integer());
  return drawn;
}

/// The same with one tiny coefficient: the exact value lies close to a tie, or to a number.
template <class Scalar>
HardCase<Scalar> beside_a_tie(Draw<Scalar>& draw, Form form) {
  auto drawn = tie(draw, form);
  if (form == Form::power)
    drawn.coefficients.push_back(draw.tiny());
  else
    drawn.coefficients[draw.below(drawn.coefficients.size())] = draw.tiny();
  return drawn;
}

/// (2t - 1)^n at and around its only root. Its coefficients are integers in both forms. The magnitudes of its terms sum
/// to 1 on [0,1], in power form to (2t + 1)^n.
template <class Scalar>
HardCase<Scalar> root(Draw<Scalar>& draw, Form form) {
  const int degree = draw.between(1, 12);
  HardCase<Scalar> drawn{{}, Scalar(0.5)};
  Scalar binomial = 1;
  for (int i = 0; i <= degree; ++i) {
    const Scalar sign = (degree - i) % 2 == 0 ? Scalar(1) : Scalar(-1);
    drawn.coefficients.push_back(form == Form::power ? sign * std::ldexp(binomial, i) : sign);
    binomial = binomial * static_cast<Scalar>(degree - i) / static_cast<Scalar>(i + 1);
  }
  if (draw.below(8) != 0)
    drawn.t += std::ldexp(draw.symmetric(), -draw.between(2, std::numeric_limits<Scalar>::digits));
  return drawn;
}

/// Control points with b_(n-i) = -b_i, so that the terms cancel in pairs at t = 1/2. As power coefficients they cancel
/// in pairs at t = 1.
template <class Scalar>
HardCase<Scalar> cancellation(Draw<Scalar>& draw, Form form) {
  const int half = draw.between(1, 12);
  HardCase<Scalar> drawn{{}, form == Form::power ? Scalar(1) : Scalar(0.5)};
  for (int i = 0; i < half; ++i) drawn.coefficients.push_back(draw.symmetric());
  for (int i = half - 1; i >= 0; --i) drawn.coefficients.push_back(-drawn.coefficients[static_cast<std::size_t>(i)]);
  if (draw.below(2) == 0) drawn.coefficients[draw.below(drawn.coefficients.size())] += draw.tiny();
  if (draw.below(2) == 0) drawn.t -= std::ldexp(draw.unit(), -draw.between(10, 60));
  return drawn;
}

template <class Scalar, class Of>
HardCase<Scalar> case_of_values(Draw<Scalar>& draw, const Of& of) {
  HardCase<Scalar> drawn;
  const int degree = draw.between(0, 20);
  for (int i = 0; i <= degree; ++i) drawn.coefficients.push_back(of());
  drawn.t = draw.unit();
  return drawn;
}

template <class Scalar>
HardCase<Scalar> subnormal_curve(Draw<Scalar>& draw, Form /*form*/) {
  return case_of_values(draw, [&] {
    return std::ldexp(draw.symmetric(), std::numeric_limits<Scalar>::min_exponent - draw.between(0, 40));
  });
}

/// Coefficients and t with exponents that are equally likely over the whole range of the format.
template <class Scalar>
HardCase<Scalar> every_magnitude(Draw<Scalar>& draw, Form /*form*/) {
  using D = Draw<Scalar>;
  auto drawn = case_of_values(draw, [&] {
    return std::ldexp(draw.symmetric(), draw.between(-D::smallest_exponent, std::numeric_limits<Scalar>::max_exponent));
  });
  if (draw.below(2) == 0) drawn.t = std::ldexp(draw.unit(), -draw.between(0, D::smallest_exponent));
  return drawn;
}

/// t that is subnormal, next to 0 or next to 1.
template <class Scalar>
HardCase<Scalar> next_to_an_end(Draw<Scalar>& draw, Form /*form*/) {
  using Limits = std::numeric_limits<Scalar>;
  auto drawn = case_of_values(draw, [&] { return draw.symmetric(); });
  switch (draw.below(4)) {
    case 0: drawn.t = Limits::denorm_min() * static_cast<Scalar>(draw.between(0, 9)); break;
    case 1: drawn.t = std::ldexp(draw.unit(), -draw.between(0, Draw<Scalar>::smallest_exponent)); break;
    case 2: drawn.t = 1 - static_cast<Scalar>(draw.between(0, 9)) * Limits::epsilon() / 2; break;
    default: drawn.t = 1 - std::ldexp(draw.unit(), -draw.between(0, Limits::digits)); break;
  }
  if (draw.below(2) == 0) drawn.coefficients[draw.below(2) == 0 ? 0 : drawn.coefficients.size() - 1] = draw.tiny();
  return drawn;
}

/// Coefficients up to the largest number. In power form the result may be that number, or infinite.
template <class Scalar>
HardCase<Scalar> next_to_the_largest(Draw<Scalar>& draw, Form /*form*/) {
  constexpr Scalar largest = std::numeric_limits<Scalar>::max();
  auto drawn = case_of_values(draw, [&]() -> Scalar {
    switch (draw.below(3)) {
      case 0: return draw.sign() * largest;
      case 1: return draw.sign() * largest * std::ldexp(Scalar(1), -draw.between(50, 60));
      default: return draw.symmetric() * largest;
    }
  });
  if (draw.below(2) == 0) drawn.t = 1;
  return drawn;
}

/// All control points equal, sometimes at an end of [0,1].
template <class Scalar>
HardCase<Scalar> constant(Draw<Scalar>& draw, Form /*form*/) {
  const Scalar value = draw.below(4) == 0 ? Scalar(0) : draw.symmetric();
  auto drawn = case_of_values(draw, [&] { return value; });
  if (draw.below(3) == 0) drawn.t = static_cast<Scalar>(draw.below(2));
  return drawn;
}

template <class Scalar>
struct Family {
  std::string_view name;
  HardCase<Scalar> (*draw)(Draw<Scalar>& draw, Form form);
};

template <class Scalar>
constexpr std::array<Family<Scalar>, 9> families{{{"exact_ties", tie<Scalar>},
                                                  {"beside_a_tie", beside_a_tie<Scalar>},
                                                  {"root_of_high_order", root<Scalar>},
                                                  {"full_cancellation", cancellation<Scalar>},
                                                  {"subnormal_curves", subnormal_curve<Scalar>},
                                                  {"every_magnitude", every_magnitude<Scalar>},
                                                  {"t_next_to_0_and_1", next_to_an_end<Scalar>},
                                                  {"next_to_the_largest", next_to_the_largest<Scalar>},
                                                  {"constants_and_ends", constant<Scalar>}}};

}  // namespace bezierbench::studies::hard
