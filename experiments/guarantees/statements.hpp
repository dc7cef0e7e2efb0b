// SPDX-License-Identifier: MIT
// What each property states, and all statements behind function pointers.
#pragma once

#include <array>
#include <functional>

#include "core/error_free.hpp"
#include "core/powers.hpp"
#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/convex_hull.hpp"
#include "experiments/guarantees/excess.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
bool in_unit_interval(Scalar t) {
  return t >= 0 && t <= 1;
}

/// t, or the nearer end of [0,1].
template <class Scalar>
Scalar into_unit_interval(Scalar t) {
  return t < 0 ? Scalar(0) : t > 1 ? Scalar(1) : t;
}

/// Whether 1-t is a number.
template <class Scalar>
bool has_exact_complement(Scalar t) {
  return two_sum(Scalar(1), -t).error == 0;
}

/// ends_exact: p(0) = b_0 and p(1) = b_n for all finite control points, subnormal ones included, as values: -0 equals 0.
/// Where an operation overflows, so that the result is not finite, the statement does not apply; see Finite.
template <class Scalar>
struct EndsExact {
  static constexpr Property property = Property::ends_exact;

  /// At the end that t is nearer to.
  static void fit(Case<Scalar>& input) { input.t = input.t + input.t <= 1 ? Scalar(0) : Scalar(1); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (input.t != 0 && input.t != 1) return std::nullopt;
    Values<Scalar> end{};
    for (int axis = 0; axis < input.dimension; ++axis)
      end[static_cast<std::size_t>(axis)] = input(axis, input.t == 0 ? 0 : input.degree());
    return difference(method.point(input.coefficients, input.t), end);
  }
};

/// constant_reproduced: where all b_i are the same point c, p(t) = c for t in [0,1], for every finite c, subnormal ones
/// included, wherever the result is finite.
template <class Scalar>
struct ConstantReproduced {
  static constexpr Property property = Property::constant_reproduced;

  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    for (int i = 1; i <= input.degree(); ++i)
      for (int axis = 0; axis < input.dimension; ++axis) input(axis, i) = input(axis, 0);
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    Values<Scalar> constant{};
    for (int axis = 0; axis < input.dimension; ++axis) constant[static_cast<std::size_t>(axis)] = input(axis, 0);
    return difference(method.point(input.coefficients, input.t), constant);
  }
};

/// in_hull: min_i b_i <= p(t) <= max_i b_i on every axis for t in [0,1] and all finite control points, subnormal ones
/// included, wherever the result is finite.
template <class Scalar>
struct InHull {
  static constexpr Property property = Property::in_hull;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return std::nullopt;
    double largest = -infinite;
    for (int axis = 0; axis < input.dimension; ++axis) {
      Scalar low = input(axis, 0);
      Scalar high = low;
      for (int i = 1; i <= input.degree(); ++i) {
        low = std::min(low, input(axis, i));
        high = std::max(high, input(axis, i));
      }
      const Scalar value = point[static_cast<std::size_t>(axis)];
      largest = std::max({largest, ulps_above(value, high), ulps_above(low, value)});
    }
    return largest;
  }
};

/// in_convex_hull: in the plane, p(t) lies in the convex hull of the control points for t in [0,1], wherever it is
/// finite. Decided exactly. Rounding a point of a segment to numbers moves it off the segment, so that no method keeps
/// this; what a search finds is the distance outside, in ulp of the largest coordinate.
template <class Scalar>
struct InConvexHull {
  static constexpr Property property = Property::in_convex_hull;
  static constexpr bool in_the_plane = true;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return std::nullopt;
    Scalar largest = 0;
    std::vector<PlanePoint> controls;
    for (int i = 0; i <= input.degree(); ++i) {
      controls.push_back({static_cast<double>(input(0, i)), static_cast<double>(input(1, i))});
      largest = std::max({largest, std::abs(input(0, i)), std::abs(input(1, i))});
    }
    return distance_outside({static_cast<double>(point[0]), static_cast<double>(point[1])}, controls) / ulp(largest);
  }
};

/// monotone: b_0 <= ... <= b_n gives p(t) <= p(t') for all t < t' in [0,1], neighbouring numbers included, and
/// b_0 >= ... >= b_n gives p(t) >= p(t'); for all finite control points, subnormal ones included, wherever both values
/// are finite. A constant sequence is both, so that a method that does not reproduce constants is not monotone.
template <class Scalar>
struct Monotone {
  static constexpr Property property = Property::monotone;
  static constexpr bool uses_t_next = true;

