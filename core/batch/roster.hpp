// SPDX-License-Identifier: MIT
// The evaluators that have batch kernels. One line here makes them exist on every target, for every path that ends in
// the evaluator, in float and double and in 1 to 3 dimensions: one curve at many t, and many curves at one t each.
#pragma once

#include "core/convert/differences.hpp"
#include "core/convert/differences_centered.hpp"
#include "core/convert/factorial.hpp"
#include "core/convert/forward_substitution.hpp"
#include "core/convert/positive_sum.hpp"
#include "core/convert/triangle.hpp"
#include "core/evaluate/compensated_horner.hpp"
#include "core/evaluate/compensated_volk_schumaker.hpp"
#include "core/evaluate/correctly_rounded.hpp"
#include "core/evaluate/correctly_rounded_power.hpp"
#include "core/evaluate/de_casteljau.hpp"
#include "core/evaluate/de_casteljau_fma.hpp"
#include "core/evaluate/de_casteljau_lerp.hpp"
#include "core/evaluate/de_casteljau_lerp_fma.hpp"
#include "core/evaluate/de_casteljau_two_sided.hpp"
#include "core/evaluate/direct.hpp"
#include "core/evaluate/estrin.hpp"
#include "core/evaluate/horner.hpp"
#include "core/evaluate/horner_bernstein.hpp"
#include "core/evaluate/horner_bernstein_fma.hpp"
#include "core/evaluate/horner_centered.hpp"
#include "core/evaluate/horner_dd.hpp"
#include "core/evaluate/horner_fma.hpp"
#include "core/evaluate/power_sum.hpp"
#include "core/evaluate/volk_schumaker.hpp"
#include "core/evaluate/wang_ball.hpp"

namespace bezierbench::batch {

/// The state of an evaluator that prepares nothing: the curve.
template <Form F>
struct TheCurve {
  template <class Scalar, int Dimension, int Degree>
  using Prepared = Curve<F, Scalar, Dimension, Degree>;
};

/// An evaluator, the type of its prepared state (`State::Prepared`), and the number of vectors that its inner loop
/// needs in registers, for each axis and for all axes together. From these follows how many vectors of points go side
/// by side. (Horner-Bernstein's t and 1-t are only read, and may come from memory: with four vectors instead of two it
/// is a tenth faster on AVX2.)
template <class EvaluatorT, class StateT, int PerAxis, int Shared>
struct Entry {
  using Evaluator = EvaluatorT;
  using State = StateT;
  static constexpr int live(int dimension) { return PerAxis * dimension + Shared; }
  static constexpr int largest_unrolled_degree = 0;  ///< degrees from 2 to this have kernels of their own
};

/// A triangle goes axis by axis, with a vector for each level of a sweep.
template <class EvaluatorT>
using Triangle = Entry<EvaluatorT, TheCurve<Form::bernstein>, 0, 6>;

/// With the degree known at compile time where all values of a level of the triangle stay in registers. Each degree
/// takes a second to compile, so that only the fastest of the triangles has it.
template <class EvaluatorT>
struct UnrolledTriangle : Triangle<EvaluatorT> {
  static constexpr int largest_unrolled_degree = 12;
};

/// For every target.
using Unfused = TypeList<Triangle<DeCasteljau>,                          //
                         Triangle<DeCasteljauLerp>,                      //
                         Triangle<DeCasteljauTwoSided>,                  //
                         Entry<HornerBernstein, HornerBernstein, 1, 1>,  //
                         Entry<VolkSchumaker, HornerBernstein, 1, 2>,    //
                         Entry<Horner, TheCurve<Form::power>, 1, 1>>;

/// For targets that have a fused multiply-add in hardware: those that use it.
using FusedAndGroups = TypeList<Triangle<DeCasteljauFma>,                                         //
                                UnrolledTriangle<DeCasteljauLerpFma>,                             //
                                Entry<HornerBernsteinFma, HornerBernstein, 1, 1>,                 //
                                Entry<CompensatedVolkSchumaker, CompensatedVolkSchumaker, 2, 6>,  //
                                Entry<HornerFma, TheCurve<Form::power>, 1, 1>,                    //
                                Entry<CompensatedHorner, TheCurve<Form::power>, 2, 3>,            //
                                Entry<HornerDoubleDouble, TheCurve<Form::power_double_double>, 2, 3>>;

/// For one curve only: a lane that is left undecided comes back to the curve, which all lanes share.
using FusedOnly = TypeList<Entry<CorrectlyRounded, CorrectlyRounded, 0, 6>,  //
                           Entry<CorrectlyRoundedPower, CorrectlyRoundedPower, 0, 5>>;
using Fused = typename Concatenated<FusedAndGroups, FusedOnly>::Type;

/// For many curves only.
using GroupOnly = TypeList<Direct, WangBall, PowerSum, HornerCentered, Estrin>;

namespace detail {

template <class Entries>
struct EvaluatorsOf;
template <class... Entries>
struct EvaluatorsOf<TypeList<Entries...>> {
  using Type = TypeList<typename Entries::Evaluator...>;
};

}  // namespace detail

/// The evaluators with kernels for many curves, those that are fused last.
using UnfusedOfGroups = typename Concatenated<typename detail::EvaluatorsOf<Unfused>::Type, GroupOnly>::Type;
using FusedOfGroups = typename detail::EvaluatorsOf<FusedAndGroups>::Type;

/// The conversions with kernels for many curves. The exact ones are integers.
using ConversionsOfGroups =
    TypeList<Factorial, Differences, DifferencesCentered, ForwardSubstitution, PositiveSum, bezierbench::Triangle>;

}  // namespace bezierbench::batch
