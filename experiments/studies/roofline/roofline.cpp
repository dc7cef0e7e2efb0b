// SPDX-License-Identifier: MIT
#include "experiments/studies/roofline/roofline.hpp"

#include "experiments/race/clock.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roofline/roofline_race.hpp"
#include "experiments/studies/roofline/roofline_rows.hpp"

namespace bezierbench::studies {
namespace {

class RooflineJob final : public run::JobOf<RooflineLaps> {
 public:
  RooflineJob(const suite::Study& study, std::uint64_t seed)
      : study_(study), seed_(seed), races_(roofline_races_of(study)) {}

  [[nodiscard]] std::size_t parts() const override { return races_.size(); }
  [[nodiscard]] bool exclusive() const override { return true; }
  void require_machine() const override { race::require_steady_clock(); }
  [[nodiscard]] double cost(std::size_t part) const override {
    return 5e7 * static_cast<double>(races_[part].rivals.size());  // about the same wall time whatever the degree
  }
  [[nodiscard]] run::Extent extent() const override {
    run::Extent sum{races_.size(), 0, 0, 0};
    for (const auto& race : races_)
      for (const auto& who : race.rivals)
        if (who.method != nullptr) {
          ++sum.rows;
          sum.evaluations += race::timed_inputs_per_cell;
        }
    return sum;
  }
  void write(tables::Tables& tables) const override {
    auto races = races_;
    for (std::size_t part = 0; part < races.size(); ++part) races[part].laps = state(part);
    write_roofline_rows(study_, races, tables);
  }
  void list_rows(tables::Tables& tables) const override { list_roofline_rows(study_, races_, tables); }
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] RooflineLaps work(std::size_t block) const override {
    if (races_[block].rivals.empty()) return {};  // no method supports the degree, or no target is there
    race::RaceOptions options;
    options.stop = run::interrupted;
    return run(races_[block], study_, seed_, options);
  }

 private:
  suite::Study study_;
  std::uint64_t seed_;
  std::vector<RooflineRace> races_;
};

}  // namespace

std::unique_ptr<run::Job> roofline_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<RooflineJob>(study, context.seed);
}

}  // namespace bezierbench::studies