  /// Sorts every axis, in the order of its two ends, and takes the next number for a t' that is not above t.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    if (input.t == 1) input.t = std::nextafter(Scalar(1), Scalar(0));
    if (!(input.t_next > input.t && input.t_next <= 1)) input.t_next = std::nextafter(input.t, Scalar(1));
    std::vector<Scalar> sequence(static_cast<std::size_t>(input.degree()) + 1);
    for (int axis = 0; axis < input.dimension; ++axis) {
      for (std::size_t i = 0; i < sequence.size(); ++i) sequence[i] = input(axis, static_cast<int>(i));
      if (sequence.front() <= sequence.back())
        std::ranges::sort(sequence);
      else
        std::ranges::sort(sequence, std::greater());
      for (std::size_t i = 0; i < sequence.size(); ++i) input(axis, static_cast<int>(i)) = sequence[i];
    }
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto [at, next] = method.points(input.coefficients, std::array{input.t, input.t_next});
    if (!all_finite(at) || !all_finite(next)) return std::nullopt;
    double largest = -infinite;
    for (int axis = 0; axis < input.dimension; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double fall = ulps_above(at[a], next[a]);
      const Scalar first = input(axis, 0);
      const Scalar last = input(axis, input.degree());
      if (first <= last) largest = std::max(largest, fall);
      if (first >= last) largest = std::max(largest, -fall);
    }
    return largest;
  }
};

/// reversal: the points b_n, ..., b_0 at 1-t give the same values as b_0, ..., b_n at t, for t in [0,1] whose 1-t is
/// exact, and all finite control points, subnormal ones included, wherever both values are finite; -0 equals 0.
template <class Scalar>
struct Reversal {
  static constexpr Property property = Property::reversal;

  /// 1 - fl(1-t) has an exact complement: it is t for t >= 1/2, else within u of it.
  static void fit(Case<Scalar>& input) { input.t = 1 - (1 - into_unit_interval(input.t)); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (!has_exact_complement(input.t)) return std::nullopt;
    auto backwards = input;
    const int n = input.degree();
    for (int i = 0; i <= n; ++i)
      for (int axis = 0; axis < input.dimension; ++axis) backwards(axis, i) = input(axis, n - i);
    return difference(method.point(input.coefficients, input.t), method.point(backwards.coefficients, 1 - input.t));
  }
};

/// translation: for c such that all b_i + c are exact, the points b_i + c give p(t) + c, rounded once, for t in [0,1],
/// wherever these values are finite. c is added on the first axis. As p(t) itself is rounded, even correct rounding does
/// not keep this; what a search finds is the largest difference.
template <class Scalar>
struct Translation {
  static constexpr Property property = Property::translation;
  static constexpr bool uses_offset = true;

  /// Takes from each b_i what is lost when c is added; for two in three inputs all sums are exact then.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    for (int i = 0; i <= input.degree(); ++i) {
      const Scalar kept = (input(0, i) + input.offset) - input.offset;
      if (std::isfinite(kept)) input(0, i) = kept;
    }
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    auto moved = input;
    for (int i = 0; i <= input.degree(); ++i) {
      const auto sum = two_sum(input(0, i), input.offset);
      if (!(sum.error == 0) || !std::isfinite(sum.value)) return std::nullopt;
      moved(0, i) = sum.value;
    }
    auto expected = method.point(input.coefficients, input.t);
    expected[0] += input.offset;
    return difference(method.point(moved.coefficients, input.t), expected);
  }
};

/// scaling_by_two: the points 2 b_i give 2 p(t) for t in [0,1], where nothing over- or underflows. This refers to the
/// input alone: 4^(n+1) max |b_i| is in range, and there are powers of two beta and tau, at most 1, of which all b_i and t
/// are multiples and for which beta tau^n is a number, subnormal or not. Then every product b_i t^j (1-t)^(n-j) is a
/// multiple of the smallest subnormal.
template <class Scalar>
struct ScalingByTwo {
  static constexpr Property property = Property::scaling_by_two;

  /// Takes those bits from t that would leave the range.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    const int bits = (lattice_of(input.coefficients) - smallest) / input.degree();
    if (bits < 0 || lattice_exponent(input.t) >= -bits) return;
    input.t = std::ldexp(std::floor(std::ldexp(input.t, bits)), -bits);
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const int n = input.degree();
    if (lattice_of(input.coefficients) + n * lattice_exponent(input.t) < smallest) return std::nullopt;
    auto twice = input;
    for (Scalar& value : twice.coefficients) {
      if (binary_exponent(value) + 2 * n + 2 > std::numeric_limits<Scalar>::max_exponent) return std::nullopt;
      value *= 2;
    }
    auto expected = method.point(input.coefficients, input.t);
    for (Scalar& value : expected) value *= 2;
    return difference(method.point(twice.coefficients, input.t), expected);
  }

 private:
  static constexpr int smallest = std::numeric_limits<Scalar>::min_exponent - std::numeric_limits<Scalar>::digits;

  /// The exponent of the largest power of two up to 1 of which x is a multiple.
  static int lattice_exponent(Scalar x) { return x == 0 ? 0 : std::min(0, lowest_bit(static_cast<double>(x))); }
  static int lattice_of(const std::vector<Scalar>& values) {
    int least = 0;
    for (const Scalar value : values) least = std::min(least, lattice_exponent(value));
    return least;
  }
};

