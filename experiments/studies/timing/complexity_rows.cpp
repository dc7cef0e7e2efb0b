// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/complexity_rows.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "experiments/metric/growth.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/number/number.hpp"
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
  std::vector<std::string> columns{"study",         "curve",        "method",      "scalar",   "dimension",
                                   "mode",          "first_degree", "last_degree", "exponent", "exponent_low",
                                   "exponent_high", "claimed",      "verdict"};
  columns.insert(columns.end(), tables::drawn_columns().begin(), tables::drawn_columns().end());
  columns.insert(columns.end(), {"first_points", "last_points"});
  auto& table = tables.table("complexity.csv", columns);
  for (const auto& ladder : ladders_of(race_cells, size)) {
    const auto fitted = metric::growth(ladder.sizes, ladder.ns, metric::timing_confidence);
    if (!fitted) continue;
    const int claimed = claimed_exponent(*ladder.method, ladder.first->mode);
    const auto [least, most] = std::ranges::minmax(ladder.sizes);
    const bool of_points = size == race::Size::points;
    const auto degree = std::to_string(ladder.first->cell.degree);
    std::vector<std::string> row{study.id,
                                 std::string(suite::name(study.curve)),
                                 std::string(ladder.method->id),
                                 std::string(suite::name(ladder.first->scalar)),
                                 std::to_string(ladder.first->cell.dimension),
                                 std::string(suite::name(ladder.first->mode)),
                                 of_points ? degree : number::decimal(least),
                                 of_points ? degree : number::decimal(most),
                                 number::decimal(fitted->exponent),
                                 number::decimal(fitted->low),
                                 number::decimal(fitted->high),
                                 std::to_string(claimed),
                                 std::string(metric::name(metric::verdict(*fitted, claimed)))};
    for (auto& field : tables::drawn_fields(ladder.first->cell)) row.push_back(std::move(field));
    row.push_back(of_points ? number::decimal(least) : "");
    row.push_back(of_points ? number::decimal(most) : "");
    table.add_row(std::move(row));
  }
}

}  // namespace bezierbench::studies
