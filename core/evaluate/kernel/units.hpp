// SPDX-License-Identifier: MIT
// A roster dealt out to translation units, which are compiled side by side.
#pragma once

#include <cstddef>
#include <type_traits>

#include "core/method.hpp"

namespace bezierbench {

/// The place of a method in a list.
template <class E, class... Es>
constexpr std::size_t place_in(TypeList<Es...> /*list*/) {
  std::size_t place = 0;
  (void)((std::is_same_v<E, Es> || (++place, false)) || ...);
  return place;
}

namespace detail {

template <int Unit, int Units, class List>
struct Dealt;
template <int Unit, int Units, class... Es>
struct Dealt<Unit, Units, TypeList<Es...>> {
  static_assert(Unit < Units);
  using Type = typename Concatenated<
      std::conditional_t<place_in<Es>(TypeList<Es...>()) % Units == Unit, TypeList<Es>, TypeList<>>...>::Type;
};

}  // namespace detail

/// The methods at places Unit, Unit + Units, ... of a list.
template <int Unit, int Units, class List>
using Dealt = typename detail::Dealt<Unit, Units, List>::Type;

}  // namespace bezierbench
