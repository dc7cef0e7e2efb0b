// SPDX-License-Identifier: MIT
// Bytes of a font's table, read as big-endian numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace bezierbench::curves {

/// What is wrong with a table or a glyph, without the file: read_font names it.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of `table` from `begin`. Throws Malformed where the table is shorter.
inline std::string_view bytes_from(std::string_view table, std::size_t begin) {
  if (begin > table.size()) throw Malformed("an offset is beyond the end of its table");
  return table.substr(begin);
}

/// Reads numbers one after the other. Every function throws Malformed where bytes are missing.
class BigEndian {
 public:
  explicit BigEndian(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw Malformed("its data end too early");
    const auto taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  /// An unsigned number of 1 to 4 bytes.
  std::uint32_t number(std::size_t bytes) {
    std::uint32_t value = 0;
    for (const char byte : take(bytes)) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
  }

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return number(4); }
  std::int8_t i8() { return static_cast<std::int8_t>(number(1)); }
  std::int16_t i16() { return static_cast<std::int16_t>(number(2)); }
  std::int32_t i32() { return static_cast<std::int32_t>(number(4)); }

 private:
  std::string_view rest_;
};

}  // namespace bezierbench::curves
