// SPDX-License-Identifier: MIT
// The first few findings of one kind, and how many more there are: a hostile table can have as many as it has fields.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bezierbench::bundle {

class FewLines {
 public:
  /// `place` begins the line that counts the findings left out.
  explicit FewLines(std::string place) : place_(std::move(place)) {}

  void add(std::string line) {
    if (++count_ <= most_) lines_.push_back(std::move(line));
  }

  /// Returns all lines and forgets them.
  std::vector<std::string> take() {
    if (count_ > most_) lines_.push_back(fmt::format("{}: {} more of that kind", place_, count_ - most_));
    count_ = 0;
    return std::exchange(lines_, {});
  }

 private:
  static constexpr std::size_t most_ = 5;
  std::string place_;
  std::size_t count_ = 0;
  std::vector<std::string> lines_;
};

}  // namespace bezierbench::bundle
