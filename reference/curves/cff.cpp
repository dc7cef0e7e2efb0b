// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "reference/curves/font_tables.hpp"

namespace bezierbench::curves {
namespace {

constexpr std::size_t most_glyphs = 65'535;
constexpr std::size_t most_operands = 513;  // CFF2; CFF has 48
constexpr int most_calls = 10;

// Operators of DICTs.
constexpr int charset_key = 15, charstrings_key = 17, private_key = 18, subroutines_key = 19, variations_key = 22,
              variation_store_key = 24, charstring_type_key = 1206, fonts_key = 1236, font_select_key = 1237;

/// An operand of a charstring or a DICT that begins with a byte of 32 to 254.
double short_number(unsigned first, BigEndian& from) {
  if (first < 247) return static_cast<int>(first) - 139;
  const int low = from.u8();
  return first < 251 ? (static_cast<int>(first) - 247) * 256 + low + 108
                     : -(static_cast<int>(first) - 251) * 256 - low - 108;
}

std::size_t as_size(double value) {
  if (!(value >= 0 && value <= static_cast<double>(most_bytes)))
    throw Malformed("an offset or a count is out of range");
  return static_cast<std::size_t>(value);
}

}  // namespace

Cff::Index::Index(BigEndian& from, std::size_t count_bytes) : count_(from.number(count_bytes)) {
  if (count_ == 0) return;
  offset_bytes_ = from.u8();
  if (offset_bytes_ < 1 || offset_bytes_ > 4) throw Malformed("an INDEX has offsets of a size other than 1 to 4 bytes");
  offsets_ = from.take((count_ + 1) * offset_bytes_);
  data_ = from.take(offset(count_));
}

std::size_t Cff::Index::offset(std::size_t k) const {
  const std::size_t from_one = BigEndian(offsets_.substr(k * offset_bytes_)).number(offset_bytes_);
  if (from_one == 0) throw Malformed("an INDEX has an offset of 0");
  return from_one - 1;
}

std::string_view Cff::Index::operator[](std::size_t k) const {
  const std::size_t begin = offset(k);
  const std::size_t end = offset(k + 1);
  if (begin > end || end > data_.size()) throw Malformed("the offsets of an INDEX do not increase");
  return data_.substr(begin, end - begin);
}

Cff::Dict Cff::dict(std::string_view data) {
  Dict dict;
  std::vector<double> operands;
  for (BigEndian from(data); !from.empty();) {
    const unsigned byte = from.u8();
    if (byte == 28) {
      operands.push_back(from.i16());
    } else if (byte == 29) {
      operands.push_back(from.i32());
    } else if (byte == 30) {  // decimal digits, up to one that is 15: no such number is used
      for (unsigned digits = 0; (digits & 0xfU) != 0xf && digits >> 4U != 0xf;) digits = from.u8();
      operands.push_back(0);
    } else if (byte >= 32) {
      operands.push_back(short_number(byte, from));
    } else {
      dict[byte == 12 ? 1200 + from.u8() : static_cast<int>(byte)] = operands;
      operands.clear();
    }
  }
  return dict;
}

BigEndian Cff::from(const Dict& dict, int key, std::size_t operand) const {
  const auto found = dict.find(key);
  if (found == dict.end() || found->second.size() <= operand)
    throw Malformed(fmt::format("a DICT has no operator {}", key < 1200 ? key : key - 1200));
  return BigEndian(bytes_from(table_, as_size(found->second[operand])));
}

Cff::Cff(std::string_view table, bool is_cff2) : table_(table), is_cff2_(is_cff2) {
  BigEndian header(table);
  header.take(2);
  const std::size_t header_size = header.u8();
  const std::size_t count_bytes = is_cff2 ? 4 : 2;
  Dict top;
  BigEndian from(bytes_from(table, header_size));
  if (is_cff2) {
    top = dict(from.take(header.u16()));
  } else {
    Index(from, count_bytes);  // names of fonts
    const Index tops(from, count_bytes);
    if (tops.size() != 1) throw Malformed("it does not have one Top DICT");
    top = dict(tops[0]);
    Index(from, count_bytes);  // strings
  }
  subroutines_ = Index(from, count_bytes);
  if (top.contains(charstring_type_key) && top[charstring_type_key] != std::vector{2.0})
    throw Malformed("its charstrings are not of Type 2");
  auto at = this->from(top, charstrings_key);
  charstrings_ = Index(at, count_bytes);
  if (charstrings_.size() > most_glyphs) throw Malformed(fmt::format("it has more than {} glyphs", most_glyphs));
  if (top.contains(fonts_key)) {
    at = this->from(top, fonts_key);
    const Index fonts(at, count_bytes);
    if (fonts.size() > most_glyphs) throw Malformed(fmt::format("it has more than {} fonts", most_glyphs));
    for (std::size_t k = 0; k < fonts.size(); ++k) privates_.push_back(private_of(dict(fonts[k])));
    if (top.contains(font_select_key)) read_font_of_glyph(this->from(top, font_select_key));
  } else {
    privates_.push_back(private_of(top));
  }
  if (is_cff2 && top.contains(variation_store_key)) read_regions(this->from(top, variation_store_key));
  if (!is_cff2 && !top.contains(fonts_key)) read_charset(top);
}

Cff::Private Cff::private_of(const Dict& dict) const {
  const auto found = dict.find(private_key);
  if (found == dict.end()) return {};
  auto data = from(dict, private_key, 1);
  const Dict own = Cff::dict(data.take(as_size(found->second[0])));
  Private result;
  if (const auto subroutines = own.find(subroutines_key); subroutines != own.end() && !subroutines->second.empty()) {
    BigEndian at(bytes_from(table_, as_size(found->second[1] + subroutines->second[0])));
    result.subroutines = Index(at, is_cff2_ ? 4 : 2);
  }
  if (const auto variations = own.find(variations_key); variations != own.end() && !variations->second.empty())
    result.variations = as_size(variations->second[0]);
  return result;
}

void Cff::read_font_of_glyph(BigEndian from) {
  const int format = from.u8();
  const std::size_t glyphs = charstrings_.size();
  if (format == 0) {
    for (std::size_t glyph = 0; glyph < glyphs; ++glyph) font_of_glyph_.push_back(from.u8());
  } else if (format == 3 || format == 4) {
    const std::size_t size = format == 3 ? 2 : 4;
    const std::size_t ranges = from.number(size);
    std::size_t begin = from.number(size);
    for (std::size_t k = 0; k < ranges; ++k) {
      const auto font = static_cast<std::uint16_t>(from.number(size / 2));
      const std::size_t end = from.number(size);
      if (begin != font_of_glyph_.size() || end <= begin || end > glyphs)
        throw Malformed("the ranges of its FDSelect do not increase");
      font_of_glyph_.resize(end, font);
      begin = end;
    }
  } else {
    throw Malformed(fmt::format("its FDSelect has the unknown format {}", format));
  }
  if (font_of_glyph_.size() != glyphs) throw Malformed("its FDSelect does not name every glyph");
}

/// The item variation store, of which the numbers of regions are used.
void Cff::read_regions(BigEndian from) {
  from.take(2);  // its length
  const auto store = from.rest();
  from.take(6);  // format and the list of regions
  const std::size_t count = from.u16();
  for (std::size_t k = 0; k < count; ++k)
    regions_.push_back(BigEndian(bytes_from(bytes_from(store, from.u32()), 4)).u16());
}

void Cff::read_charset(const Dict& top) {
  const std::size_t glyphs = charstrings_.size();
  const auto found = top.find(charset_key);
  const double offset = found == top.end() || found->second.empty() ? 0 : found->second[0];
  names_.resize(std::min<std::size_t>(glyphs, 1));
  if (offset == 0) {  // ISOAdobe
    names_.resize(std::min<std::size_t>(glyphs, 229));
    std::iota(names_.begin(), names_.end(), std::uint16_t{0});
  } else if (offset > 2) {  // 1 and 2 are Expert and ExpertSubset, which have no letters
    BigEndian from(bytes_from(table_, as_size(offset)));
    const std::size_t format = from.u8();
    while (names_.size() < glyphs) {
      auto name = from.u16();
      const std::size_t more = format == 0 ? 0 : from.number(format == 1 ? 1 : 2);
      for (std::size_t k = 0; k <= more && names_.size() < glyphs; ++k) names_.push_back(name++);
    }
  }
}

std::size_t Cff::standard_glyph(double code) const {
  // Ranges of codes, first and count; the string identifiers of these codes are consecutive, from 1.
  static constexpr std::array encoded{32,  95, 161, 15, 177, 4, 182, 8, 191, 1, 193, 8, 202, 2,
                                      205, 4,  225, 1,  227, 1, 232, 4, 241, 1, 245, 1, 248, 4};
  int name = 1;
  for (std::size_t k = 0; k < encoded.size(); k += 2) {
    if (code >= encoded[k] && code < encoded[k] + encoded[k + 1]) {
      const auto found = std::ranges::find(names_, name + static_cast<int>(code) - encoded[k]);
      if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    }
    name += encoded[k + 1];
  }
  throw Malformed(fmt::format("its part with the code {} of the standard encoding does not exist", code));
}

/// Executes a charstring.
class Cff::Charstring {
 public:
  Charstring(const Cff& cff, const Private& font, Coordinates origin, bool is_part, Outline& outline)
      : cff_(cff), private_(font), at_(origin), is_part_(is_part), outline_(outline), variations_(font.variations) {
    has_width_ = cff.is_cff2_;
  }

