// SPDX-License-Identifier: MIT
// Texts of composed methods (paths, homogeneous ones), joined from those of their parts at compile time.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/evaluate/evaluator.hpp"

namespace bezierbench::detail {

// Parts of a text, each a type with a name, of which the texts of compositions are made at compile time. (Lambdas have
// names that differ between translation units; the linker would drop a text that another unit refers to.)
template <std::size_t Size>
struct Characters {
  consteval Characters(const char (&literal)[Size]) { std::copy(literal, literal + Size, data); }
  char data[Size]{};
};
template <Characters Given>
struct Literal {
  static constexpr std::string_view text{Given.data, sizeof(Given.data) - 1};
};
template <class M>
struct IdOf {
  static constexpr std::string_view text = M::info.id;
};
template <class M>
struct LabelOf {
  static constexpr std::string_view text = M::info.label;
};
template <class M>
struct FlopsOf {
  static constexpr std::string_view text = M::info.flops;
};
template <class M>
struct CitationOf {
  static constexpr std::string_view text = M::info.citation;
};
template <class M>
struct BoundOf {
  static constexpr std::string_view text = M::info.bound->text;
};

/// The parts, one after the other, in storage that lives as long as the program.
template <class... Parts>
struct Joined {
  static constexpr std::size_t size = (Parts::text.size() + ...);
  static constexpr std::array<char, size> copied() {
    std::array<char, size> all{};
    char* end = all.data();
    ((end = std::copy(Parts::text.begin(), Parts::text.end(), end)), ...);
    return all;
  }
  static constexpr std::array<char, size> storage = copied();
  static constexpr std::string_view text{storage.data(), size};
};

}  // namespace bezierbench::detail
