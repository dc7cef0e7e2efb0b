// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/complexity_rows.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "experiments/metric/growth.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {
namespace {

/// The times of one method over the sizes.
struct Ladder {
  const race::RaceCell* first;  ///< its race cells differ in the size only
  const MethodInfo* method;
  std::vector<double> sizes;
  std::vector<double> ns;
};

double size_of(const race::RaceCell& race_cell, race::Size size) {
  return size == race::Size::points ? *race_cell.case_values.points : race_cell.cell.degree;
}

/// In the order in which their first race cells ran.
std::vector<Ladder> ladders_of(const std::vector<race::RaceCell>& race_cells, race::Size size) {
  std::vector<Ladder> ladders;
  std::map<std::tuple<suite::ScalarKind, int, suite::Mode, std::vector<std::string>, const MethodInfo*>, std::size_t>
      places;
  for (const auto& race_cell : race_cells)
    for (std::size_t m = 0; m < race_cell.methods.size() && !race_cell.laps.empty(); ++m) {
      const auto [place, is_new] = places.try_emplace({race_cell.scalar, race_cell.cell.dimension, race_cell.mode,
                                                       tables::drawn_fields(race_cell.cell), race_cell.methods[m]},
                                                      ladders.size());
      if (is_new) ladders.push_back({&race_cell, race_cell.methods[m], {}, {}});
      Ladder& ladder = ladders[place->second];
      ladder.sizes.push_back(size_of(race_cell, size));
      ladder.ns.push_back(metric::median_interval(race_cell.laps[m].repetition_ns(), metric::timing_confidence).median);
    }
  return ladders;
}

int claimed_exponent(const MethodInfo& method, suite::Mode mode) {
  return mode == suite::Mode::one_shot ? std::max(method.cost_exponent, method.prepare_exponent) : method.cost_exponent;
}

}  // namespace

void write_complexity_rows(const suite::Study& study, const std::vector<race::RaceCell>& race_cells, race::Size size,
                           tables::Tables& tables) {
  if (size == race::Size::unclaimed) return;
  (void)tables.table("complexity.csv");
  for (const auto& ladder : ladders_of(race_cells, size)) {
    const auto fitted = metric::growth(ladder.sizes, ladder.ns, metric::timing_confidence);
    if (!fitted) continue;
    const int claimed = claimed_exponent(*ladder.method, ladder.first->mode);
    const auto [least, most] = std::ranges::minmax(ladder.sizes);
    const bool of_points = size == race::Size::points;
    const auto& first = *ladder.first;
    tables::Row row("complexity.csv");
    row.set("study", study.id)
        .set("curve", suite::name(study.curve))
        .set("method", ladder.method->id)
        .set("scalar", suite::name(first.scalar))
        .set("dimension", first.cell.dimension)
        .set("mode", suite::name(first.mode))
        .set("exponent", fitted->exponent)
        .set("exponent_low", fitted->low)
        .set("exponent_high", fitted->high)
        .set("claimed", claimed)
        .set("verdict", metric::name(metric::verdict(*fitted, claimed)))
        .set_each(tables::drawn_columns(), tables::drawn_fields(first.cell));
    if (of_points)
      row.set("first_degree", first.cell.degree)
          .set("last_degree", first.cell.degree)
          .set("first_points", least)
          .set("last_points", most);
    else
      row.set("first_degree", least).set("last_degree", most);
    tables.add(row);
  }
}

}  // namespace bezierbench::studies
