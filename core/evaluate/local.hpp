// SPDX-License-Identifier: MIT
// Formula: p = b + d(tau). For t <= 1/2 the end b is b_0 and tau is t; else b is b_n and tau is 1-t. The evaluator
//   evaluates d, whose control points are the differences b_i - b, counted from b. By way of power form only the
//   conversion subtracts: b is the constant coefficient, which the evaluator adds last.
// Source: differences of numbers within a factor of two of each other are exact ([Sterbenz 1974]).
// Bound: u |p| + (1 + u) (1 + f + f u) u sum |b_i - b| B_i(t) for 0 <= t <= 1, with f the factor of the evaluator; by
//   way of power form u |p| + f u sum |b_i - b| C(n,i) tau^i (1 + tau)^(n-i). docs/proofs/local.md has the proofs.
// Keeps: docs/proofs/local.md.
// Fails: where a curve is not small beside its distance from the origin, its differences round like any sum.
#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/joined.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"
#include "core/evaluate/via.hpp"
#include "core/vector/shared.hpp"

namespace bezierbench {

namespace detail {

/// The only curve of a prepared state.
template <class State>
const auto& only_curve(const State& state) {
  if constexpr (requires { state.parts(); })
    return std::get<0>(state.parts());
  else
    return state;
}

/// `Method` at tau on a prepared state of one curve.
template <class Method, Form F, class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> evaluate_curve(const Curve<F, Scalar, Dimension, Degree>& curve, const Scalar& tau) {
  if constexpr (requires { typename Method::template Prepared<Scalar, Dimension, Degree>; })
    return Method::evaluate(typename Method::template Prepared<Scalar, Dimension, Degree>{curve}, tau);
  else
    return Method::evaluate(curve, tau);
}

/// What the range of numbers takes from the degrees of a method that has a limit in float. Differences are up to twice
/// as large as coordinates, and those that were converted from power form up to n + 1 times as large as its
/// coefficients.
template <class Method>
inline constexpr int further_degree = Method::info.max_degree_float < bezierbench::max_degree ? 12 : 0;

/// The data that both kinds of local methods share.
template <class Method, class Flops>
constexpr MethodInfo local_info(const std::optional<ErrorBound>& bound) {
  return {.id = Joined<Literal<"local:">, IdOf<Method>>::text,
          .label = Joined<Literal<"About the nearer end: ">, LabelOf<Method>>::text,
          .form = Form::bernstein,
          .min_degree = Method::info.min_degree,
          .max_degree = Method::info.max_degree - further_degree<Method>,
          .max_degree_float = Method::info.max_degree_float - further_degree<Method>,
          .unit_interval_only = Method::info.unit_interval_only,
          .bound = bound,
          .bit_stable = Method::info.bit_stable,
          .fused = Method::info.fused,
          .one_minus_t = Method::info.one_minus_t,
          .flops = Joined<FlopsOf<Method>, Flops>::text,
          .cost_exponent = Method::info.cost_exponent,
          .prepare_exponent = Method::info.prepare_exponent,
          .citation = Joined<CitationOf<Method>, Literal<", about the nearer end: derived here">>::text};
}

}  // namespace detail

/// `Method` about the nearer end. Its prepared state is one curve.
template <Evaluator Method>
requires(Method::info.form == Form::bernstein) struct Local : FixedDegreesOf<Method> {
  static constexpr double bound_factor(int n, double u) {
    const double factor = Method::info.bound->factor(n, u) + Method::info.bound->result_roundings;
    return (1 + u) * (1 + factor + factor * u);
  }
  static constexpr ErrorBound bound{
      .text = detail::Joined<detail::Literal<"u |p|; about the nearer end, ">, detail::BoundOf<Method>>::text,
      .amplification = Amplification::spread,
      .factor = bound_factor,
      .underflow = Method::info.bound->underflow,
      .underflow_scales_with_coefficients = true,
      .growth = [](int n) { return 2 * Method::info.bound->growth(n) + 1; },
      .unit_interval_only = true,
      .result_roundings = 1};
  static constexpr MethodInfo info = detail::local_info<Method, detail::Literal<" + d + 1">>(bound);
  /// Each lane of a sum chooses between two coefficients.
  static constexpr LaneRegisters lanes =
      info.cost_exponent > 1 ? Method::lanes : LaneRegisters{.per_axis = 1, .shared = 3};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact},     Guarantee{Property::constant_reproduced},
                                         Guarantee{Property::in_hull, 1},     Guarantee{Property::monotone, 1},
                                         Guarantee{Property::scaling_by_two}, Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  /// What the evaluator prepares of the differences from b_0 and, in reverse order, from b_n; and the curve itself, of
  /// which the ends are read.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> from_start;
    Curve<Form::bernstein, Scalar, Dimension, Degree> from_end;
    Curve<Form::bernstein, Scalar, Dimension, Degree> given;

