// SPDX-License-Identifier: MIT
// Times of an external method that is code. Every repetition is a race in a child process, against the method that
// the study's ratios are relative to, with an empty kernel and the sentinels.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/external/method.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/scalar_facts.hpp"
#include "experiments/number/bytes.hpp"
#include "experiments/race/kernel_rival.hpp"
#include "experiments/race/race.hpp"
#include "experiments/run/interruption.hpp"
#include "experiments/studies/external/external.hpp"
#include "experiments/studies/timing/timed_evaluation.hpp"
#include "experiments/studies/timing/timing_rows.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/tables/tables.hpp"

namespace bezierbench::studies {
namespace {

using external::Status;

/// The times of the successful repetitions, and the worst status of all repetitions.
struct ExternalLaps {
  race::RaceTimes times;
  std::uint8_t status = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.times, self.status);
  }
  void merge(const ExternalLaps& other) {
    times.merge(other.times);
    status = std::max(status, other.status);
  }
};

ExternalLaps nothing(Status status) { return {{}, static_cast<std::uint8_t>(status)}; }

/// The races of a study that the method can join, with the method that ratios are relative to as its only rival.
std::vector<race::Race> races_of(const suite::Study& study, const JudgedExternal& external) {
  const MethodInfo& method = external.info();
  std::vector<race::Race> all;
  for (auto& race : races_of_evaluation(study)) {
    if (!external.answers_in(race.scalar) || !method.supports<double>(race.cell.degree)) continue;
    const auto base = race::relative_to(race, study);
    race.methods = base ? std::vector{race.methods[*base]} : std::vector<const MethodInfo*>();
    race.methods.push_back(&method);
    all.push_back(std::move(race));
  }
  return all;
}

class ExternalTimingJob final : private JudgedExternal, public RacingJob<ExternalLaps> {
 public:
  ExternalTimingJob(const suite::Study& study, const suite::ExternalMethod& record, const external::Method* given,
                    const run::JobContext& context)
      : JudgedExternal(record, study.form, given), RacingJob(study, context, races_of(study, *this)), late_(parts()) {}

  [[nodiscard]] run::Extent extent() const override { return {0, parts(), parts() * race::timed_inputs_per_cell}; }
  void write(tables::Tables& tables) const override;

 protected:
  [[nodiscard]] ExternalLaps work(std::size_t block) const override;
  /// Opens the method, so it is to be called in a process that serves it alone.
  [[nodiscard]] race::JudgedRivals rivals_of(std::size_t part) const override {
    return judge::with_scalar(races()[part].scalar,
                              [&]<class Scalar>(Scalar /*zero*/) { return rivals_in<Scalar>(races()[part]); });
  }

 private:
  template <class Scalar>
  [[nodiscard]] race::JudgedRivals rivals_in(const race::Race& race) const;

  mutable std::vector<bool> late_;  ///< races in which a repetition took too long; their other repetitions are skipped
};

/// A race in which the method failed, instead of times.
void add_untimed_row(tables::Tables& tables, const suite::Study& study, const race::Race& race, Status status) {
  tables.add(tables::Row("untimed.csv")
                 .set("study", study.id)
                 .set("form", name(study.form))
                 .set("method", race.methods.back()->id)
                 .set("scalar", suite::name(race.scalar))
                 .set("dimension", race.cell.dimension)
                 .set("degree", race.cell.degree)
                 .set("mode", suite::name(race.mode))
                 .set_each(tables::drawn_columns(), tables::drawn_fields(race.cell))
                 .set("status", name(status)));
}

void ExternalTimingJob::write(tables::Tables& tables) const {
  if (repetitions() > 0) (void)tables.table("timing.csv");
  const auto cells = raced([this](std::size_t part) -> const race::RaceTimes& { return state(part).times; });
  for (std::size_t part = 0; part < cells.size(); ++part) {
    const auto& race = cells[part];
    const auto status = static_cast<Status>(state(part).status);
    const auto own = race.methods.size() - 1;
    if (status != Status::ok)
      add_untimed_row(tables, study(), race, status);
    else if (!race.times.empty())
      add_timing_row(tables, study(), race, own, own == 0 ? std::nullopt : std::optional<std::size_t>(0));
    if (race.counts.size() > own) add_cost_row(tables, study(), race, own);
  }
}

template <class Scalar>
race::JudgedRivals ExternalTimingJob::rivals_in(const race::Race& race) const {
  const auto held =
      std::make_shared<const race::Inputs<Scalar>>(race::timed_inputs<Scalar>(study(), race.cell, seed()));
  const auto& inputs = *held;
  race::JudgedRivals all{{}, {}, held};
  for (const auto* info : race.methods) {
    const auto* kernel = info == &this->info() ? method().open_kernel(race.cell.dimension, Scalar{})
                                               : judge::find_method<Scalar>(info->id, info->form, race.cell.dimension);
    auto judged = race::judge_points(*kernel, race.mode, inputs);
    all.judged.push_back({judged.right, judged.max_error_u});
    all.rivals.push_back(race::kernel_rival(*kernel, race.mode, inputs, std::move(judged.points)));
  }
  all.call = race::call_rival(race.mode, inputs);
  return all;
}

ExternalLaps ExternalTimingJob::work(std::size_t block) const {
  const auto& race = races()[part_of(block)];
  if (is_count(block)) {
    try {
      return {counted(part_of(block)), 0};
    } catch (const Failure& failure) {
      report(study(), {Status::crashed, {}, failure.what()});
      return {};
    }
  }
  if (late_[part_of(block)]) return nothing(Status::timed_out);
  const auto work = [&] {
    const int answer = external::keep_output_for_answer();
    ExternalLaps result;
    try {
      result.times =
          race::run_rivals(race, study(), rivals_of(part_of(block)), repetition_of(block), race::repetition_options());
    } catch (const external::CurveRefused&) {
      result = nothing(Status::refused);
    } catch (...) {
      result = nothing(Status::threw);
    }
    number::ByteWriter bytes;
    bytes(result);
    external::write_all(answer, bytes.bytes());
  };
  constexpr std::size_t max_bytes = std::size_t{1} << 28U;
  const auto ended = external::run_in_child(work, {}, max_bytes, method().limits(), run::interrupted);
  if (run::interrupted()) return {};
  ExternalLaps result;
  external::Answer failure;
  if (ended.end == external::End::exited && ended.code == 0 && !ended.output.empty()) {
    try {
      number::ByteReader reader(ended.output);
      reader(result);
      reader.finish();
      failure = {static_cast<Status>(result.status), {}, "while it was timed"};
    } catch (const number::MalformedBytes&) {
      failure = {Status::malformed, {}, "its times cannot be read"};
    }
  } else {
    failure = external::failed(ended);
  }
  if (failure.status == Status::ok) return result;
  if (failure.status == Status::timed_out) late_[part_of(block)] = true;
  report(study(), failure);
  return nothing(failure.status);
}

}  // namespace

std::unique_ptr<run::Job> external_timing_job(const suite::Study& study, const suite::ExternalMethod& record,
                                              const external::Method* given, const run::JobContext& context) {
  return std::make_unique<ExternalTimingJob>(study, record, given, context);
}

}  // namespace bezierbench::studies
