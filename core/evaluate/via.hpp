// SPDX-License-Identifier: MIT
// A converted path is composition: prepare = convert, then the evaluator's prepare; evaluate = the evaluator's.
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "core/bound/amplification.hpp"
#include "core/convert/conversion.hpp"
#include "core/evaluate/joined.hpp"

namespace bezierbench {

/// `Converter` followed by `Method`; exists where the forms meet.
template <Conversion Converter, Evaluator Method>
requires(Converter::target == Method::info.form) struct Via {
  using First = Converter;
  using Second = Method;

  /// With |converted| <= (1 + factor u) times its amplification, errors compose as gamma_j + gamma_k + gamma_j gamma_k
  /// ([Higham 2002], Lemma 3.3); the amplification of the conversion is at least that of the evaluation. The
  /// evaluator approximates the converted curve, whose distance from the given curve is the error of the conversion;
  /// the roundings of the result apply to this error too.
  static constexpr double bound_factor(int n, double u) {
    const double conversion = Converter::info.bound->factor(n, u);
    const double evaluation = Method::info.bound->factor(n, u);
    return conversion + evaluation + conversion * u * (evaluation + Method::info.bound->result_roundings);
  }
  static constexpr double bound_underflow(int n) {
    const double size = Method::info.bound->underflow_scales_with_coefficients ? Converter::coefficient_growth(n) : 1;
    return Converter::info.bound->underflow(n) + Method::info.bound->underflow(n) * size;
  }
  static constexpr double bound_growth(int n) {
    return std::max(Converter::info.bound->growth(n), Method::info.bound->growth(n) * Converter::coefficient_growth(n));
  }
  /// The method's own bound must multiply p~ of the converted curve, since only that is at most what the conversion's
  /// multiplies, and it must be the only one: a local curve of a method with `of_local` has another.
  static constexpr bool has_bound() {
    // By its name: with sanitizers GCC 12 does not compare an address with nullptr in a constant expression.
    if constexpr (Converter::info.bound && Method::info.bound && !requires { Method::of_local; })
      return Method::info.bound->amplification == p_tilde_of(Method::info.form);
    else
      return false;
  }
  /// The largest degree up to this one at which results stay in range for coordinates of 1 before the conversion, so
  /// that the evaluator's growth comes on top of its own.
  template <class Scalar>
  static constexpr int degree_in_range(int degree) {
    if constexpr (has_bound()) {
      constexpr double u = std::numeric_limits<Scalar>::epsilon() / 2;
      constexpr double most = std::numeric_limits<Scalar>::max();
      // The product may overflow, which a constant expression does not allow.
      const auto is_beyond = [](int n) {
        return Method::info.bound->growth(n) > most / Converter::coefficient_growth(n);
      };
      while (is_beyond(degree) || !stays_in_range(bound_growth(degree), degree, u)) --degree;
    }
    return degree;
  }
  static constexpr ErrorBound bound_of_coefficients() {
    return {.text = detail::Joined<detail::Literal<"conversion ">, detail::BoundOf<Converter>,
                                   detail::Literal<"; evaluation ">, detail::BoundOf<Method>>::text,
            .amplification = Converter::info.bound->amplification,
            .factor = bound_factor,
            .underflow = bound_underflow,
            .underflow_scales_with_coefficients = true,
            .growth = bound_growth,
            .unit_interval_only = Converter::info.bound->unit_interval_only || Method::info.bound->unit_interval_only,
            .result_roundings = Method::info.bound->result_roundings};
  }
  /// Whether the path has a second bound, from_start: its coefficients are differences of control points, except b_0,
  /// which is added last, so that only distances from b_0 are multiplied.
  static constexpr bool counts_from_start() {
    if constexpr (requires { requires Converter::of_differences; })
      return has_bound() && Method::info.bound->constant_roundings > 0;
    else
      return false;
  }
  static constexpr double factor_from_start(int n, double u) {
    const double conversion = Converter::info.bound->factor(n, u);
    const double evaluation = Method::info.bound->factor(n, u);
    return conversion + evaluation + conversion * u * (evaluation + Method::info.bound->constant_roundings);
  }
  static constexpr ErrorBound bound_from_start() {
    auto result = bound_of_coefficients();
    result.amplification = Amplification::spread_to_power_from_start;
    result.factor = factor_from_start;
    result.result_roundings = Method::info.bound->constant_roundings;
    return result;
  }
  static constexpr ErrorBound from_start = bound_from_start();
  static constexpr std::optional<ErrorBound> bound() {
    if constexpr (has_bound()) {
      auto result = bound_of_coefficients();
      if constexpr (counts_from_start()) result.also = &from_start;
      return result;
    } else {
      return std::nullopt;
    }
  }

  static constexpr MethodInfo info{
      .id = detail::Joined<detail::IdOf<Converter>, detail::Literal<":">, detail::IdOf<Method>>::text,
      .label = detail::Joined<detail::LabelOf<Converter>, detail::Literal<" > ">, detail::LabelOf<Method>>::text,
      .form = Converter::info.form,
      .min_degree = std::max(Converter::info.min_degree, Method::info.min_degree),
      .max_degree = degree_in_range<double>(std::min(Converter::info.max_degree, Method::info.max_degree)),
      .max_degree_float =
          degree_in_range<float>(std::min(Converter::info.max_degree_float, Method::info.max_degree_float)),
      .unit_interval_only = Method::info.unit_interval_only,
      .bound = bound(),
      .bit_stable = Converter::info.bit_stable && Method::info.bit_stable,
      .fused = Method::info.fused,
      .one_minus_t = Method::info.one_minus_t,
      .flops = Method::info.flops,
      .cost_exponent = Method::info.cost_exponent,
      .prepare_exponent = std::max(Converter::info.cost_exponent, Method::info.prepare_exponent),
      .citation =
          detail::Joined<detail::CitationOf<Converter>, detail::Literal<"; ">, detail::CitationOf<Method>>::text};

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<info.form, Scalar, Dimension, Degree>& curve) {
    if constexpr (PreparesNothing<Method>)
      return Converter::convert(curve);
    else
      return Method::prepare(Converter::convert(curve));
  }

  template <class Prepared, class Scalar>
  static auto evaluate(const Prepared& prepared, Scalar t) {
    return Method::evaluate(prepared, t);
  }
};

namespace detail {

/// A list of one type or of none.
template <bool Kept, class T>
using OneIf = std::conditional_t<Kept, TypeList<T>, TypeList<>>;

/// The path, where the forms meet.
template <class C, class E>
struct PathIfAny {
  using Type = TypeList<>;
};
template <class C, class E>
requires(C::target == E::info.form) struct PathIfAny<C, E> {
  using Type = TypeList<Via<C, E>>;
};

}  // namespace detail

/// Every evaluator that takes curves as they are given, then every conversion in front of every evaluator of its target
/// form.
template <class ConversionList, class EvaluatorList>
struct PathsOf;

template <class... Cs, class... Es>
struct PathsOf<TypeList<Cs...>, TypeList<Es...>> {
  template <class C>
  using From = typename Concatenated<typename detail::PathIfAny<C, Es>::Type...>::Type;
  using Type = typename Concatenated<detail::OneIf<is_given(Es::info.form), Es>..., From<Cs>...>::Type;
};

/// The conversions whose result is a curve as it can be given.
template <class ConversionList>
struct GivenTargets;

template <class... Cs>
struct GivenTargets<TypeList<Cs...>> {
  using Type = typename Concatenated<detail::OneIf<is_given(Cs::target), Cs>...>::Type;
};

}  // namespace bezierbench
