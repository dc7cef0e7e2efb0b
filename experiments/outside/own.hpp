// SPDX-License-Identifier: MIT
// Methods that a user's own program has compiled in, with the harness. They are called as any method from outside: in a
// child process.
#pragma once

#include <memory>

#include "experiments/outside/child.hpp"
#include "experiments/outside/method.hpp"
#include "experiments/outside/own_method.hpp"

namespace bezierbench::outside {

/// Throws Failure(usage) for an id that does not begin with own_. A bound that its info states is not used: what is
/// proved of a method from outside is not known here.
std::shared_ptr<const Method> own(const OwnMethod& method, const Limits& limits, bool (*stop)());

}  // namespace bezierbench::outside
