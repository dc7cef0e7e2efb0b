// SPDX-License-Identifier: MIT
#include "reference/curves/curve_set.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <optional>

namespace bezierbench::curves {
namespace {

/// The text before the number at the end of an id.
std::string_view stem_of(std::string_view id) { return id.substr(0, id.find_last_not_of("0123456789") + 1); }

/// Whether the number `next`, in decimal digits, is one more than `last`.
bool counts_on(std::string_view last, std::string_view next) {
  const auto value = [](std::string_view digits) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(number) : std::nullopt;
  };
  const auto from = value(last);
  const auto to = value(next);
  return from && to && *to == *from + 1;
}

}  // namespace

void CurveSet::add(std::string_view id, const CurveView<double>& curve, bool begins_path,
                   std::span<const double> parameters) {
  curves_.push_back({.numbers = numbers_.size(),
                     .id = ids_.size(),
                     .id_size = static_cast<std::uint32_t>(id.size()),
                     .degree = static_cast<std::uint16_t>(curve.degree),
                     .parameters = static_cast<std::uint16_t>(parameters.size()),
                     .form = curve.form,
                     .dimension = static_cast<std::uint8_t>(curve.dimension),
                     .begins_path = begins_path});
  ids_ += id;
  numbers_.insert(numbers_.end(), curve.coefficients.begin(), curve.coefficients.end());
  numbers_.insert(numbers_.end(), curve.weights.begin(), curve.weights.end());
  numbers_.insert(numbers_.end(), parameters.begin(), parameters.end());
}

CurveView<double> CurveSet::operator[](std::size_t k) const {
  const Entry& entry = curves_[k];
  const std::size_t count = entry.degree + std::size_t{1};
  const auto numbers = std::span(numbers_).subspan(entry.numbers);
  const std::size_t weights = entry.form == Form::rational ? count : 0;
  return {entry.form, entry.dimension, entry.degree, numbers.first(count * entry.dimension),
          numbers.subspan(count * entry.dimension, weights)};
}

std::string_view CurveSet::id(std::size_t k) const {
  return std::string_view(ids_).substr(curves_[k].id, curves_[k].id_size);
}

std::span<const double> CurveSet::parameters(std::size_t k) const {
  const auto curve = (*this)[k];
  return std::span(numbers_).subspan(curves_[k].numbers + curve.coefficients.size() + curve.weights.size(),
                                     curves_[k].parameters);
}

bool CurveSet::continues_path(std::string_view id, const CurveView<double>& curve) const {
  if (empty()) return false;
  const auto last = (*this)[size() - 1];
  const auto last_id = this->id(size() - 1);
  if (last.form == Form::power || curve.form == Form::power || last.dimension != curve.dimension) return false;
  const auto d = static_cast<std::size_t>(curve.dimension);
  const auto stem = stem_of(id);
  return std::ranges::equal(last.coefficients.last(d), curve.coefficients.first(d)) && stem == stem_of(last_id) &&
         counts_on(last_id.substr(stem.size()), id.substr(stem.size()));
}

std::size_t CurveSet::find(std::string_view id_or_number) const {
  for (std::size_t k = 0; k < size(); ++k)
    if (id(k) == id_or_number) return k;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(id_or_number.data(), id_or_number.data() + id_or_number.size(), number);
  const bool is_number = error == std::errc() && end == id_or_number.data() + id_or_number.size();
  return is_number && number < size() ? number : size();
}

std::string CurveSet::canonical_bytes() const {
  std::string bytes;
  const auto put = [&](std::uint64_t value) {
    for (std::size_t k = 0; k < sizeof value; ++k, value >>= 8U) bytes += static_cast<char>(value & 0xffU);
  };
  for (std::size_t k = 0; k < size(); ++k) {
    const auto curve = (*this)[k];
    for (const char c : name(curve.form)) bytes += c;
    put(static_cast<std::uint64_t>(curve.dimension));
    put(static_cast<std::uint64_t>(curve.degree));
    put(parameters(k).size());
    for (const auto numbers : {curve.coefficients, curve.weights, parameters(k)})
      for (const double value : numbers) put(std::bit_cast<std::uint64_t>(value));
  }
  return bytes;
}

}  // namespace bezierbench::curves
