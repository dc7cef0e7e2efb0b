// SPDX-License-Identifier: MIT
// What is wrong with a study, and where it is written.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// The first thing wrong with a study.
struct Fault {
  /// The index of a fault that is not in a value: the key should not be there at all.
  static constexpr std::size_t key_itself = std::numeric_limits<std::size_t>::max();

  std::string_view key;        ///< the key at fault
  std::size_t index = 0;       ///< of the element of its value
  std::string_view other_key;  ///< the key that its value or default does not fit, if the two are at odds
  std::string what;            ///< what is wrong and what to do
};

using Finding = std::optional<Fault>;

/// Applies `check(value) -> std::string` to every element, and looks for equal ones.
/// The time grows as the number of elements, but for a logarithm: an axis may have any number of them.
template <class T, class Check>
Finding each(std::string_view key, const std::vector<T>& values, Check check) {
  std::set<T> before;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::string what = check(values[i]); !what.empty()) return Fault{key, i, {}, std::move(what)};
    if (!before.insert(values[i]).second)
      return Fault{key, i, {}, fmt::format("{} has this value twice; remove one", key)};
  }
  return std::nullopt;
}

/// Where the fault is: the option that set its key or the other key; else `FILE:LINE:COLUMN` of the element or value at
/// fault; else that of the other key, if the key is left out; else that of the study's header. Empty for a study that
/// was not read.
std::string place_of(const Study& study, const Fault& fault);

/// Throws Failure(Exit::usage) as `PLACE: study "ID": what; what to do`.
[[noreturn]] void refuse(const Study& study, const Fault& fault);

}  // namespace bezierbench::suite
