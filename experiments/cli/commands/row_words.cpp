// SPDX-License-Identifier: MIT
#include "experiments/cli/commands/row_words.hpp"

#include <fmt/format.h>

#include <string_view>

#include "experiments/echo.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::cli {

std::string row_words(const compare::Inputs& inputs) {
  const suite::Study usual;
  std::string text = inputs.field("study");
  const auto add = [&](std::string_view label, std::string_view name, std::string_view left_out) {
    if (const auto& field = inputs.field(name); !field.empty() && field != left_out)
      text += fmt::format(", {}{}", label, field);
  };
  add("", "scalar", suite::name(usual.scalar.front()));
  add("", "mode", "");
  for (const std::string_view axis : {"degree", "order", "points", "tolerance"})
    add(fmt::format("{} ", axis), axis, "");
  add("dimension ", "dimension", std::to_string(usual.dimension.front()));
  add("R ", "coordinate_range", number::decimal(usual.coordinate_range.front()));
  add("", "generator", usual.generator.front());
  const auto& [low, high] = usual.t_interval.front();
  const auto& t_min = inputs.field("t_min");
  const auto& t_max = inputs.field("t_max");
  if (!t_min.empty() && (t_min != number::decimal(low) || t_max != number::decimal(high)))
    text += fmt::format(", t in [{}, {}]", t_min, t_max);
  add("against ", "baseline", usual.baseline.front());
  return printable(text);
}

}  // namespace bezierbench::cli
