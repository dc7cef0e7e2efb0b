// SPDX-License-Identifier: MIT
#include "experiments/studies/timing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/failure.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/number/number.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/sample/draw.hpp"
#include "experiments/studies/interruption.hpp"
#include "experiments/studies/method_choice.hpp"
#include "experiments/studies/timed_check.hpp"
#include "experiments/suite/names.hpp"
#include "experiments/timing/kernel_rival.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::size_t inputs_per_cell = 256;
constexpr double confidence = 0.99;

/// One cell in one mode: a race.
struct Heat {
  sample::Cell cell;
  suite::Mode mode;
  std::vector<const Kernel<double>*> methods;  ///< those that support the degree
};

/// Per method.
struct HeatResult {
  std::vector<timing::Lap> laps;
  std::vector<bool> correct;  ///< against the exact reference, before timing

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.laps, self.correct);
  }
};

class TimingJob final : public JobOf<HeatResult> {
 public:
  TimingJob(const suite::Study& study, std::uint64_t seed) : study_(study), seed_(seed) {
    for (const auto scalar : study_.scalar)
      if (scalar != suite::ScalarKind::float64)
        throw Failure(
            Exit::usage,
            fmt::format("study \"{}\": timing takes scalar = [\"double\"] only; leave the others out", study_.id));
    for (const auto& cell : sample::cells(study_))
      for (const auto mode : study_.modes) {
        Heat heat{cell, mode, {}};
        for (const auto* kernel : chosen_kernels<double>(study_, cell.dimension))
          if (kernel->info->supports<double>(cell.degree)) heat.methods.push_back(kernel);
        heats_.push_back(std::move(heat));
      }
  }

  [[nodiscard]] std::size_t parts() const override { return heats_.size(); }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override {
    return 5e7 * static_cast<double>(heats_[part].methods.size());  // about the same wall time whatever the degree
  }
  [[nodiscard]] Extent extent() const override {
    Extent sum{heats_.size(), 0, 0, 0};
    for (const auto& heat : heats_) {
      sum.rows += heat.methods.size();
      sum.evaluations += heat.methods.size() * inputs_per_cell;
    }
    return sum;
  }
  void write(Tables& tables) const override;
  [[nodiscard]] std::vector<Series> series() const override;

 protected:
  [[nodiscard]] HeatResult work(std::size_t block) const override;

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<Heat> heats_;
};

HeatResult TimingJob::work(std::size_t block) const {
  const Heat& heat = heats_[block];
  HeatResult result;
  if (heat.methods.empty()) return result;  // none supports the degree
  timing::Inputs inputs{form_of(study_.curve), heat.cell.dimension, heat.cell.degree, {}, {}, {}};
  const sample::Sampler sampler(seed_, study_.id, heat.cell);
  sample::Trial trial;
  for (std::size_t k = 0; k < inputs_per_cell; ++k) {
    sampler.draw(k, trial);
    inputs.curves.push_back(trial.coefficients);
    inputs.t.push_back(trial.t);
    inputs.weights.push_back(trial.weights);
  }
  std::vector<timing::Rival> rivals;
  for (const auto* kernel : heat.methods) {
    result.correct.push_back(agrees_with_reference(*kernel, heat.mode, inputs));
    rivals.push_back(timing::kernel_rival(*kernel, heat.mode, inputs));
  }
  timing::RaceOptions options;
  options.stop = interrupted;
  result.laps =
      timing::race(fmt::format("{}/{}/{}", study_.id, heat.cell.degree, suite::name(heat.mode)), rivals, options);
  return result;
}

void TimingJob::write(Tables& tables) const {
  auto& table = tables.table(
      "timing.csv", {"study",     "curve",      "method",  "scalar",       "dimension",        "degree",      "mode",
                     "median_ns", "low_ns",     "high_ns", "rounds",       "points_per_round", "relative_to", "ratio",
                     "ratio_low", "ratio_high", "cycles",  "instructions", "quality",          "checked"});
  const auto number = [](double value) { return number::decimal(value); };
  for (std::size_t part = 0; part < heats_.size(); ++part)
    for (std::size_t m = 0; m < heats_[part].methods.size(); ++m) {
      const Heat& heat = heats_[part];
      const HeatResult& result = state(part);
      const auto& lap = result.laps.at(m);
      const auto& base = result.laps.front();
      const auto time = metric::median_interval(lap.ns_per_point, confidence);
      std::vector<double> ratios;
      for (std::size_t round = 0; round < lap.ns_per_point.size(); ++round)
        ratios.push_back(lap.ns_per_point[round] / base.ns_per_point[round]);
      const auto ratio = metric::median_interval(ratios, confidence);
      table.add_row({study_.id,
                     std::string(suite::name(study_.curve)),
                     std::string(heat.methods[m]->info->id),
                     std::string(suite::name(suite::ScalarKind::float64)),
                     std::to_string(heat.cell.dimension),
                     std::to_string(heat.cell.degree),
                     std::string(suite::name(heat.mode)),
                     number(time.median),
                     number(time.low),
                     number(time.high),
                     std::to_string(lap.ns_per_point.size()),
                     std::to_string(lap.points_per_round),
                     std::string(heat.methods.front()->info->id),
                     number(ratio.median),
                     number(ratio.low),
                     number(ratio.high),
                     "",
                     "",
                     "",
                     lap.checked && result.correct.at(m) ? "yes" : "no"});
    }
}

std::vector<Series> TimingJob::series() const {
  std::vector<Series> all;
  for (std::size_t part = 0; part < heats_.size(); ++part)
    for (std::size_t m = 0; m < heats_[part].methods.size(); ++m) {
      const Heat& heat = heats_[part];
      all.push_back({.study = study_.id,
                     .curve = std::string(suite::name(study_.curve)),
                     .method = std::string(heat.methods[m]->info->id),
                     .statistic = "total_time",
                     .degree = std::to_string(heat.cell.degree),
                     .coordinate_range = heat.cell.coordinate_range,
                     .t_interval = heat.cell.t_interval,
                     .generator = heat.cell.generator,
                     .baseline = "",
                     .mode = std::string(suite::name(heat.mode)),
                     .values = state(part).laps.at(m).ns_per_point});
    }
  return all;
}

}  // namespace

std::unique_ptr<Job> timing_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<TimingJob>(study, context.seed);
}

}  // namespace bezierbench::studies
