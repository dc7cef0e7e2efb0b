// SPDX-License-Identifier: MIT
#include "experiments/studies/outside/outside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "experiments/run/notes.hpp"
#include "experiments/studies/outside/outside_jobs.hpp"
#include "experiments/studies/timing/timed_problems.hpp"

namespace bezierbench::studies {

JudgedOutside::JudgedOutside(suite::OutsideMethod record, Form form, const outside::Method* at_hand)
    : record_(std::move(record)),
      at_hand_(at_hand),
      info_{.id = record_.id,
            .label = record_.label,
            .form = form,
            .min_degree = record_.min_degree,
            .max_degree = record_.max_degree,
            .flops = {},
            .citation = {}} {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    auto& kernel = described_[static_cast<std::size_t>(dimension) - 1];
    kernel = {};
    kernel.info = kernel.evaluator = &info_;
    kernel.dimension = dimension;
    kernel.evaluated_form = form;
  }
}

const outside::Method& JudgedOutside::method() const {
  if (at_hand_ == nullptr) throw std::logic_error(record_.id + ": is to be run and was not given");
  return *at_hand_;
}

void JudgedOutside::tell(const suite::Study& study, const outside::Answer& answer) const {
  if (!told_.test_and_set())
    run::note(fmt::format("{}: {} in study {}{}{}; its rows say where", record_.id, name(answer.status), study.id,
                          answer.detail.empty() ? "" : ": ", answer.detail));
}

std::unique_ptr<run::Job> outside_job(const suite::Study& study, const suite::OutsideMethod& record,
                                      const outside::Method* at_hand, const run::JobContext& context) {
  const bool takes_form = record.kind == suite::OutsideKind::answers || record.form == study.curve;
  if (!takes_form || std::ranges::count(study.scalar, suite::ScalarKind::float64) == 0) return nullptr;
  if (suite::is_kind<suite::AccuracyKeys>(study)) return outside_accuracy_job(study, record, at_hand, context);
  const bool has_times = record.kind == suite::OutsideKind::own || record.kind == suite::OutsideKind::plugin;
  if (!has_times || !suite::is_kind<suite::TimingKeys>(study)) return nullptr;
  suite::Study own = study;
  std::erase_if(own.methods, [](const auto& id) { return suite::is_outside(id); });
  if (timed_problem(own).problem != Problem::evaluation) return nullptr;
  return outside_timing_job(own, record, at_hand, context);
}

}  // namespace bezierbench::studies
