// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timing_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/metric/growth.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/race/limit.hpp"
#include "experiments/race/processor_models.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::studies {

namespace {

/// What keeps a time from being compared. A machine that changed its speed is not among it: ratios are taken within
/// rounds, and repetitions that disagree widen the intervals.
std::string_view quality(std::size_t repetitions, bool checked) {
  if (!checked) return "unchecked";
  return metric::covers_median(repetitions, metric::timing_confidence) ? "ok" : "few_rounds";
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

/// Sets the ratio over repetitions; that of a repetition is the median of its rounds.
void set_ratio(tables::Row& row, const race::Race& race, const race::RivalTimes& times, std::size_t base) {
  row.set("relative_to", race.methods[base]->id);
  set_interval(row, {"ratio", "ratio_low", "ratio_high"},
               race::repetition_ratios(times.repetitions, race.times[base].repetitions));
}

void set_median(tables::Row& row, std::string_view column, std::span<const double> counts) {
  if (!counts.empty()) row.set(column, metric::median_interval(counts, metric::timing_confidence).median);
}

/// Empty for an external method, whose operations are not known.
std::optional<race::TimedWork> work_of(const race::Race& race, const MethodInfo& method) {
  return judge::with_scalar(race.scalar, [&]<class Scalar>(Scalar /*zero*/) -> std::optional<race::TimedWork> {
    const auto* kernel = judge::find_method<Scalar>(method.id, method.form, race.cell.dimension);
    if (kernel == nullptr) return std::nullopt;
    return race::TimedWork{kernel->evaluator, kernel->conversion, race.cell.degree, race.cell.dimension};
  });
}

/// Sets the time of an empty kernel, and the share of the processor's limit in the rest of the method's time.
void set_limit(tables::Row& row, const race::Race& race, std::size_t m, const race::ProcessorTimes& times) {
  const auto* const call = race::call_times(race);
  if (call == nullptr) return;
  const double call_ns = metric::median(call->repetition_ns());
  row.set("call_ns", call_ns);
  const auto work = work_of(race, *race.methods[m]);
  if (!work) return;
  const auto limit = race::limit(*work, race.mode, times);
  if (!limit) return;
  const double ns = metric::median(race.times[m].repetition_ns());
  row.set("limit_ns", limit->ns)
      .set("share_of_limit", race::share_of_limit(limit->ns, ns, call_ns))
      .set("chain_ns", limit->chain_ns);
}

tables::Row key_row(std::string_view file, const suite::Study& study, const race::Race& race, std::size_t method) {
  tables::Row row(file);
  row.set("study", study.id)
      .set("form", name(study.form))
      .set("mode", suite::name(race.mode))
      .set("method", race.methods[method]->id)
      .set("scalar", suite::name(race.scalar))
      .set("dimension", race.cell.dimension)
      .set("degree", race.cell.degree)
      .set_each(tables::drawn_columns(), tables::drawn_fields(race.cell))
      .set_each(judge::case_columns(), judge::case_fields(race.case_values));
  return row;
}

/// Sets the times, rounds, counts and the check of one rival, and those of the sentinels.
void set_times(tables::Row& row, const race::RivalTimes& times, const race::SentinelTimes& sentinels) {
  const auto rounds = times.rounds();
  set_interval(row, {"median_ns", "low_ns", "high_ns"}, times.repetition_ns());
  row.set("rounds", rounds.ns_per_point.size()).set("points_per_round", rounds.points_per_round);
  set_median(row, "cycles", rounds.cycles_per_point);
  set_median(row, "instructions", rounds.instructions_per_point);
  row.set("quality", quality(times.repetitions.size(), rounds.checked))
      .set("checked", rounds.checked ? "yes" : "no")
      .set("repetitions", times.repetitions.size())
      .set("sentinel_ns", sentinels.chain_ns)
      .set("sweep_ns", sentinels.sweep_ns);
}

void add_race(tables::Tables& tables, const suite::Study& study, const race::Race& race) {
  const auto base = race::relative_to(race, study);
  for (std::size_t m = 0; m < race.methods.size(); ++m) add_timing_row(tables, study, race, m, base);
}

/// The sentinel over all races of a mode.
void add_sentinel(tables::Tables& tables, const suite::Study& study, const std::vector<race::Race>& races,
                  suite::Mode mode) {
  race::RaceTimes all;
  for (const auto& race : races)
    if (race.mode == mode && !race.times.empty()) all.merge({{race.times.end() - 2, race.times.end()}});
  if (all.each.empty()) return;
  tables::Row row("timing.csv");
  row.set("study", study.id)
      .set("form", name(study.form))
      .set("mode", suite::name(mode))
      .set("method", race::sentinel_name)
      .set("scalar", suite::name(suite::ScalarKind::float64));
  set_times(row, all.each.back(), race::median_sentinels(all.each));
  tables.add(row);
}

}  // namespace

void add_timing_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method,
                    std::optional<std::size_t> base) {
  const auto& times = race.times[method];
  tables::Row row = key_row("timing.csv", study, race, method);
  set_times(row, times, race::median_sentinels(race.times));
  if (base) set_ratio(row, race, times, *base);
  set_interval(row, {"sentinel_units", "sentinel_units_low", "sentinel_units_high"},
               quotients(times.repetition_ns(), race.times.back().repetition_ns()));
  row.set("max_error_u", times.max_error_u);
  set_limit(row, race, method, race::median_of(race.operations));
  tables.add(row);
}

