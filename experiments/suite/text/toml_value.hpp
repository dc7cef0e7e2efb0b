// SPDX-License-Identifier: MIT
// Values of a suite read from TOML and written as TOML; internal to this folder.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/suite/ids.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/number/echo.hpp"

namespace bezierbench::suite {

/// Where a value comes from, for messages: the file or option, and the key.
struct Source {
  std::string_view name;  ///< a file, or the option that was given, e.g. `--set degree=4`
  std::string_view key;
  std::span<const Kind* const> kinds = {};  ///< those that the key `kind` may name
};

/// Throws Failure(Exit::usage) with `NAME:LINE:COLUMN: what`, or `NAME: what` for a value that is not from a file.
[[noreturn]] void fail(std::string_view name, const toml::source_position& at, std::string_view what);

/// Throws as fail() does, at `node`, with a message that it is not `expected`.
[[noreturn]] void fail_type(const Source& source, const toml::node& node, std::string_view expected);

/// Reads the value of `node`, or throws a Failure that says what was expected. Numbers that may have a fraction may be
/// strings, in hexadecimal for instance (number.hpp); whole numbers may be strings in an option only.
/// A value beyond the range of int becomes the nearest int, so that the check of the key's range reports it.
void read(const Source& source, const toml::node& node, std::string& out);
void read(const Source& source, const toml::node& node, std::int64_t& out);
void read(const Source& source, const toml::node& node, int& out);
void read(const Source& source, const toml::node& node, double& out);
void read(const Source& source, const toml::node& node, Interval& out);
/// Reads the id of one of `source.kinds`.
void read(const Source& source, const toml::node& node, const Kind*& out);
/// Reads the value of the key `field` into the study; `name` is that of the file or option.
void read(std::string_view name, const toml::node& node, const Field& field, Study& out);

template <Worded Enum>
void read(const Source& source, const toml::node& node, Enum& out) {
  std::string word;
  read(source, node, word);
  const auto value = parse<Enum>(word);
  if (!value)
    fail(source.name, node.source().begin,
         "unknown " + std::string(source.key) + " \"" + echo(word) + "\"" + suggestion(word, all_words<Enum>()));
  out = *value;
}

template <class T>
void read(const Source& source, const toml::node& node, std::vector<T>& out) {
  const toml::array* array = node.as_array();
  if (array == nullptr) fail_type(source, node, "an array");
  if (array->empty()) fail_type(source, node, "an array with a value in it; leave the key out for the default");
  out.clear();
  for (const toml::node& element : *array) {
    T value{};
    read(source, element, value);
    out.push_back(std::move(value));
  }
}

/// TOML text that reads back to an equal value.
std::string to_text(std::string_view value);
std::string to_text(std::int64_t value);
std::string to_text(double value);
std::string to_text(const Interval& value);
std::string to_text(const Kind* value);
inline std::string to_text(int value) { return to_text(static_cast<std::int64_t>(value)); }
inline std::string to_text(const std::string& value) { return to_text(std::string_view(value)); }

template <Worded Enum>
std::string to_text(Enum value) {
  return to_text(name(value));
}

template <class T>
std::string to_text(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) {
    if (text.size() > 1) text += ", ";
    text += to_text(value);
  }
  return text + "]";
}

}  // namespace bezierbench::suite