    [[nodiscard]] auto parts() const { return std::tie(from_start, from_end, given); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    const int n = curve.degree();
    const auto differences = [&](bool from_start) {
      auto result = from_start ? curve : reversed(curve);
      Point<Scalar, Dimension> anchor;
      for (int axis = 0; axis < Dimension; ++axis) anchor[axis] = result(axis, 0);
      for (int i = 0; i <= n; ++i)
        for (int axis = 0; axis < Dimension; ++axis) result(axis, i) = result(axis, i) - anchor[axis];
      return result;
    };
    return Prepared<Scalar, Dimension, Degree>{detail::only_curve(Method::prepare(differences(true))),
                                               detail::only_curve(Method::prepare(differences(false))), curve};
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const auto x = parameter_of(t);
    const auto y = std::remove_const_t<decltype(x)>(1) - x;
    const auto near_end = y < x;
    const auto tau = select(near_end, y, x);
    auto p = detail::evaluate_curve<Method>(chosen(near_end, prepared.from_end, prepared.from_start), Scalar(tau));
    const int n = prepared.given.degree();
    for (int axis = 0; axis < Dimension; ++axis)
      p[axis] = select(near_end, prepared.given(axis, n), prepared.given(axis, 0)) + p[axis];
    return p;
  }
};

/// A path to power form about the nearer end.
template <class Converter, class Method>
requires(Via<Converter, Method>::counts_from_start()) struct Local<Via<Converter, Method>> : FixedDegreesOf<Method> {
  using Path = Via<Converter, Method>;

  static constexpr ErrorBound bound() {
    auto local = Path::from_start;
    local.text = detail::Joined<detail::Literal<"u |p|; about the nearer end, ">, detail::BoundOf<Path>>::text;
    local.amplification = Amplification::spread_to_power;
    local.unit_interval_only = true;
    return local;
  }
  static constexpr MethodInfo info = detail::local_info<Path, detail::Literal<" + 1">>(bound());
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 3};

  static constexpr auto kept() {
    constexpr std::array of_all{Guarantee{Property::ends_exact},       Guarantee{Property::constant_reproduced},
                                Guarantee{Property::in_hull, 1},       Guarantee{Property::scaling_by_two},
                                Guarantee{Property::axes_independent}, Guarantee{Property::total}};
    if constexpr (Method::info.bound->constant_roundings > 1) {
      return of_all;
    } else {
      std::array<Guarantee, of_all.size() + 1> all{};
      *std::ranges::copy(of_all, all.begin()).out = {Property::monotone, 1};
      return all;
    }
  }
  static constexpr auto guarantees = kept();

  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::power, Scalar, Dimension, Degree> from_start;
    Curve<Form::power, Scalar, Dimension, Degree> from_end;

    [[nodiscard]] auto parts() const { return std::tie(from_start, from_end); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return Prepared<Scalar, Dimension, Degree>{Converter::convert(curve), Converter::convert(reversed(curve))};
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    return from_nearer_end(prepared.from_start, prepared.from_end, t,
                           [](const auto& curve, const Scalar& tau) { return Method::evaluate(curve, tau); });
  }

  /// What `at` makes of the power coefficients about the nearer end and the parameter from there.
  template <class Scalar, int Dimension, int Degree, class At>
  static auto from_nearer_end(const Curve<Form::power, Scalar, Dimension, Degree>& from_start,
                              const Curve<Form::power, Scalar, Dimension, Degree>& from_end, const Scalar& t,
                              const At& at) {
    const auto x = parameter_of(t);
    const auto y = std::remove_const_t<decltype(x)>(1) - x;
    const auto near_end = y < x;
    return at(chosen(near_end, from_end, from_start), Scalar(select(near_end, y, x)));
  }
};

}  // namespace bezierbench
