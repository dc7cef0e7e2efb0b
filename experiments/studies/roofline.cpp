// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline.hpp"

#include "experiments/studies/interruption.hpp"
#include "experiments/studies/roofline_race.hpp"
#include "experiments/studies/roofline_rows.hpp"
#include "experiments/studies/timed_inputs.hpp"

namespace bezierbench::studies {
namespace {

using Laps = std::vector<timing::Lap>;

class RooflineJob final : public JobOf<Laps> {
 public:
  RooflineJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), races_(roofline_races_of(study)) {}

  [[nodiscard]] std::size_t parts() const override { return races_.size(); }
  [[nodiscard]] bool exclusive() const override { return true; }
  [[nodiscard]] double cost(std::size_t part) const override {
    return 5e7 * static_cast<double>(races_[part].contestants.size());  // about the same wall time whatever the degree
  }
  [[nodiscard]] Extent extent() const override {
    Extent sum{races_.size(), 0, 0, 0};
    for (const auto& race : races_)
      for (const auto& who : race.contestants)
        if (who.method != nullptr) {
          ++sum.rows;
          sum.evaluations += timed_inputs_per_cell;
        }
    return sum;
  }
  void write(Tables& tables) const override {
    auto races = races_;
    for (std::size_t part = 0; part < races.size(); ++part) races[part].laps = state(part);
    write_roofline_rows(study_, races, tables);
  }
  [[nodiscard]] std::vector<Series> series() const override { return {}; }

 protected:
  [[nodiscard]] Laps work(std::size_t block) const override {
    if (races_[block].contestants.empty()) return {};  // no method supports the degree, or no target is there
    timing::RaceOptions options;
    options.stop = interrupted;
    return run(races_[block], study_, seed_, options);
  }

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<RooflineRace> races_;
};

}  // namespace

std::unique_ptr<Job> roofline_job(const suite::Study& study, const JobContext& context) {
  return std::make_unique<RooflineJob>(study, context.seed);
}

}  // namespace bezierbench::studies
