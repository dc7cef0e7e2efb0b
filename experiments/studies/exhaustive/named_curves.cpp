// SPDX-License-Identifier: MIT
#include "experiments/studies/exhaustive/named_curves.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "experiments/bundle/csv.hpp"
#include "reference/number/number.hpp"

namespace bezierbench::studies {
namespace {

std::vector<float> numbers(std::string_view text) {
  std::vector<float> all;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    const auto number = number::parse_number(text.substr(0, end));
    if (!number) throw std::logic_error(fmt::format("named_curves.csv: no number: {}", text.substr(0, end)));
    all.push_back(static_cast<float>(*number));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

std::vector<NamedCurve> parsed() {
  const auto table = bundle::parse_csv(named_curves_text(), "named_curves.csv");
  std::vector<NamedCurve> all;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto dimension = number::parse_integer(table.at(row, "dimension"));
    auto points = numbers(table.at(row, "control_points"));
    const auto& id = table.at(row, "curve_id");
    if (!dimension || *dimension < 1 || *dimension > 3 || points.empty() ||
        points.size() % static_cast<std::size_t>(*dimension) != 0)
      throw std::logic_error(fmt::format("named_curves.csv: {} has no whole points", id));
    all.push_back({id, static_cast<int>(*dimension), std::move(points)});
  }
  return all;
}

}  // namespace

std::vector<float> NamedCurve::axis(int axis) const {
  std::vector<float> coordinates;
  for (int i = 0; i <= degree(); ++i) coordinates.push_back(view()(axis, i));
  return coordinates;
}

const std::vector<NamedCurve>& named_curves() {
  static const auto all = parsed();
  return all;
}

}  // namespace bezierbench::studies
