// SPDX-License-Identifier: MIT
// Studies of kind `roofline`: batch kernels against the peak of each target, measured in the same rounds.

#include "experiments/race/clock.hpp"
#include "experiments/race/timed_check.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/roofline/roofline_race.hpp"
#include "experiments/studies/roofline/roofline_rows.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/goal.hpp"

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

std::unique_ptr<run::Job> roofline_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<RooflineJob>(study, context.seed);
}

constexpr std::array roofline_fields{suite::field<&suite::Study::goals>(
    {.key = "goals",
     .meaning = "what is asked of batch kernels: of a method, a share of the peak or no_slower_than another method; "
                "scalar, from_degree and to_degree say in which rows, needs_additions_beside on which processors",
     .example = "[{ method = \"horner_bernstein_fma\", share = 0.6 }]",
     .left_out = "none",
     .settable = false})};

suite::Finding check_roofline(const suite::Study& study, const suite::Vocabulary& known) {
  return suite::each("goals", study.goals,
                     [&](const suite::Goal& goal) { return suite::goal_problem(goal, known.methods); });
}

}  // namespace

extern constexpr StudyKind roofline_kind{
    .asks = {.id = "roofline",
             .about = "batch kernels against the peak of each instruction set, kernels for a point against its limit",
             .own = roofline_fields,
             .methods_example = "[\"horner_bernstein_fma\"]",
             .timed = true,
             .check = check_roofline},
    .make = roofline_job,
    .tables = {"roofline"}};

}  // namespace bezierbench::studies
