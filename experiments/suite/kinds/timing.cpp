// SPDX-License-Identifier: MIT
#include "experiments/suite/kinds/timing.hpp"

#include "experiments/suite/kinds.hpp"
#include "experiments/suite/kinds/key_checks.hpp"

namespace bezierbench::suite {
namespace {

constexpr std::array timing_fields{
    field<&TimingKeys::modes>(
        {.key = "modes",
         .meaning = "what one timed call does: one_shot prepares and evaluates one point, point evaluates one prepared "
                    "point, latency a chain of them, batch many t; companion problems are timed in one_shot only",
         .example = "[\"point\"]"}),
    field<&TimingKeys::order>(optional(order_key, "none; only methods of derivatives have it")),
    field<&TimingKeys::points>(optional(points_key, "none; only methods of interpolation and fitting have it")),
    field<&TimingKeys::tolerance>(
        optional(tolerance_key("tolerances, relative to the length for lengths, distances for fits", "[1e-3, 1e-6]"),
                 "none; only methods of lengths and fitting have it")),
    field<&TimingKeys::published>(published_key)};

Finding check_timing(const Study& study, const Vocabulary& known) {
  const auto& keys = keys_of<TimingKeys>(study);
  if (study.degree.empty() && keys.points.empty())
    return Fault{"degree", 0, {}, "degree is missing; kind \"timing\" needs it or points, add degree = [3, 5]"};
  if (auto found = each("modes", keys.modes, [](Mode) { return std::string(); })) return found;
  if (auto found = check_orders(keys.order)) return found;
  if (auto found = check_points(keys.points)) return found;
  if (auto found = check_tolerances(keys.tolerance)) return found;
  return check_published(keys.published, known);
}

}  // namespace

const Kind& TimingKeys::kind() {
  static constexpr Kind kind{.id = "timing",
                             .about = "time per evaluation or per answer to a companion problem",
                             .own = timing_fields,
                             .methods_example = "[\"de_casteljau\", \"horner_bernstein\"]",
                             .inputs = {.degree = DegreeUse::optional},
                             .timed = true,
                             .has_baseline = true,
                             .keys = default_keys<TimingKeys>,
                             .check = check_timing};
  return kind;
}

}  // namespace bezierbench::suite
