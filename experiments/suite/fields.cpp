// SPDX-License-Identifier: MIT
#include "experiments/suite/fields.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include "experiments/suite/toml_value.hpp"

namespace bezierbench::suite {
namespace {

template <auto Member>
void read_member(std::string_view source, std::string_view key, const toml::node& node, Study& out) {
  read({source, key}, node, out.*Member);
}

/// True for a number that is not an axis.
template <auto Member>
constexpr bool is_count = std::is_same_v<std::remove_cvref_t<decltype(std::declval<Study>().*Member)>, std::int64_t>;

template <auto Member>
std::string write_member(const Study& study) {
  if constexpr (requires { (study.*Member).empty(); }) {
    if ((study.*Member).empty()) return {};  // left out means: does not apply, or for methods, all that apply
  }
  if constexpr (is_count<Member>) {
    if (study.*Member == 0) return {};  // a count of nothing likewise
  }
  return to_text(study.*Member);
}

template <auto Member>
constexpr Field field(std::string_view key, bool settable) {
  return {key, &read_member<Member>, &write_member<Member>, settable, is_count<Member>};
}

template <auto Member>
constexpr Field axis_of_cells(std::string_view key) {
  return {key, &read_member<Member>, &write_member<Member>, true, false, true};
}

/// One baseline may be written without brackets.
void read_baseline(std::string_view source, std::string_view key, const toml::node& node, Study& out) {
  if (!node.is_string()) return read({source, key}, node, out.baseline);
  out.baseline.resize(1);
  read({source, key}, node, out.baseline.front());
}

constexpr std::array fields{field<&Study::id>("id", false),
                            field<&Study::title>("title", false),
                            field<&Study::kind>("kind", false),
                            field<&Study::curve>("curve", false),
                            axis_of_cells<&Study::dimension>("dimension"),
                            axis_of_cells<&Study::degree>("degree"),
                            axis_of_cells<&Study::coordinate_range>("coordinate_range"),
                            axis_of_cells<&Study::t_interval>("t_interval"),
                            axis_of_cells<&Study::generator>("generator"),
                            axis_of_cells<&Study::scalar>("scalar"),
                            field<&Study::methods>("methods", true),
                            field<&Study::trials>("trials", true),
                            field<&Study::replicates>("replicates", true),
                            Field{"baseline", &read_baseline, &write_member<&Study::baseline>, true},
                            field<&Study::decomposed_trials>("decomposed_trials", true),
                            field<&Study::budget>("budget", true),
                            field<&Study::modes>("modes", true),
                            field<&Study::order>("order", true),
                            field<&Study::points>("points", true),
                            field<&Study::tolerance>("tolerance", true),
                            field<&Study::goals>("goals", false),
                            field<&Study::published>("published", false)};

}  // namespace

std::span<const Field> study_fields() { return fields; }

const Field* find_field(std::string_view key) {
  for (const Field& field : fields) {
    if (field.key == key) return &field;
  }
  return nullptr;
}

}  // namespace bezierbench::suite
