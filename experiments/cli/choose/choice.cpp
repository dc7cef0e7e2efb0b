// SPDX-License-Identifier: MIT
#include "experiments/cli/choose/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "experiments/cli/terminal/shell_word.hpp"
#include "experiments/number/number.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::cli {

std::string in_words(const DrawnClass& of) {
  return fmt::format("coordinates in [{0}, {1}], t in [{2}, {3}]", number::decimal(-of.range),
                     number::decimal(of.range), number::decimal(of.t.min), number::decimal(of.t.max));
}

std::string timed_curves(const JudgedRace& race) {
  auto text = fmt::format("{}: {}", race.group.study, in_words(race.of));
  return race.group.drawn.empty() ? text : fmt::format("{}, {}", text, race.group.drawn.back());
}

std::string remedy(const Wish& wish) {
  const auto form =
      std::ranges::find(suite::words<Form>, wish.form, [](const auto& entry) { return name(entry.value); });
  const bool in_quick = wish.mode == suite::name(suite::Mode::point) || wish.mode == suite::name(suite::Mode::one_shot);
  if (!in_quick && form->value == Form::rational) return "";
  const bool can_be_run = wish.degree >= 0 && wish.degree <= max_degree && wish.dimension >= 1 && wish.dimension <= 3;
  if (!can_be_run) return "";
  const std::string suite = in_quick ? "quick" : "speed";
  const std::string studies = fmt::format("{}*-{}{}", suite, form->word, in_quick ? "*" : "");
  std::string out = fmt::format("{}-{}", suite, wish.degree);
  while (std::filesystem::exists(out)) out += "-new";
  std::string set = fmt::format("--set degree={}", wish.degree);
  if (wish.range) set += fmt::format(" --set coordinate_range={}", number::decimal(*wish.range));
  if (wish.scalar != suite::name(suite::ScalarKind::float64)) set += " --set scalar=" + wish.scalar;
  if (constexpr int usual_dimension = 2; wish.dimension != usual_dimension)
    set += fmt::format(" --set dimension={}", wish.dimension);
  return fmt::format("; `{} run {} --only '{}' {} --out {}` makes a bundle that can", this_program(), suite, studies,
                     set, out);
}

}  // namespace bezierbench::cli
