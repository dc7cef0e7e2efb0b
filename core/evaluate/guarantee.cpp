// SPDX-License-Identifier: MIT
#include "core/evaluate/guarantee.hpp"

#include <algorithm>

#include "core/evaluate/roster.hpp"

namespace bezierbench {
namespace {

template <class E>
std::span<const Guarantee> stated() {
  if constexpr (requires { E::guarantees; })
    return E::guarantees;
  else
    return {};
}

template <class... Es>
std::span<const Guarantee> find(const MethodInfo& info, TypeList<Es...> /*roster*/) {
  std::span<const Guarantee> found;
  ((&Es::info == &info ? void(found = stated<Es>()) : void()), ...);
  return found;
}

}  // namespace

std::span<const Guarantee> guarantees_of(const MethodInfo& info) { return find(info, Evaluators{}); }

bool is_proved(const MethodInfo& info, Property property, int degree) {
  return degree >= 1 && std::ranges::any_of(guarantees_of(info), [&](const Guarantee& one) {
           return one.property == property && degree <= one.max_degree;
         });
}

}  // namespace bezierbench
