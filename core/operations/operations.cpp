// SPDX-License-Identifier: MIT
#include "core/operations/operations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/convert/roster.hpp"
#include "core/evaluate/roster.hpp"
#include "core/operations/counting.hpp"

namespace bezierbench {
namespace {

using counting::Counting;
using counting::tape;

/// Coefficients without a pattern, so that no difference of them is 0.
double some_value(int axis, int i) { return std::sin(1.0 + 3.0 * axis + i * i) + 2; }

template <Form F, int Dimension>
Curve<F, Counting, Dimension> some_curve(int degree) {
  Curve<F, Counting, Dimension> curve(degree);
  if constexpr (F == Form::rational) {
    curve.points = some_curve<Form::bernstein, Dimension>(degree);
    for (int i = 0; i <= degree; ++i) curve.weights[i] = Counting::input(some_value(Dimension, i));
  } else if constexpr (F == Form::power_double_double) {
    curve.high = some_curve<Form::power, Dimension>(degree);
    curve.low = some_curve<Form::power, Dimension>(degree);
  } else {
    for (int i = 0; i <= degree; ++i)
      for (int axis = 0; axis < Dimension; ++axis) curve(axis, i) = Counting::input(some_value(axis, i));
  }
  return curve;
}

/// A parameter that is neither a node nor an end point.
Counting some_parameter() {
  constexpr double time_of_t = 0;
  return Counting::input(0x1.2bec333018867p-2, time_of_t);  // 1 - sqrt(1/2)
}

/// Homogeneous<Method> with coordinates and weight in one vector.
template <class Method>
struct InOneVector {
  template <class Scalar>
  static auto prepare(const Curve<Form::rational, Scalar, 1>& curve) {
    Curve<Form::bernstein, Scalar, 1> lifted(curve.degree());
    for (int i = 0; i <= curve.degree(); ++i) lifted(0, i) = curve.weights[i] * curve.points(0, i);
    return Method::prepare(lifted);
  }
  template <class Prepared, class Scalar>
  static auto evaluate(const Prepared& prepared, Scalar t) {
    auto lifted = Method::evaluate(prepared, t);
    lifted[0] /= lifted[0];
    return lifted;
  }
};

template <class E>
struct OneVector {
  using Method = E;
  static constexpr int further_lanes = 0;
};
template <class Method_>
struct OneVector<Homogeneous<Method_>> {
  using Method = InOneVector<Method_>;
  static constexpr int further_lanes = 1;
};

// What cannot be counted: work on the bits of numbers and on integers.
template <class M>
inline constexpr bool counts_curve = true;
template <>
inline constexpr bool counts_curve<CorrectlyRounded> = false;
template <>
inline constexpr bool counts_curve<CorrectlyRoundedPower> = false;
template <>
inline constexpr bool counts_curve<ExactToPower> = false;
template <>
inline constexpr bool counts_curve<ExactToPowerDoubleDouble> = false;
template <>
inline constexpr bool counts_curve<ExactToPowerCentered> = false;
template <>
inline constexpr bool counts_curve<ExactToBernstein> = false;

/// Where libm does the work, the result is not bit-stable.
template <class E>
inline constexpr bool counts_point = E::info.bit_stable;

/// What was counted.
struct Counted {
  ByOperation curve;
  ByOperation point;
  double chain;
};

/// `E` in the form F on `Dimension` axes; `Whole` is the evaluator of the roster.
template <class E, class Whole, int Dimension>
Counted counted(int degree, const ByOperation& latency) {
  tape = {{}, latency};
  const auto prepared = [degree] {
    const auto curve = some_curve<Whole::info.form, Dimension>(degree);
    if constexpr (counts_curve<Whole>)
      return E::prepare(curve);
    else
      return PreparedOf<E, Counting, Dimension>(degree);
  }();
  const auto curve = std::exchange(tape.count, {});
  const auto point = E::evaluate(prepared, some_parameter());
  double chain = 0;
  for (const auto& coordinate : point) chain = std::max(chain, coordinate.ready());
  return {curve, tape.count, chain};
}

template <class C, int Dimension>
Counted converted(int degree, const ByOperation& /*latency*/) {
  tape = {};
  (void)C::convert(some_curve<C::info.form, Dimension>(degree));
  return {tape.count, {}, 0};
}

using Count = Counted (*)(int degree, const ByOperation& latency);

/// The counts of a method.
struct CountedMethod {
  const MethodInfo* info;
  int further_lanes;
  bool curve_counts;
  bool point_counts;
  Count in_one_vector;
  std::array<Count, 2> on_axes;  ///< on one and on two
};

template <class E>
constexpr CountedMethod evaluator_entry() {
  if constexpr (counts_point<E>)
    return {&E::info,
            OneVector<E>::further_lanes,
            counts_curve<E>,
            true,
            counted<typename OneVector<E>::Method, E, 1>,
            {counted<E, E, 1>, counted<E, E, 2>}};
  else
    return {&E::info, 0, false, false, nullptr, {}};
}

template <class C>
constexpr CountedMethod conversion_entry() {
  if constexpr (counts_curve<C>)
    return {&C::info, 0, true, false, converted<C, 1>, {converted<C, 1>, converted<C, 2>}};
  else
    return {&C::info, 0, false, false, nullptr, {}};
}

template <class... Es, class... Cs>
const CountedMethod* find(const MethodInfo& method, TypeList<Es...> /*evaluators*/, TypeList<Cs...> /*conversions*/) {
  static constexpr std::array entries{evaluator_entry<Es>()..., conversion_entry<Cs>()...};
  const auto* const found = std::ranges::find(entries, &method, &CountedMethod::info);
  return found == entries.end() ? nullptr : &*found;
}

const CountedMethod* find(const MethodInfo& method) { return find(method, Evaluators{}, Conversions{}); }

/// Numbers of operations on any number of axes: all axes are treated alike, so they grow with it by equal steps.
ByOperation on_axes(const CountedMethod& entry, ByOperation Counted::*part, int degree, int dimension, Layout layout) {
  if (layout == Layout::axes) return entry.in_one_vector(degree, {}).*part;
  const auto one = entry.on_axes[0](degree, {}).*part;
  const auto two = entry.on_axes[1](degree, {}).*part;
  ByOperation all;
  for (std::size_t kind = 0; kind < operation_kinds; ++kind)
    all.values[kind] = one.values[kind] + (dimension - 1) * (two.values[kind] - one.values[kind]);
  return all;
}

}  // namespace

int side_by_side(const MethodInfo& evaluator, int dimension) {
  const auto* const entry = find(evaluator);
  return dimension + (entry == nullptr ? 0 : entry->further_lanes);
}

std::optional<ByOperation> point_operations(const MethodInfo& evaluator, int degree, int dimension, Layout layout) {
  const auto* const entry = find(evaluator);
  if (entry == nullptr || !entry->point_counts) return std::nullopt;
  return on_axes(*entry, &Counted::point, degree, dimension, layout);
}

std::optional<ByOperation> curve_operations(const MethodInfo& evaluator, const MethodInfo* conversion, int degree,
                                            int dimension, Layout layout) {
  const auto* const entry = find(evaluator);
  if (entry == nullptr || !entry->curve_counts) return std::nullopt;
  auto sum = on_axes(*entry, &Counted::curve, degree, dimension, layout);
  if (conversion == nullptr) return sum;
  const auto* const before = find(*conversion);
  if (before == nullptr || !before->curve_counts) return std::nullopt;
  return sum += on_axes(*before, &Counted::curve, degree, dimension, layout);
}

std::optional<double> point_chain(const MethodInfo& evaluator, int degree, const ByOperation& latency) {
  const auto* const entry = find(evaluator);
  if (entry == nullptr || !entry->point_counts) return std::nullopt;
  return entry->in_one_vector(degree, latency).chain;
}

}  // namespace bezierbench
