// SPDX-License-Identifier: MIT
// Checks of a study, whether it comes from a file or from the command line: what is wrong with it, and which key is at
// fault.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/suite/suite.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

/// The first thing wrong with a study.
struct Fault {
  /// The index of a fault that is not in a value: the study must not have the key.
  static constexpr std::size_t key_itself = std::numeric_limits<std::size_t>::max();

  std::string_view key;        ///< the key at fault
  std::size_t index = 0;       ///< index of the element at fault in the key's value
  std::string_view other_key;  ///< the key that `key` or its default contradicts; empty if there is none
  std::string what;            ///< what is wrong and what to do
};

using Finding = std::optional<Fault>;

/// Returns the first fault among `values`: a non-empty text that `check(value)` returns, or a value that occurs twice.
/// Takes O(n log n) time for n values, since an axis may have any number of them.
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

/// Where to report the fault: the option that set its key or the other key; else `FILE:LINE:COLUMN` of the element or
/// value at fault; else that of the other key's value, if the study leaves the key out; else that of the study's
/// header. Empty for a study that was not read from a file.
std::string place_of(const Study& study, const Fault& fault);

/// Throws Failure(Exit::usage) with the line `PLACE: study "ID": what; what to do`.
[[noreturn]] void refuse(const Study& study, const Fault& fault);

/// The first fault of `study`; empty where it can be run: its ids are known, its values are in range, its axes fit one
/// another and the kind, and no axis has a value twice.
Finding validate(const Study& study, const Vocabulary& known);

/// Why `seed` is not a valid seed, else empty. Seeds are 0 to 2^63-1, which TOML can hold.
std::string seed_problem(std::uint64_t seed);

/// Why `id` cannot be the id of a study or suite, else empty. Ids are used in CSV fields, globs and file names.
std::string id_problem(std::string_view id);

/// Throws Failure(Exit::usage), naming the file that was read last, where two suites of a bundle, or two studies of all
/// its suites, have the same id.
void check_unique_ids(std::span<const Suite> suites, std::string_view last_file);

}  // namespace bezierbench::suite