  void run(std::string_view program, int calls);

 private:
  using Operands = std::span<const double>;

  void operate(unsigned op, BigEndian& from, int calls);
  void operate_escaped(unsigned op);
  void push(double value);
  double pop();
  void call(const Index& subroutines, int calls);
  /// Removes the width, which precedes the operands of the first operator, where their number is not as even or odd as
  /// without it.
  void take_width(bool odd);
  void expect(bool holds) const;
  void count_hints();
  void blend();
  void end();

  void move(double dx, double dy);
  Coordinates next(double dx, double dy) { return at_ = {at_.x + dx, at_.y + dy}; }
  void line(double dx, double dy);
  void curve(const std::array<double, 6>& d);
  void lines(Operands d);
  void curves(Operands d);
  void axis_lines(bool horizontal);
  void axis_curves(bool horizontal);
  void tangent_curves(bool horizontal);

  const Cff& cff_;
  const Private& private_;
  Coordinates at_;
  bool is_part_;  ///< of a glyph that endchar composes
  Outline& outline_;
  std::size_t variations_;
  std::vector<double> operands_;
  std::size_t hints_ = 0;
  std::size_t mask_bytes_ = 0;
  bool has_width_;
  bool has_ended_ = false;
};

void Cff::draw(std::size_t glyph, Outline& outline) const {
  const std::size_t font = font_of_glyph_.empty() ? 0 : font_of_glyph_[glyph];
  if (font >= privates_.size()) throw Malformed(fmt::format("its font {} does not exist", font));
  Charstring(*this, privates_[font], {}, false, outline).run(charstrings_[glyph], 0);
  outline.close();
}

void Cff::Charstring::run(std::string_view program, int calls) {
  if (calls > most_calls) throw Malformed(fmt::format("its subroutines are nested more than {} deep", most_calls));
  for (BigEndian from(program); !from.empty() && !has_ended_;) {
    outline_.spend(1);
    const unsigned byte = from.u8();
    if (byte == 28)
      push(from.i16());
    else if (byte == 255)
      push(from.i32() / 65536.0);
    else if (byte >= 32)
      push(short_number(byte, from));
    else if (byte == 11)  // return
      return;
    else
      operate(byte, from, calls);
  }
}

void Cff::Charstring::operate(unsigned op, BigEndian& from, int calls) {
  const auto size = operands_.size();
  const Operands d = operands_;
  switch (op) {
    case 10: return call(private_.subroutines, calls);
    case 29: return call(cff_.subroutines_, calls);
    case 12: return operate_escaped(from.u8());
    case 16: return blend();
    case 1:
    case 3:
    case 18:
    case 23: count_hints(); break;
    case 19:
    case 20:
      if (mask_bytes_ == 0) {
        count_hints();
        mask_bytes_ = (hints_ + 7) / 8;
      }
      from.take(mask_bytes_);
      break;
    case 4:
      take_width(true);
      expect(operands_.size() == 1);
      move(0, operands_[0]);
      break;
    case 5: lines(d); break;
    case 6: axis_lines(true); break;
    case 7: axis_lines(false); break;
    case 8: curves(d); break;
    case 14: end(); break;
    case 15: variations_ = as_size(pop()); break;
    case 21:
      take_width(false);
      expect(operands_.size() == 2);
      move(operands_[0], operands_[1]);
      break;
    case 22:
      take_width(true);
      expect(operands_.size() == 1);
      move(operands_[0], 0);
      break;
    case 24:
      expect(size >= 2);
      curves(d.first(size - 2));
      lines(d.last(2));
      break;
    case 25:
      expect(size >= 6);
      lines(d.first(size - 6));
      curves(d.last(6));
      break;
    case 26: tangent_curves(false); break;
    case 27: tangent_curves(true); break;
    case 30: axis_curves(false); break;
    case 31: axis_curves(true); break;
    default: throw Malformed(fmt::format("its charstring has the operator {}, which Type 2 does not have", op));
  }
  operands_.clear();
}

void Cff::Charstring::operate_escaped(unsigned op) {
  const auto& d = operands_;
  switch (op) {
    case 0: break;  // dotsection, which has no effect
    case 12: {
      const double divisor = pop();
      const double dividend = pop();
      if (!std::isfinite(dividend / divisor)) throw Malformed("its charstring divides by a number that is too small");
      return push(dividend / divisor);
    }
    case 34:  // hflex
      expect(d.size() == 7);
      curve({d[0], 0, d[1], d[2], d[3], 0});
      curve({d[4], 0, d[5], -d[2], d[6], 0});
      break;
    case 35:  // flex
      expect(d.size() == 13);
      curves(Operands(d).first(12));
      break;
    case 36:  // hflex1
      expect(d.size() == 9);
      curve({d[0], d[1], d[2], d[3], d[4], 0});
      curve({d[5], 0, d[6], d[7], d[8], -(d[1] + d[3] + d[7])});
      break;
    case 37: {  // flex1: its last operand is along the axis on which its ends are farther from each other
      expect(d.size() == 11);
      const double dx = d[0] + d[2] + d[4] + d[6] + d[8];
      const double dy = d[1] + d[3] + d[5] + d[7] + d[9];
      const bool horizontal = std::abs(dx) > std::abs(dy);
      curve({d[0], d[1], d[2], d[3], d[4], d[5]});
      curve({d[6], d[7], d[8], d[9], horizontal ? d[10] : -dx, horizontal ? -dy : d[10]});
      break;
    }
    default: throw Malformed(fmt::format("its charstring has the operator 12 {}, which is not supported", op));
  }
  operands_.clear();
}

void Cff::Charstring::push(double value) {
  if (operands_.size() == most_operands) throw Malformed("its charstring has too many operands");
  operands_.push_back(value);
}

double Cff::Charstring::pop() {
  expect(!operands_.empty());
  const double value = operands_.back();
  operands_.pop_back();
  return value;
}

void Cff::Charstring::call(const Index& subroutines, int calls) {
  const int bias = subroutines.size() < 1240 ? 107 : subroutines.size() < 33'900 ? 1131 : 32'768;
  const double number = pop() + bias;
  if (!(number >= 0 && number < static_cast<double>(subroutines.size())))
    throw Malformed(fmt::format("its charstring calls subroutine {}, which does not exist", number));
  run(subroutines[static_cast<std::size_t>(number)], calls + 1);
}

void Cff::Charstring::take_width(bool odd) {
  if (!has_width_ && (operands_.size() % 2 == 1) != odd && !operands_.empty()) operands_.erase(operands_.begin());
  has_width_ = true;
}

void Cff::Charstring::expect(bool holds) const {
  if (!holds) throw Malformed("an operator of its charstring has a wrong number of operands");
}

void Cff::Charstring::count_hints() {
  take_width(false);
  hints_ += operands_.size() / 2;
}

/// Of n default values and their changes in each region the default values remain.
void Cff::Charstring::blend() {
  const std::size_t values = as_size(pop());
  if (variations_ >= cff_.regions_.size())
    throw Malformed(fmt::format("its charstring uses the variations {}, which do not exist", variations_));
  const std::size_t changes = values * cff_.regions_[variations_];
  expect(operands_.size() >= values + changes);
  operands_.resize(operands_.size() - changes);
}

void Cff::Charstring::end() {
  take_width(false);
  has_ended_ = true;
  if (operands_.empty()) return;
  expect(operands_.size() == 4);
  if (is_part_) throw Malformed("a part of it is composed of parts itself");
  const std::array parts{std::pair{Coordinates{}, operands_[2]},
                         std::pair{Coordinates{operands_[0], operands_[1]}, operands_[3]}};
  for (const auto& [origin, code] : parts)
    Charstring(cff_, private_, origin, true, outline_).run(cff_.charstrings_[cff_.standard_glyph(code)], 0);
}

void Cff::Charstring::move(double dx, double dy) { outline_.move_to(next(dx, dy)); }

void Cff::Charstring::line(double dx, double dy) {
  if (!outline_.is_open()) move(0, 0);
  outline_.line_to(next(dx, dy));
}

void Cff::Charstring::curve(const std::array<double, 6>& d) {
  if (!outline_.is_open()) move(0, 0);
  const auto first = next(d[0], d[1]);
  const auto second = next(d[2], d[3]);
  outline_.cubic_to(first, second, next(d[4], d[5]));
}

void Cff::Charstring::lines(Operands d) {
  expect(d.size() % 2 == 0);
  for (std::size_t k = 0; k < d.size(); k += 2) line(d[k], d[k + 1]);
}

void Cff::Charstring::curves(Operands d) {
  expect(d.size() % 6 == 0);
  for (std::size_t k = 0; k < d.size(); k += 6) curve({d[k], d[k + 1], d[k + 2], d[k + 3], d[k + 4], d[k + 5]});
}

/// hlineto, vlineto: horizontal and vertical lines alternately.
void Cff::Charstring::axis_lines(bool horizontal) {
  for (const double d : operands_) {
    line(horizontal ? d : 0, horizontal ? 0 : d);
    horizontal = !horizontal;
  }
}

/// hvcurveto, vhcurveto: curves that begin horizontally and end vertically, and the reverse, alternately. The last one
/// may have an operand more, for the other coordinate of its end.
void Cff::Charstring::axis_curves(bool horizontal) {
  const Operands d = operands_;
  expect(d.size() >= 4 && d.size() % 4 <= 1);
  for (std::size_t k = 0; k + 4 <= d.size(); k += 4) {
    const double other = k + 5 == d.size() ? d[k + 4] : 0;
    if (horizontal)
      curve({d[k], 0, d[k + 1], d[k + 2], other, d[k + 3]});
    else
      curve({0, d[k], d[k + 1], d[k + 2], d[k + 3], other});
    horizontal = !horizontal;
  }
}

/// hhcurveto, vvcurveto: curves that begin and end along one axis. The first one may have an operand more, before the
/// others, for the other coordinate of its first control point.
void Cff::Charstring::tangent_curves(bool horizontal) {
  const std::size_t more = operands_.size() % 2;
  const Operands d = Operands(operands_).subspan(more);
  expect(d.size() % 4 == 0);
  for (std::size_t k = 0; k < d.size(); k += 4) {
    const double other = k == 0 && more == 1 ? operands_[0] : 0;
    if (horizontal)
      curve({d[k], other, d[k + 1], d[k + 2], d[k + 3], 0});
    else
      curve({other, d[k], d[k + 1], d[k + 2], 0, d[k + 3]});
  }
}

}  // namespace bezierbench::curves
