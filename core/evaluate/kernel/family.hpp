// SPDX-License-Identifier: MIT
// Families of evaluators whose kernels are coded alike.
#pragma once

#include "core/method.hpp"

namespace bezierbench::instantiate {

/// `triangle`: methods for Bernstein form whose cost grows faster than the degree, as de Casteljau's does. `bernstein`:
/// all others for Bernstein form. `rational`: all methods for rational form. `power`: the rest.
enum class KernelFamily { triangle, bernstein, power, rational };

constexpr KernelFamily family_of(const MethodInfo& info) {
  if (info.form == Form::rational) return KernelFamily::rational;
  if (info.form != Form::bernstein) return KernelFamily::power;
  return info.cost_exponent > 1 ? KernelFamily::triangle : KernelFamily::bernstein;
}

}  // namespace bezierbench::instantiate
