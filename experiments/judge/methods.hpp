// SPDX-License-Identifier: MIT
// The methods that there are: evaluators, conversions and those of companion problems, our own and, in a build with peers,
// those of other libraries; and those of them that a study names.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/arc_length/kernel.hpp"
#include "core/evaluate/kernel/kernel.hpp"
#include "core/method.hpp"
#include "core/project/kernel.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// Our own evaluators in roster order, then the peers, which exist in double only. Dimension is 1, 2 or 3.
template <class Scalar>
std::span<const Kernel<Scalar>> methods(int dimension);

/// Likewise for arc lengths and for projection.
std::span<const ArcLengthKernel> arc_length_methods(int dimension);
std::span<const ProjectionKernel> projection_methods(int dimension);

/// The entry for a method of this form; nullptr if there is none.
template <class Scalar>
const Kernel<Scalar>* find_method(std::string_view id, Form form, int dimension) {
  for (const auto& kernel : methods<Scalar>(dimension))
    if (kernel.info->id == id && kernel.info->form == form) return &kernel;
  return nullptr;
}

/// The methods of a companion problem that `study.methods` names, in the order of `infos`, which holds all of them; where
/// it names none, our own. Throws Failure(usage) for an entry that names no method of this problem.
std::vector<const MethodInfo*> chosen_companions(const suite::Study& study, std::vector<const MethodInfo*> infos);

/// Throws Failure(usage) where no method that was chosen takes curves of the study's form.
void require_form(const suite::Study& study, bool any_method);

/// True where the method has points at every t of the interval.
bool takes(const MethodInfo& info, const suite::Interval& t_interval);

/// Every method that `study.methods` names and that takes curves of the study's form at the t of the cell, in roster
/// order; all of them when it names none. Other libraries' methods must be named. Throws Failure(usage) for an id that
/// exists only for another form, scalar or dimension, or for none of the t of the study.
template <class Scalar>
std::vector<const Kernel<Scalar>*> chosen_kernels(const suite::Study& study, const sample::Cell& cell);

// Checks that the kind of a study, or the problem that it times, takes the inputs of the study. The reader of suites
// has checked them for the kind, but programs and tests also make studies without it.

/// Throws Failure(usage) for inputs that the kind of the study does not take: suite::check_inputs.
void check_inputs(const suite::Study& study);

/// Throws Failure(usage) for inputs and axes that the problem of a timing study does not take: suite::check_timed.
void check_timed(const suite::Study& study, const suite::Kind& judged);

}  // namespace bezierbench::judge
