// SPDX-License-Identifier: MIT
// Formula: on each axis, with k its locality (core/bound/locality.hpp): for nk <= 1 local:differences:horner_fma, for
//   k <= 2 local:differences:horner_corrected, else horner_bernstein_fma. About an end, power form multiplies numbers
//   that are hardly larger than the result.
// Source: the choice is derived here.
// Cost: results/real has the times on curves.
// Bound: that of the method that is chosen. docs/proofs/local.md has the proof.
// Keeps: docs/proofs/local.md.
// Fails: as horner_bernstein_fma, where k > 2. Its differences take O(n^2) to prepare. Where axes are chosen for
//   differently, all that is chosen is evaluated.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "core/bound/locality.hpp"
#include "core/convert/differences.hpp"
#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/local.hpp"
#include "core/evaluate/methods/horner_bernstein_fma.hpp"
#include "core/evaluate/methods/horner_corrected.hpp"
#include "core/evaluate/methods/horner_fma.hpp"

namespace bezierbench {

struct LocalOrBernstein {
  using Plain = Local<Via<Differences, HornerFma>>;
  using Corrected = Local<Via<Differences, HornerCorrected>>;

  /// The larger of those of the two local methods, which differ in their constants.
  static constexpr ErrorBound of_local{
      .text = "u |p|; about the nearer end, by way of power form",
      .amplification = Amplification::spread_to_power,
      .factor = [](int n,
                   double u) { return std::max(Plain::info.bound->factor(n, u), Corrected::info.bound->factor(n, u)); },
      .underflow = Corrected::info.bound->underflow,
      .underflow_scales_with_coefficients = true,
      .growth = Corrected::info.bound->growth,
      .unit_interval_only = true,
      .result_roundings = Corrected::info.bound->result_roundings};
  static constexpr MethodInfo info{
      .id = "local_or_bernstein",
      .label = "About the nearer end, or Horner-Bernstein, fused: by axis",
      .form = Form::bernstein,
      .max_degree = Plain::info.max_degree,
      .max_degree_float = Plain::info.max_degree_float,
      .bound = ErrorBound{.text = "gamma_(2n+2) p~; of local curves u |p| and what their spread adds",
                          .amplification = Amplification::p_tilde_bernstein,
                          .factor = HornerBernsteinFma::info.bound->factor,
                          .underflow = HornerBernsteinFma::info.bound->underflow,
                          .underflow_scales_with_coefficients = true,
                          .growth = HornerBernsteinFma::info.bound->growth,
                          .of_local = &of_local},
      .fused = true,
      .one_minus_t = OneMinusT::summed,
      .flops = "dn + 1 or d(n+6) + 1 or n(1+2d) + 1",
      .prepare_exponent = 2,
      .citation = "[Farin 2002], nested multiplication, with fused steps; bound derived here"};
  static constexpr LaneRegisters lanes{.per_axis = 1, .shared = 3};

  static constexpr std::array guarantees{Guarantee{Property::ends_exact}, Guarantee{Property::constant_reproduced},
                                         Guarantee{Property::in_hull, 1}, Guarantee{Property::monotone, 1},
                                         Guarantee{Property::finite, 1},  Guarantee{Property::axes_independent},
                                         Guarantee{Property::total}};

  /// The power coefficients about either end; on an axis that is not local, C(n,i) b_i in place of those about b_0. All
  /// of `choice` is 2 on an axis where power form is corrected, 1 where it is plain, else 0.
  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::power, Scalar, Dimension, Degree> from_start;
    Curve<Form::power, Scalar, Dimension, Degree> from_end;
    Curve<Form::power, Scalar, Dimension, Degree> choice;

    [[nodiscard]] auto parts() const { return std::tie(from_start, from_end, choice); }
  };

