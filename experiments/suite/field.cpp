// SPDX-License-Identifier: MIT
#include "experiments/suite/field.hpp"

#include "experiments/suite/kind.hpp"
#include "experiments/suite/text/toml_value.hpp"

namespace bezierbench::suite {
namespace {

template <class T>
bool says_nothing(const T& value) {
  if constexpr (requires { value.empty(); })
    return value.empty();
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return value == 0;
  else if constexpr (std::is_same_v<T, Counting>)
    return value == Counting::none;
  else
    return false;
}

template <class T>
std::size_t count(const T& /*value*/) {
  return 1;
}
template <class T>
std::size_t count(const std::vector<T>& values) {
  return values.empty() ? 1 : values.size();
}

}  // namespace

bool is_empty(const Field& field, const Study& study) {
  return std::visit([](const auto* value) { return says_nothing(*value); }, field.value(study));
}

std::size_t sweep_length(const Field& field, const Study& study) {
  if (field.axis == Axis::none) return 1;
  return std::visit([](const auto* value) { return count(*value); }, field.value(study));
}

std::string to_text(const Field& field, const Study& study) {
  if (is_empty(field, study)) return {};  // a key left out does not apply, or means all methods that apply
  return std::visit([](const auto* value) { return to_text(*value); }, field.value(study));
}

}  // namespace bezierbench::suite
