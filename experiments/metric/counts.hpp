// SPDX-License-Identifier: MIT
// Counts besides tallies of errors, and the merge of a struct of tallies and counts: field by field. The order in
// which values are merged changes nothing, as for tallies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/metric/tally.hpp"

namespace bezierbench::metric {

/// Trials in which something happened.
struct TrialCount {
  std::uint64_t count = 0;
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max();  ///< trial

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.count, self.first);
  }

  void add(std::uint64_t trial) {
    ++count;
    first = std::min(first, trial);
  }
  void merge(const TrialCount& other) {
    count += other.count;
    first = std::min(first, other.first);
  }
};

/// The largest of the values seen, none of which is below 0; 0 where none was.
template <class T>
struct Largest {
  T value = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.value);
  }

  void add(T other) { value = std::max(value, other); }
  void merge(const Largest& other) { add(other.value); }
};

/// A whole number of each trial: their sum, and the largest.
struct Total {
  std::uint64_t sum = 0;
  std::uint64_t largest = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.sum, self.largest);
  }

  void add(std::uint64_t value) {
    sum += value;
    largest = std::max(largest, value);
  }
  void merge(const Total& other) {
    sum += other.sum;
    largest = std::max(largest, other.largest);
  }
};

/// Adds an error in bound units, which was not rounded to 24 bits yet.
inline void add_rounded(double error, Tally& tally) {
  const double rounded = to_24_bits(error);
  if (std::isfinite(rounded))
    tally.add(rounded);
  else
    tally.add_infinite();
}

/// Merges `other` into `sum`. Numbers are added. A type with a member `merge` merges by it, any other struct field by
/// field: its `each_field` returns what `bytes` returns. Vectors, of equal sizes, and arrays merge element by element,
/// maps key by key. An empty optional takes the value of the other.
template <class T>
void merge_fields(T& sum, const T& other);
template <class T>
void merge_fields(std::optional<T>& sum, const std::optional<T>& other);
template <class T>
void merge_fields(std::vector<T>& sum, const std::vector<T>& other);
template <class T, std::size_t size>
void merge_fields(std::array<T, size>& sum, const std::array<T, size>& other);
template <class Key, class T>
void merge_fields(std::map<Key, T>& sum, const std::map<Key, T>& other);

/// Merges every field, for a struct whose `merge` does that and more.
template <class T>
void merge_each_field(T& sum, const T& other) {
  constexpr auto fields_of = [](auto&... fields) { return std::tie(fields...); };
  const auto into = T::each_field(fields_of, sum);
  const auto from = T::each_field(fields_of, other);
  [&]<std::size_t... k>(std::index_sequence<k...> /*all*/) {
    (merge_fields(std::get<k>(into), std::get<k>(from)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(into)>>{});
}

template <class T>
void merge_fields(T& sum, const T& other) {
  if constexpr (std::unsigned_integral<T>)
    sum += other;
  else if constexpr (requires { sum.merge(other); })
    sum.merge(other);
  else
    merge_each_field(sum, other);
}

template <class T>
void merge_fields(std::optional<T>& sum, const std::optional<T>& other) {
  if (!other) return;
  if (sum)
    merge_fields(*sum, *other);
  else
    sum = other;
}

template <class T>
void merge_fields(std::vector<T>& sum, const std::vector<T>& other) {
  if (other.size() != sum.size()) throw std::invalid_argument("tallies of different parts");
  for (std::size_t k = 0; k < sum.size(); ++k) merge_fields(sum[k], other[k]);
}

template <class T, std::size_t size>
void merge_fields(std::array<T, size>& sum, const std::array<T, size>& other) {
  for (std::size_t k = 0; k < size; ++k) merge_fields(sum[k], other[k]);
}

template <class Key, class T>
void merge_fields(std::map<Key, T>& sum, const std::map<Key, T>& other) {
  for (const auto& [key, value] : other)
    if (const auto [entry, is_new] = sum.try_emplace(key, value); !is_new) merge_fields(entry->second, value);
}

/// One T for each row of a part of a study, in the order of its rows.
template <class T>
struct Rows {
  std::vector<T> rows;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.rows);
  }

  void merge(const Rows& other) { merge_each_field(*this, other); }
};

}  // namespace bezierbench::metric
