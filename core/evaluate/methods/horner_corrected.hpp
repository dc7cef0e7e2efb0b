// SPDX-License-Identifier: MIT
// Formula: as horner_fma, with the roundings of the last two steps put right: r = fma(r_2, t, q_1), e = fma(r_2, t,
//   q_1 - r); s = fma(r, t, q_0), p = s + fma(e, t, fma(r, t, q_0 - s)).
// Source: the correction is derived here.
// Bound: (1 + 3u) u |p| + gamma_(n+1) sum_(j>0) |q_j t^j|; docs/proofs/local.md has the proof.
// Fails: as any power form, when its coefficients came out of a rounded conversion. Where a term t r is larger than the
//   coefficient that is added to it, q - r rounds and the correction is only partial.
#pragma once

#include "core/bound/amplification.hpp"
#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/steps.hpp"

namespace bezierbench {

struct HornerCorrected : TakenAsGiven<Form::power> {
  static constexpr MethodInfo info{.id = "horner_corrected",
                                   .label = "Horner, fused, last two steps corrected",
                                   .form = Form::power,
                                   .bound = ErrorBound{.text = "u |p| + gamma_(n+1) p~",
                                                       .amplification = Amplification::p_tilde_power,
                                                       .factor = [](int n, double u) { return gamma_over_u(n + 1, u); },
                                                       .underflow = [](int n) { return n + 4.0; },
                                                       .growth = [](int n) { return 2 * (n + 1.0); },
                                                       .result_roundings = 1 + 0x1p-20,
                                                       .constant_roundings = 1 + 0x1p-20},
                                   .fused = true,
                                   .flops = "d(n+6)",
                                   .citation = "[Boldo and Muller 2011], the error of a fused multiply-add"};
  static constexpr LaneRegisters lanes{.per_axis = 2, .shared = 1};

  /// The point as horner_fma has it, and the correction that is added to it.
  template <class Scalar, int Dimension>
  struct Parts {
    Point<Scalar, Dimension> plain;
    Point<Scalar, Dimension> correction;
  };
  template <class Scalar, int Dimension, int Degree>
  static Parts<Scalar, Dimension> parts_at(const Curve<Form::power, Scalar, Dimension, Degree>& curve,
                                           const Scalar& t) {
    const int n = curve.degree();
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = curve(axis, n);
    count_down<Scalar, Degree>(n - 3, [&](int j) {
      for (int axis = 0; axis < Dimension; ++axis) p[axis] = fused<Scalar>(p[axis], t, curve(axis, j + 2));
    });
    Point<Scalar, Dimension> correction;
    for (int axis = 0; axis < Dimension; ++axis) {
      const Scalar inner = n > 1 ? add_to(curve(axis, 1), t, p[axis]) : Scalar(0);
      const Scalar outer = n > 0 ? add_to(curve(axis, 0), t, p[axis]) : Scalar(0);
      correction[axis] = fused<Scalar>(inner, t, outer);
    }
    return {p, correction};
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Curve<Form::power, Scalar, Dimension, Degree>& curve, Scalar t) {
    const auto [plain, correction] = parts_at(curve, t);
    Point<Scalar, Dimension> p;
    for (int axis = 0; axis < Dimension; ++axis) p[axis] = plain[axis] + correction[axis];
    return p;
  }

 private:
  /// Makes p the rounded p t + coefficient; returns what this rounding took away.
  template <class Scalar>
  static Scalar add_to(const Scalar& coefficient, const Scalar& t, Scalar& p) {
    const Scalar factor = p;
    p = fused<Scalar>(factor, t, coefficient);
    return fused<Scalar>(factor, t, coefficient - p);
  }
};

}  // namespace bezierbench
