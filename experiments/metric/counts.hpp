// SPDX-License-Identifier: MIT
// What is counted beside tallies of errors, and how a struct of tallies and counts merges: field by field. All of it is
// free of order, as tallies are.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Merges `other` into `sum`: numbers are added, what has `merge` merges, and of any other type each field does, so
/// `T::each_field` returns what it is given returns.
template <class T>
void merge_fields(T& sum, const T& other) {
  if constexpr (std::unsigned_integral<T>) {
    sum += other;
  } else if constexpr (requires { sum.merge(other); }) {
    sum.merge(other);
  } else {
    constexpr auto fields_of = [](auto&... fields) { return std::tie(fields...); };
    const auto into = T::each_field(fields_of, sum);
    const auto from = T::each_field(fields_of, other);
    [&]<std::size_t... k>(std::index_sequence<k...> /*all*/) {
      (merge_fields(std::get<k>(into), std::get<k>(from)), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(into)>>{});
  }
}

/// One T for each row of a part of a study, in the order of its rows.
template <class T>
struct Rows {
  std::vector<T> rows;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.rows);
  }

  void merge(const Rows& other) {
    if (other.rows.size() != rows.size()) throw std::invalid_argument("tallies of different parts");
    for (std::size_t k = 0; k < rows.size(); ++k) merge_fields(rows[k], other.rows[k]);
  }
};

}  // namespace bezierbench::metric
