// SPDX-License-Identifier: MIT
// Times of a method from outside that is code. Every repetition is a race in a child process, against the method that
// the study's ratios are relative to, with an empty kernel and the sentinels.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "experiments/judge/methods.hpp"
#include "experiments/number/bytes.hpp"
#include "experiments/outside/called_code.hpp"
#include "experiments/race/clock.hpp"
#include "experiments/race/judged_race.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/timed_check.hpp"
#include "experiments/race/timed_inputs.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/outside/outside_jobs.hpp"
#include "experiments/studies/timing/timed_evaluation.hpp"
#include "experiments/studies/timing/timing_rows.hpp"

namespace bezierbench::studies {
namespace {

/// The laps of the repetitions that ended as they should.
struct OutsideLaps {
  race::RaceCellLaps laps;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.laps);
  }
  void merge(const OutsideLaps& other) {
    if (!other.laps.each.empty()) laps.merge(other.laps);
  }
};

class OutsideTimingJob final : public run::JobOf<OutsideLaps> {
 public:
  OutsideTimingJob(const suite::Study& study, const suite::OutsideMethod& record, const outside::Method* at_hand,
                   std::uint64_t seed)
      : study_(study), seed_(seed), method_(record, study.curve, at_hand) {
    for (auto& race_cell : race_cells_of_evaluation(study_)) {
      if (race_cell.scalar != suite::ScalarKind::float64 || !method_.info().supports<double>(race_cell.cell.degree))
        continue;
      const auto base = race::relative_to(race_cell, study_);
      race_cell.methods = base ? std::vector{race_cell.methods[*base]} : std::vector<const MethodInfo*>();
      race_cell.methods.push_back(&method_.info());
      race_cells_.push_back(std::move(race_cell));
    }
  }

  [[nodiscard]] std::size_t parts() const override { return race_cells_.size(); }
  [[nodiscard]] std::size_t blocks_per_part() const override { return race::repetitions_per_race; }
  [[nodiscard]] bool exclusive() const override { return true; }
  void require_machine() const override { race::require_steady_clock(); }
  [[nodiscard]] double cost(std::size_t part) const override { return race::repetition_cost(race_cells_[part]); }
  [[nodiscard]] run::Extent extent() const override {
    return {0, race_cells_.size(), race_cells_.size() * race::timed_inputs_per_cell, 0};
  }
  void write(tables::Tables& tables) const override;
  [[nodiscard]] std::vector<tables::Series> series() const override { return {}; }

 protected:
  [[nodiscard]] OutsideLaps work(std::size_t block) const override;

 private:
  [[nodiscard]] race::JudgedRivals rivals_in_child(const race::RaceCell& race_cell,
                                                   const race::Inputs<double>& inputs) const;

  suite::Study study_;
  std::uint64_t seed_;
  JudgedOutside method_;
  std::vector<race::RaceCell> race_cells_;
};

void OutsideTimingJob::write(tables::Tables& tables) const {
  (void)tables.table("timing.csv");
  auto race_cells = race_cells_;
  for (std::size_t part = 0; part < race_cells.size(); ++part) {
    race_cells[part].laps = state(part).laps.each;
    race_cells[part].operations = state(part).laps.operations;
  }
  const auto fastest = race::fastest_pace(race_cells);
  for (const auto& race_cell : race_cells) {
    if (race_cell.laps.empty()) continue;
    const auto own = race_cell.methods.size() - 1;
    add_timing_row(tables, study_, race_cell, own, own == 0 ? std::nullopt : std::optional<std::size_t>(0), fastest);
  }
}

race::JudgedRivals OutsideTimingJob::rivals_in_child(const race::RaceCell& race_cell,
                                                     const race::Inputs<double>& inputs) const {
  race::JudgedRivals all;
  for (const auto* info : race_cell.methods) {
    const auto* kernel = info == &method_.info()
                             ? method_.method().open_kernel(race_cell.cell.dimension)
                             : judge::find_method<double>(info->id, info->form, race_cell.cell.dimension);
    auto judged = race::judge(*kernel, race_cell.mode, inputs);
    all.judged.push_back({judged.right, judged.max_error_u});
    all.rivals.push_back(race::kernel_rival(*kernel, race_cell.mode, inputs, std::move(judged.points)));
  }
  all.call = race::call_rival(race_cell.mode, inputs);
  return all;
}

OutsideLaps OutsideTimingJob::work(std::size_t block) const {
  const auto& race_cell = race_cells_[part_of(block)];
  const auto work = [&] {
    const int answer = outside::keep_output_for_answer();
    const auto inputs = race::timed_inputs<double>(study_, race_cell.cell, seed_);
    number::ByteWriter bytes;
    bytes(race::race_of(race_cell, study_, rivals_in_child(race_cell, inputs), block % race::repetitions_per_race,
                        race::options_of_a_repetition()));
    outside::write_all(answer, bytes.bytes());
  };
  constexpr std::size_t most_bytes = std::size_t{1} << 28U;
  constexpr double seconds = 120;  // a race ends by itself after 30
  const auto ended = outside::run_in_child(work, {}, most_bytes, {.seconds = seconds}, run::interrupted);
  OutsideLaps result;
  if (run::interrupted()) return result;
  if (ended.end != outside::End::exited || ended.code != 0) {
    method_.tell(study_, outside::failed(ended));
    return result;
  }
  try {
    number::ByteReader reader(ended.output);
    reader(result.laps);
    reader.finish();
  } catch (const number::MalformedBytes&) {
    method_.tell(study_, {outside::Status::malformed, {}, "its times cannot be read"});
    return {};
  }
  return result;
}

}  // namespace

std::unique_ptr<run::Job> outside_timing_job(const suite::Study& study, const suite::OutsideMethod& record,
                                             const outside::Method* at_hand, const run::JobContext& context) {
  return std::make_unique<OutsideTimingJob>(study, record, at_hand, context.seed);
}

}  // namespace bezierbench::studies
