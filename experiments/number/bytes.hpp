// SPDX-License-Identifier: MIT
// Values as bytes and back, exactly and equal on every machine, for checkpoints. Integers are written seven bits at a
// time, least significant first; a double as its 64 bits.
//
// A type takes part with `each_field(bytes, self)`, which hands all its fields to `bytes` and serves both directions,
// or with `save(ByteWriter&) const` and `load(ByteReader&)`.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace bezierbench::number {

/// The bytes are not what the reader expects.
class MalformedBytes : public std::runtime_error {
 public:
  MalformedBytes() : std::runtime_error("not what was written") {}
};

class ByteWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <std::unsigned_integral T>
  void put(T value) {
    constexpr unsigned digit = 128;
    auto rest = static_cast<std::uint64_t>(value);
    for (; rest >= digit; rest /= digit) bytes_ += static_cast<char>(rest % digit + digit);
    bytes_ += static_cast<char>(rest);
  }
  template <std::signed_integral T>
  void put(T value) {  // 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
    const auto wide = static_cast<std::int64_t>(value);
    put((static_cast<std::uint64_t>(wide) << 1U) ^ static_cast<std::uint64_t>(wide >> 63U));
  }
  void put(double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t k = 0; k < sizeof bits; ++k, bits >>= 8U) bytes_ += static_cast<char>(bits & 0xffU);
  }
  void put(const std::string& text) {
    put(text.size());
    bytes_ += text;
  }
  template <class T>
  void put(const std::vector<T>& items) {
    put(items.size());
    for (const T& item : items) put(item);
  }
  template <class T, std::size_t size>
  void put(const std::array<T, size>& items) {
    for (const T& item : items) put(item);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class First, class Second>
  void put(const std::pair<First, Second>& value) {
    put(value.first);
    put(value.second);
  }
  template <class Key, class Value>
  void put(const std::map<Key, Value>& entries) {
    put(entries.size());
    for (const auto& entry : entries) put(entry);
  }
  template <class T>
  requires requires(const T& value, ByteWriter& bytes) { value.save(bytes); }
  void put(const T& value) { value.save(*this); }
  template <class T>
  requires requires(const T& value, ByteWriter& bytes) { T::each_field(bytes, value); }
  void put(const T& value) { T::each_field(*this, value); }

  std::string bytes_;
};

/// Throws MalformedBytes where the bytes end early or hold what no writer writes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  /// Throws MalformedBytes unless all was read.
  void finish() const {
    if (!rest_.empty()) throw MalformedBytes();
  }

 private:
  unsigned char next() {
    if (rest_.empty()) throw MalformedBytes();
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }
  template <std::unsigned_integral T>
  void get(T& value) {
    std::uint64_t sum = 0;
    unsigned char byte = 0;
    unsigned shift = 0;
    do {
      byte = next();
      const std::uint64_t digit = byte & 0x7fU;
      if (shift > 63 || (digit << shift) >> shift != digit) throw MalformedBytes();
      sum |= digit << shift;
      shift += 7;
    } while (byte >= 0x80U);
    value = static_cast<T>(sum);
    if (static_cast<std::uint64_t>(value) != sum) throw MalformedBytes();
  }
  template <std::signed_integral T>
  void get(T& value) {
    std::uint64_t folded = 0;
    get(folded);
    const auto wide = static_cast<std::int64_t>((folded >> 1U) ^ (~(folded & 1U) + 1U));
    value = static_cast<T>(wide);
    if (value != wide) throw MalformedBytes();
  }
  void get(double& value) {
    std::uint64_t bits = 0;
    for (unsigned k = 0; k < sizeof bits; ++k) bits |= static_cast<std::uint64_t>(next()) << (8 * k);
    value = std::bit_cast<double>(bits);
  }
  /// Every item takes at least one byte, so a wrong size is found before memory is allocated.
  std::size_t get_size() {
    std::size_t size = 0;
    get(size);
    if (size > rest_.size()) throw MalformedBytes();
    return size;
  }
  void get(std::string& text) {
    const auto size = get_size();
    text = rest_.substr(0, size);
    rest_.remove_prefix(size);
  }
  template <class T>
  void get(std::vector<T>& items) {
    items.clear();
    for (auto left = get_size(); left > 0; --left) {
      T item{};
      get(item);
      items.push_back(std::move(item));
    }
  }
  template <class T, std::size_t size>
  void get(std::array<T, size>& items) {
    for (T& item : items) get(item);
  }
  template <class T>
  void get(std::optional<T>& value) {
    bool there = false;
    get(there);
    if (!there) return value.reset();
    T read{};
    get(read);
    value = std::move(read);
  }
  template <class First, class Second>
  void get(std::pair<First, Second>& value) {
    get(value.first);
    get(value.second);
  }
  template <class Key, class Value>
  void get(std::map<Key, Value>& entries) {
    entries.clear();
    for (auto left = get_size(); left > 0; --left) {
      std::pair<Key, Value> entry{};
      get(entry);
      entries.insert(std::move(entry));
    }
  }
  template <class T>
  requires requires(T& value, ByteReader& bytes) { value.load(bytes); }
  void get(T& value) { value.load(*this); }
  template <class T>
  requires requires(T& value, ByteReader& bytes) { T::each_field(bytes, value); }
  void get(T& value) { T::each_field(*this, value); }

  std::string_view rest_;
};

}  // namespace bezierbench::number