  template <class Scalar, int Dimension, int Degree>
  static auto prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    auto [from_start, from_end] = Plain::prepare(curve);
    const auto scaled = HornerBernstein::prepare(curve).scaled;
    Curve<Form::power, Scalar, Dimension, Degree> choice(curve.degree());
    for (int axis = 0; axis < Dimension; ++axis) {
      const auto [size, largest] = sizes(curve, from_start, from_end, axis);
      const auto is_local = Scalar(1 / most_local) * size <= largest;  // false where the size overflows
      const Scalar chosen =
          select(Scalar(curve.degree()) * size <= largest, Scalar(1), select(is_local, Scalar(2), Scalar(0)));
      for (int i = 0; i <= curve.degree(); ++i) {
        choice(axis, i) = chosen;
        from_start(axis, i) = select(is_local, from_start(axis, i), scaled(axis, i));
      }
    }
    return Prepared<Scalar, Dimension, Degree>{from_start, from_end, choice};
  }

  /// Calls `use` with what was chosen for the curve, a function of t.
  template <class Scalar, int Dimension, int Degree, class Use>
  static auto with_chosen(const Prepared<Scalar, Dimension, Degree>& prepared, const Use& use) {
    using Mask = decltype(Scalar() <= Scalar());
    std::array<Mask, Dimension> is_local;
    std::array<Mask, Dimension> is_corrected;
    bool all_local = true;
    bool any_local = false;
    bool any_corrected = false;
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
      const Scalar choice = prepared.choice(static_cast<int>(axis), 0);
      is_local[axis] = Scalar(1) <= choice;
      is_corrected[axis] = Scalar(2) <= choice;
      all_local = all_local && all_of(is_local[axis]);
      any_local = any_local || any_of(is_local[axis]);
      any_corrected = any_corrected || any_of(is_corrected[axis]);
    }
    const auto about_end = [&prepared](const Scalar& t, const auto& at) {
      return Plain::from_nearer_end(prepared.from_start, prepared.from_end, t, at);
    };
    const auto plain = [=](const Scalar& t) {
      return about_end(t, [](const auto& curve, const Scalar& tau) { return HornerFma::evaluate(curve, tau); });
    };
    const auto local = [=](const Scalar& t) {
      auto [p, correction] =
          about_end(t, [](const auto& curve, const Scalar& tau) { return HornerCorrected::parts_at(curve, tau); });
      for (std::size_t k = 0; k < Dimension; ++k) {
        const auto axis = static_cast<int>(k);
        p[axis] = select(is_corrected[k], p[axis] + correction[axis], p[axis]);
      }
      return p;
    };
    const auto bernstein = [&prepared](const Scalar& t) { return HornerBernsteinFma::nested(prepared.from_start, t); };
    if (!any_local) return use(bernstein);
    if (all_local && !any_corrected) return use(plain);
    if (all_local) return use(local);
    return use([=](const Scalar& t) {
      auto p = bernstein(t);
      const auto q = local(t);
      for (std::size_t k = 0; k < Dimension; ++k) {
        const auto axis = static_cast<int>(k);
        p[axis] = select(is_local[k], q[axis], p[axis]);
      }
      return p;
    });
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    return with_chosen(prepared, [&](const auto& method) { return method(t); });
  }

 private:
  /// The larger sum_(j>0) |q_j| 2^-j of the two ends, and max|b_i|.
  template <class Scalar>
  struct Sizes {
    Scalar coefficients;
    Scalar points;
  };
  template <class Scalar, int Dimension, int Degree>
  static Sizes<Scalar> sizes(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve,
                             const Curve<Form::power, Scalar, Dimension, Degree>& from_start,
                             const Curve<Form::power, Scalar, Dimension, Degree>& from_end, int axis) {
    using std::abs;
    const auto larger = [](const Scalar& a, const Scalar& b) { return select(a < b, b, a); };
    const Scalar half = Scalar(1) / Scalar(2);
    Scalar largest = abs(curve(axis, 0));
    Scalar start(0);
    Scalar end(0);
    for (int j = curve.degree(); j > 0; --j) {
      largest = larger(largest, abs(curve(axis, j)));
      start = half * (start + abs(from_start(axis, j)));
      end = half * (end + abs(from_end(axis, j)));
    }
    return {larger(start, end), largest};
  }
};

}  // namespace bezierbench
