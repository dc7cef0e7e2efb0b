// SPDX-License-Identifier: MIT
// Your own bezierbench: the program with methods of yours compiled in. A method is a class with `info`, `prepare` and
// `evaluate`, as every method in core is; its id begins with own_.
//
//   int main(int argc, char** argv) { return bezierbench::harness::main<Mine>(argc, argv); }
//
// What it does is called in child processes only, so nothing that it does changes another method's results.
#pragma once

#include <array>
#include <span>

#include "core/evaluate/kernel/kernel_of.hpp"
#include "experiments/external/own_method.hpp"

namespace bezierbench::harness {

/// Runs the command line of bezierbench; returns the exit code.
int run(int argc, char** argv, std::span<const external::OwnMethod> own);

/// The kernel of a method for one dimension.
template <Evaluator Method, class Scalar, int Dimension>
inline constexpr Kernel<Scalar> kernel_in = instantiate::kernel<Method, Scalar, Dimension>();

template <Evaluator Method, class Scalar>
inline constexpr std::array<const Kernel<Scalar>*, 3> kernels_in{
    &kernel_in<Method, Scalar, 1>, &kernel_in<Method, Scalar, 2>, &kernel_in<Method, Scalar, 3>};

/// Whether `prepare` and `evaluate` take float as well. A method that takes it by its signatures only says so by a
/// member `double_only`.
template <class Method>
concept AnswersInFloat = !requires {
  Method::double_only;
}
&&requires(const Curve<Method::info.form, float, 2>& curve, float t) {
  { Method::evaluate(Method::prepare(curve), t) } -> std::same_as<Point<float, 2>>;
};

template <Evaluator Method>
constexpr external::OwnMethod own_method() {
  if constexpr (AnswersInFloat<Method>)
    return {&Method::info, kernels_in<Method, double>, kernels_in<Method, float>};
  else
    return {&Method::info, kernels_in<Method, double>, {}};
}

/// Runs bezierbench with these methods; returns the exit code. `info` states what the method takes (form and degrees);
/// a bound that it states is not checked.
template <Evaluator... Methods>
int main(int argc, char** argv) {
  static constexpr std::array<external::OwnMethod, sizeof...(Methods)> own{own_method<Methods>()...};
  return run(argc, argv, own);
}

}  // namespace bezierbench::harness