/// axes_independent: a coordinate of p(t) is the same whatever the other axes of the control points are, for t in [0,1]
/// and all finite control points, subnormal ones included; also whether it is finite. It is compared with what results
/// where the other axes are 0.
template <class Scalar>
struct AxesIndependent {
  static constexpr Property property = Property::axes_independent;
  static constexpr int least_dimension = 2;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    double largest = 0;
    for (int axis = 0; axis < input.dimension; ++axis) {
      auto alone = input;
      for (int i = 0; i <= input.degree(); ++i)
        for (int other = 0; other < input.dimension; ++other)
          if (other != axis) alone(other, i) = 0;
      const Scalar with = point[static_cast<std::size_t>(axis)];
      const Scalar without = method.point(alone.coefficients, input.t)[static_cast<std::size_t>(axis)];
      if (std::isfinite(with) && std::isfinite(without))
        largest = std::max(largest, std::abs(ulps_above(with, without)));
      else if (!(with == without || (std::isnan(with) && std::isnan(without))))
        largest = infinite;
    }
    return largest;
  }
};

/// finite: p(t) is finite for t in [0,1] and all finite control points, the largest included. The other statements are
/// about values that are finite, so that overflow counts here alone.
template <class Scalar>
struct Finite {
  static constexpr Property property = Property::finite;

  static void fit(Case<Scalar>& input) { input.t = into_unit_interval(input.t); }

  /// Minus the share of the range that is left above the largest coordinate.
  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const auto point = method.point(input.coefficients, input.t);
    if (!all_finite(point)) return infinite;
    Scalar largest = 0;
    for (const Scalar value : point) largest = std::max(largest, std::abs(value));
    return static_cast<double>(largest) / static_cast<double>(std::numeric_limits<Scalar>::max()) - 1;
  }
};

/// total: p(t) is finite for every finite t outside [0,1] and all control points with (4 (1 + |t|))^n max(1, |b_i|) at
/// most 1/4 of the range, which is decided by the exponents of the factors.
template <class Scalar>
struct Total {
  static constexpr Property property = Property::total;

  /// From [0,1] to the left, or from (1/2,1] to the right.
  static void fit(Case<Scalar>& input) {
    if (!in_unit_interval(input.t)) return;
    if (input.t + input.t > 1)
      input.t = 1 + input.t;
    else
      input.t = input.t == 0 ? Scalar(-1) : -input.t;
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    if (in_unit_interval(input.t) || !in_range(input)) return std::nullopt;
    if (!all_finite(method.point(input.coefficients, input.t))) return infinite;
    return 0;
  }

 private:
  static bool in_range(const Case<Scalar>& input) {
    int of_points = 0;
    for (const Scalar value : input.coefficients) of_points = std::max(of_points, binary_exponent(value));
    const int of_factor = std::max(binary_exponent(input.t), 0) + 3;  // 4 (1 + |t|) < 2^of_factor
    return of_points + 2 + input.degree() * of_factor <= std::numeric_limits<Scalar>::max_exponent;
  }
};

template <class Scalar>
struct Statement {
  Property property;
  int least_dimension = 1;
  int largest_dimension = most_axes;
  bool uses_t_next = false;
  bool uses_offset = false;
  /// Changes an input into one that the statement is about, if need be; twice is the same as once.
  void (*fit)(Case<Scalar>& input) = nullptr;
  Excess (*excess)(Evaluation<Scalar>& method, const Case<Scalar>& input) = nullptr;

  /// So many axes of an input decide; the others stay 0.
  [[nodiscard]] int axes(int dimension) const { return least_dimension > 1 ? dimension : 1; }
  [[nodiscard]] bool concerns(int dimension) const {
    return dimension >= least_dimension && dimension <= largest_dimension;
  }
};

template <class Scalar, template <class> class Defined>
constexpr Statement<Scalar> statement() {
  using Definition = Defined<Scalar>;
  Statement<Scalar> made{.property = Definition::property, .fit = Definition::fit, .excess = Definition::excess};
  if constexpr (requires { Definition::least_dimension; }) made.least_dimension = Definition::least_dimension;
  if constexpr (requires { Definition::in_the_plane; }) made.least_dimension = made.largest_dimension = 2;
  if constexpr (requires { Definition::uses_t_next; }) made.uses_t_next = true;
  if constexpr (requires { Definition::uses_offset; }) made.uses_offset = true;
  return made;
}

/// In the order of `properties`.
template <class Scalar>
inline constexpr std::array statements{statement<Scalar, EndsExact>(),
                                       statement<Scalar, ConstantReproduced>(),
                                       statement<Scalar, InHull>(),
                                       statement<Scalar, InConvexHull>(),
                                       statement<Scalar, Monotone>(),
                                       statement<Scalar, Reversal>(),
                                       statement<Scalar, Translation>(),
                                       statement<Scalar, ScalingByTwo>(),
                                       statement<Scalar, AxesIndependent>(),
                                       statement<Scalar, Finite>(),
                                       statement<Scalar, Total>()};
static_assert(statements<double>.size() == properties.size());

}  // namespace bezierbench::guarantees
