// SPDX-License-Identifier: MIT
// The evaluators that have batch kernels. One line here makes them exist on every target, for every path that ends in
// the evaluator, in float and double and in 1 to 3 dimensions: one curve at many t, and many curves at one t each.
#pragma once

#include <type_traits>

#include "core/convert/differences.hpp"
#include "core/convert/differences_centered.hpp"
#include "core/convert/factorial.hpp"
#include "core/convert/forward_substitution.hpp"
#include "core/convert/positive_sum.hpp"
#include "core/convert/triangle.hpp"
#include "core/evaluate/kernel/family.hpp"
#include "core/evaluate/roster.hpp"

namespace bezierbench::batch {

/// The state of an evaluator that prepares nothing: the curve.
template <Form F>
struct TheCurve {
  template <class Scalar, int Dimension, int Degree>
  using Prepared = Curve<F, Scalar, Dimension, Degree>;
};

struct BarycentricState {
  template <class Scalar, int Dimension, int Degree>
  using Prepared = Barycentric<Scalar, Dimension, Degree>;
};

/// An evaluator, the type of its prepared state (`State::Prepared`), and the number of vectors that its inner loop
/// needs in registers, for each axis and for all axes together. From these follows how many vectors of points go side
/// by side. (Horner-Bernstein's t and 1-t are only read and may come from memory: four vectors instead of two make it a
/// tenth faster on AVX2. The number is also understated on purpose where divisions or memory take the time.)
template <class EvaluatorT, class StateT, int PerAxis, int Shared>
struct Entry {
  using Evaluator = EvaluatorT;
  using State = StateT;
  static constexpr int live(int dimension) { return PerAxis * dimension + Shared; }
  static constexpr int largest_unrolled_degree = 0;  ///< degrees from 2 to this have kernels of their own
  static constexpr bool one_curve_only = false;      ///< true without kernels for many curves
};

/// For one curve only: where lanes that are left undecided come back to the curve, which all lanes share, or where
/// curves have weights or are prepared in ways that groups are not.
template <class EntryT>
struct OneCurve : EntryT {
  static constexpr bool one_curve_only = true;
};

/// Whether a kernel for one axis evaluates all axes in turn. It does for triangles, whose axes share only t.
template <class Evaluator>
inline constexpr bool axis_by_axis =
    PreparesNothing<Evaluator>&& instantiate::family_of(Evaluator::info) == instantiate::KernelFamily::triangle;

/// A triangle has a vector for each level of a sweep.
template <class EvaluatorT>
using Triangle = Entry<EvaluatorT, TheCurve<Form::bernstein>, 0, 6>;

/// With the degree known at compile time where all values of a level of the triangle stay in registers. Each degree
/// takes a second to compile, so that only the fastest of the triangles has it.
template <class EvaluatorT>
struct UnrolledTriangle : Triangle<EvaluatorT> {
  static constexpr int largest_unrolled_degree = 12;
};

/// About the nearer end: each lane chooses between two coefficients.
template <class EvaluatorT>
using LocalEntry = Entry<EvaluatorT, EvaluatorT, 1, 3>;

/// Evaluators whose kernels for one target and scalar type are compiled together: each family is a translation unit of
/// some seconds, named in CMakeLists.txt. `Fused` is for targets that have a fused multiply-add in hardware.
struct Triangles {
  using Unfused = TypeList<Triangle<DeCasteljau>,          //
                           Triangle<DeCasteljauLerp>,      //
                           Triangle<DeCasteljauTwoSided>,  //
                           Entry<Local<DeCasteljau>, Local<DeCasteljau>, 0, 6>>;
  using Fused = TypeList<Triangle<DeCasteljauFma>, UnrolledTriangle<DeCasteljauLerpFma>,
                         OneCurve<Entry<DeCasteljauFixedPoint, DeCasteljauFixedPoint, 0, 6>>>;
};

/// One pass over the coefficients, with sums and products.
struct Sums {
  using Unfused =
      TypeList<Entry<Direct, Direct, 1, 2>,                    //
               Entry<HornerBernstein, HornerBernstein, 1, 1>,  //
               Entry<VolkSchumaker, HornerBernstein, 1, 2>,    //
               Entry<WangBall, WangBall, 1, 3>,                //
               Entry<Seiler, Seiler, 1, 3>,                    //
               Entry<PowerSum, TheCurve<Form::power>, 1, 2>,   //
               Entry<Horner, TheCurve<Form::power>, 1, 1>,     //
               Entry<HornerCentered, TheCurve<Form::power_centered>, 1, 1>, Entry<Estrin, TheCurve<Form::power>, 0, 3>>;
  using Fused =
      TypeList<Entry<HornerBernsteinFma, HornerBernstein, 1, 1>, Entry<HornerFma, TheCurve<Form::power>, 1, 1>,
               Entry<HornerCorrected, TheCurve<Form::power>, 2, 1>, LocalEntry<Local<HornerBernsteinFma>>,
               LocalEntry<LocalOrBernstein::Plain>, LocalEntry<LocalOrBernstein::Corrected>,
               LocalEntry<LocalOrBernstein>>;
};

/// Those whose divisions take most of the time.
struct Quotients {
  using Unfused = TypeList<Entry<WoznyChudy, TheCurve<Form::bernstein>, 0, 3>,                 //
                           Entry<WoznyChudyPositive, TheCurve<Form::bernstein>, 0, 3>,         //
                           OneCurve<Entry<BarycentricChebyshev, BarycentricState, 1, 2>>,      //
                           OneCurve<Entry<BarycentricUniform, BarycentricState, 1, 2>>,        //
                           OneCurve<Entry<DeCasteljauFarin, TheCurve<Form::rational>, 0, 8>>,  //
                           OneCurve<Entry<WoznyChudyRational, WoznyChudyRational, 0, 3>>,      //
                           OneCurve<Entry<WoznyChudyPositiveRational, WoznyChudyRational, 0, 3>>>;
  using Fused = TypeList<>;
};

struct Compensated {
  using Unfused = TypeList<>;
  using Fused = TypeList<Entry<CompensatedDeCasteljau, TheCurve<Form::bernstein>, 0, 12>,    //
                         Entry<CompensatedDeCasteljauK3, TheCurve<Form::bernstein>, 0, 16>,  //
                         Entry<CompensatedDeCasteljauK4, TheCurve<Form::bernstein>, 0, 16>,  //
                         Entry<CompensatedVolkSchumaker, CompensatedVolkSchumaker, 2, 6>,    //
                         Entry<CompensatedHorner, TheCurve<Form::power>, 2, 3>,              //
                         Entry<CompensatedHornerK3, TheCurve<Form::power>, 0, 9>,            //
                         Entry<CompensatedHornerK4, TheCurve<Form::power>, 0, 12>,           //
                         Entry<HornerDoubleDouble, TheCurve<Form::power_double_double>, 2, 3>>;
};

struct Rounded {
  using Unfused = TypeList<>;
  using Fused = TypeList<OneCurve<Entry<CorrectlyRounded, CorrectlyRounded, 0, 6>>,  //
                         OneCurve<Entry<CorrectlyRoundedPower, CorrectlyRoundedPower, 0, 5>>>;
};

using Families = TypeList<Triangles, Sums, Quotients, Compensated, Rounded>;

/// All entries of a family, the fused ones last.
template <class Family>
using EntriesOf = typename Concatenated<typename Family::Unfused, typename Family::Fused>::Type;

namespace detail {

template <class Entries>
struct OfGroups;
template <class... Entries>
struct OfGroups<TypeList<Entries...>> {
  using Type = typename Concatenated<
      std::conditional_t<Entries::one_curve_only, TypeList<>, TypeList<typename Entries::Evaluator>>...>::Type;
};

template <class List>
struct InFamilies;
template <class... Family>
struct InFamilies<TypeList<Family...>> {
  using Unfused = typename Concatenated<typename OfGroups<typename Family::Unfused>::Type...>::Type;
  using Fused = typename Concatenated<typename OfGroups<typename Family::Fused>::Type...>::Type;
};

template <class Evaluator, class... Es>
constexpr bool is_one_of(TypeList<Es...> /*evaluators*/) {
  return (std::is_same_v<Evaluator, Es> || ...);
}

template <class Evaluator>
constexpr bool takes_rational() {
  if constexpr (Evaluator::info.form == Form::bernstein)
    return is_one_of<Homogeneous<Evaluator>>(Evaluators());
  else
    return false;
}

}  // namespace detail

/// True where the evaluator takes rational curves, too, by their homogeneous coordinates.
template <class Evaluator>
inline constexpr bool takes_rational = detail::takes_rational<Evaluator>();

/// The evaluators with kernels for many curves, those that are fused last.
using UnfusedOfGroups = typename detail::InFamilies<Families>::Unfused;
using FusedOfGroups = typename detail::InFamilies<Families>::Fused;

/// The conversions with kernels for many curves. The exact ones are integers.
using ConversionsOfGroups =
    TypeList<Factorial, Differences, DifferencesCentered, ForwardSubstitution, PositiveSum, bezierbench::Triangle>;

}  // namespace bezierbench::batch
