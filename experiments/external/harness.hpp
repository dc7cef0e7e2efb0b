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
template <Evaluator Method, int Dimension>
inline constexpr Kernel<double> kernel_in = instantiate::kernel<Method, double, Dimension>();

/// Runs bezierbench with these methods; returns the exit code. `info` states what the method takes (form and degrees); a
/// bound that it states is not checked.
template <Evaluator... Methods>
int main(int argc, char** argv) {
  static constexpr std::array<external::OwnMethod, sizeof...(Methods)> own{
      external::OwnMethod{&Methods::info, {&kernel_in<Methods, 1>, &kernel_in<Methods, 2>, &kernel_in<Methods, 3>}}...};
  return run(argc, argv, own);
}

}  // namespace bezierbench::harness
