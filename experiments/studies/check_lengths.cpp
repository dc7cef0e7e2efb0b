// SPDX-License-Identifier: MIT
#include "experiments/studies/check_lengths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"
#include "experiments/number/number.hpp"

namespace bezierbench::studies {

void check_lengths(const suite::Study& study, std::string_view interval) {
  const auto refuse = [&](const std::string& what) {
    throw Failure(Exit::usage, fmt::format("study \"{}\": {}", study.id, what));
  };
  if (study.curve != suite::CurveKind::bezier)
    refuse("lengths are those of polynomial Bezier curves; write curve = \"bezier\"");
  if (std::ranges::any_of(study.scalar, [](auto scalar) { return scalar != suite::ScalarKind::float64; }))
    refuse("lengths are computed in double only; leave scalar out");
  for (const auto& t : study.t_interval)
    if (t.min < 0 || t.max > 1)
      refuse(fmt::format("t_interval {}:{} is {} and must be within 0 and 1", number::decimal(t.min),
                         number::decimal(t.max), interval));
}

}  // namespace bezierbench::studies
