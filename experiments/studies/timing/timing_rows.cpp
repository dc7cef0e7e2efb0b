// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timing_rows.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/growth.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"
#include "experiments/race/limit.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/tables/cell_fields.hpp"

namespace bezierbench::studies {

namespace {

constexpr std::string_view ok = "ok";
constexpr std::string_view noisy = "noisy";

std::string_view quality(const race::RaceCell& race_cell, const race::RaceCellLap& lap, const race::Pace& fastest) {
  return race::drifted(race_cell.laps, fastest) || race::repetitions_disagree(lap) ? noisy : ok;
}

/// Median and interval of a sample, in NAME of `names`.
void set_interval(tables::Row& row, const std::array<std::string_view, 3>& names, std::span<const double> sample) {
  const auto interval = metric::median_interval(sample, metric::timing_confidence);
  row.set(names[0], interval.median).set(names[1], interval.low).set(names[2], interval.high);
}

std::vector<double> quotients(std::span<const double> a, std::span<const double> b) {
  std::vector<double> all;
  for (std::size_t k = 0; k < a.size(); ++k) all.push_back(a[k] / b[k]);
  return all;
}

/// Over repetitions, of each of which the ratio is taken round by round.
void set_ratio(tables::Row& row, const race::RaceCell& race_cell, const race::RaceCellLap& lap, std::size_t base) {
  row.set("relative_to", race_cell.methods[base]->id);
  set_interval(row, {"ratio", "ratio_low", "ratio_high"},
               race::repetition_ratios(lap.repetitions, race_cell.laps[base].repetitions));
}

void set_median(tables::Row& row, std::string_view column, std::span<const double> counts) {
  if (!counts.empty()) row.set(column, metric::median_interval(counts, metric::timing_confidence).median);
}

/// Empty for an external method, whose operations are not known.
std::optional<race::TimedWork> work_of(const race::RaceCell& race_cell, const MethodInfo& method) {
  return judge::with_scalar(race_cell.scalar, [&]<class Scalar>(Scalar /*zero*/) -> std::optional<race::TimedWork> {
    const auto* kernel = judge::find_method<Scalar>(method.id, method.form, race_cell.cell.dimension);
    if (kernel == nullptr) return std::nullopt;
    return race::TimedWork{kernel->evaluator, kernel->conversion, race_cell.cell.degree, race_cell.cell.dimension};
  });
}

/// What an empty kernel took beside a method, and how near to the limit of the processor the rest of its time is.
void set_limit(tables::Row& row, const race::RaceCell& race_cell, std::size_t m, const race::ProcessorTimes& times) {
  const auto* const call = race::call_of(race_cell);
  if (call == nullptr) return;
  const double call_ns = metric::median(call->repetition_ns());
  row.set("call_ns", call_ns);
  const auto work = work_of(race_cell, *race_cell.methods[m]);
  if (!work) return;
  const auto limit = race::limit(*work, race_cell.mode, times);
  if (!limit) return;
  const double ns = metric::median(race_cell.laps[m].repetition_ns());
  row.set("limit_ns", limit->ns)
      .set("share_of_limit", race::share_of_limit(limit->ns, ns, call_ns))
      .set("chain_ns", limit->chain_ns);
}

tables::Row key_row(const suite::Study& study, const race::RaceCell& race_cell, std::size_t method) {
  tables::Row row("timing.csv");
  row.set("study", study.id)
      .set("curve", suite::name(study.curve))
      .set("mode", suite::name(race_cell.mode))
      .set("method", race_cell.methods[method]->id)
      .set("scalar", suite::name(race_cell.scalar))
      .set("dimension", race_cell.cell.dimension)
      .set("degree", race_cell.cell.degree)
      .set_each(tables::drawn_columns(), tables::drawn_fields(race_cell.cell))
      .set_each(judge::case_columns(), judge::case_fields(race_cell.case_values));
  return row;
}

tables::Row sentinel_key_row(const suite::Study& study, suite::Mode mode) {
  tables::Row row("timing.csv");
  row.set("study", study.id)
      .set("curve", suite::name(study.curve))
      .set("mode", suite::name(mode))
      .set("method", race::sentinel_name)
      .set("scalar", suite::name(suite::ScalarKind::float64));
  return row;
}

/// Sets the times, rounds, counts and the check of one lap; `pace` is what the sentinels took beside.
void set_times(tables::Row& row, const race::RaceCellLap& lap, const race::Pace& pace) {
  const auto rounds = lap.rounds();
  set_interval(row, {"median_ns", "low_ns", "high_ns"}, lap.repetition_ns());
  row.set("rounds", rounds.ns_per_point.size()).set("points_per_round", rounds.points_per_round);
  set_median(row, "cycles", rounds.cycles_per_point);
  set_median(row, "instructions", rounds.instructions_per_point);
  row.set("checked", rounds.checked ? "yes" : "no")
      .set("repetitions", lap.repetitions.size())
      .set("sentinel_ns", pace.chain_ns)
      .set("sweep_ns", pace.sweep_ns);
}

void add_race_cell(tables::Tables& tables, const suite::Study& study, const race::RaceCell& race_cell,
                   const race::Pace& fastest) {
  const auto base = race::relative_to(race_cell, study);
  for (std::size_t m = 0; m < race_cell.methods.size(); ++m) add_timing_row(tables, study, race_cell, m, base, fastest);
}

/// The sentinel over all race cells of a mode.
void add_sentinel(tables::Tables& tables, const suite::Study& study, const std::vector<race::RaceCell>& race_cells,
                  suite::Mode mode, const race::Pace& fastest) {
  race::RaceCellLaps all;
  std::string_view worst = ok;
  for (const auto& race_cell : race_cells) {
    if (race_cell.mode != mode || race_cell.laps.empty()) continue;
    all.merge({{race_cell.laps.end() - 2, race_cell.laps.end()}});
    if (race::drifted(race_cell.laps, fastest)) worst = noisy;
  }
  if (all.each.empty()) return;
  tables::Row row = sentinel_key_row(study, mode);
  set_times(row, all.each.back(), race::pace(all.each));
  tables.add(row.set("quality", worst));
}

}  // namespace

void add_timing_row(tables::Tables& tables, const suite::Study& study, const race::RaceCell& race_cell,
                    std::size_t method, std::optional<std::size_t> base, const race::Pace& fastest) {
  const auto& lap = race_cell.laps[method];
  tables::Row row = key_row(study, race_cell, method);
  set_times(row, lap, race::pace(race_cell.laps));
  row.set("quality", quality(race_cell, lap, fastest));
  if (base) set_ratio(row, race_cell, lap, *base);
  set_interval(row, {"sentinel_units", "sentinel_units_low", "sentinel_units_high"},
               quotients(lap.repetition_ns(), race_cell.laps.back().repetition_ns()));
  row.set("max_error_u", lap.max_error_u);
  set_limit(row, race_cell, method, race::median_of(race_cell.operations));
  tables.add(row);
}

void list_timing_rows(const suite::Study& study, const std::vector<race::RaceCell>& race_cells,
                      tables::Tables& tables) {
  for (const auto& race_cell : race_cells)
    for (std::size_t m = 0; m < race_cell.methods.size(); ++m) tables.add(key_row(study, race_cell, m));
  for (const auto mode : study.modes)
    if (std::ranges::any_of(race_cells, [mode](const auto& one) { return one.mode == mode && !one.methods.empty(); }))
      tables.add(sentinel_key_row(study, mode));
}

void write_timing_rows(const suite::Study& study, const std::vector<race::RaceCell>& race_cells,
                       tables::Tables& tables) {
  (void)tables.table("timing.csv");
  const race::Pace fastest = race::fastest_pace(race_cells);
  for (const auto& race_cell : race_cells)
    if (!race_cell.laps.empty()) add_race_cell(tables, study, race_cell, fastest);
  for (const auto mode : study.modes) add_sentinel(tables, study, race_cells, mode, fastest);
}

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