void write_timing_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables) {
  (void)tables.table("timing.csv");
  for (const auto& race : races)
    if (!race.times.empty()) add_race(tables, study, race);
  for (const auto mode : study.modes) add_sentinel(tables, study, races, mode);
}

void add_cost_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, std::size_t method) {
  const auto& counts = race.counts[method];
  auto row = key_row("cost.csv", study, race, method);
  if (!counts.target.empty()) row.set("target", counts.target);
  row.set("instructions", counts.instructions)
      .set("loads", counts.loads)
      .set("stores", counts.stores)
      .set("branches", counts.branches);
  for (std::size_t k = 0; k < counts.cycles.size(); ++k)
    row.set(fmt::format("cycles_{}", race::processors[k].id), counts.cycles[k].throughput)
        .set(fmt::format("latency_{}", race::processors[k].id), counts.cycles[k].latency);
  tables.add(row);
}

void write_cost_rows(const suite::Study& study, const std::vector<race::Race>& races, tables::Tables& tables) {
  (void)tables.table("cost.csv");
  for (const auto& race : races)
    for (std::size_t m = 0; m < race.counts.size(); ++m) add_cost_row(tables, study, race, m);
}

namespace {

/// The times of one method over the sizes.
struct Ladder {
  const race::Race* first;  ///< its races differ in the size only
  const MethodInfo* method;
  std::vector<double> sizes;
  std::vector<double> ns;
};

double size_of(const race::Race& race, race::Size size) {
  return size == race::Size::points ? *race.case_values.points : race.cell.degree;
}

/// In the order in which their first races ran.
std::vector<Ladder> ladders_of(const std::vector<race::Race>& races, race::Size size) {
  std::vector<Ladder> ladders;
  std::map<std::tuple<suite::ScalarKind, int, suite::Mode, std::vector<tables::Field>, const MethodInfo*>, std::size_t>
      places;
  for (const auto& race : races)
    for (std::size_t m = 0; m < race.methods.size() && !race.times.empty(); ++m) {
      const auto [place, is_new] = places.try_emplace(
          {race.scalar, race.cell.dimension, race.mode, tables::drawn_fields(race.cell), race.methods[m]},
          ladders.size());
      if (is_new) ladders.push_back({&race, race.methods[m], {}, {}});
      Ladder& ladder = ladders[place->second];
      ladder.sizes.push_back(size_of(race, size));
      ladder.ns.push_back(metric::median_interval(race.times[m].repetition_ns(), metric::timing_confidence).median);
    }
  return ladders;
}

int claimed_exponent(const MethodInfo& method, suite::Mode mode) {
  return mode == suite::Mode::one_shot ? std::max(method.cost_exponent, method.prepare_exponent) : method.cost_exponent;
}

}  // namespace

void write_complexity_rows(const suite::Study& study, const std::vector<race::Race>& races, race::Size size,
                           tables::Tables& tables) {
  if (size == race::Size::unclaimed) return;
  (void)tables.table("complexity.csv");
  for (const auto& ladder : ladders_of(races, size)) {
    const auto fitted = metric::growth(ladder.sizes, ladder.ns, metric::timing_confidence);
    if (!fitted) continue;
    const int claimed = claimed_exponent(*ladder.method, ladder.first->mode);
    const auto [min_size, max_size] = std::ranges::minmax(ladder.sizes);
    const bool grows_with_points = size == race::Size::points;
    const auto& first = *ladder.first;
    tables::Row row("complexity.csv");
    row.set("study", study.id)
        .set("form", name(study.form))
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
    if (grows_with_points)
      row.set("first_degree", first.cell.degree)
          .set("last_degree", first.cell.degree)
          .set("first_points", min_size)
          .set("last_points", max_size);
    else
      row.set("first_degree", min_size).set("last_degree", max_size);
    tables.add(row);
  }
}

}  // namespace bezierbench::studies
