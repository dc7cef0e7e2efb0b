// SPDX-License-Identifier: MIT
#include "experiments/studies/outside/outside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "experiments/run/notes.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/names.hpp"

namespace bezierbench::studies {
namespace {

/// The study with those methods only that are not from outside.
suite::Study without_outside(suite::Study study) {
  std::erase_if(study.methods, [](const auto& id) { return suite::is_outside(id); });
  return study;
}

}  // namespace

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

std::string why_unasked(const suite::Study& study, const suite::OutsideMethod& record) {
  const bool is_code = record.kind == suite::OutsideKind::own || record.kind == suite::OutsideKind::plugin;
  if (is_kind(study, timing_kind)) {
    if (!is_code) return "it is timed, which only a shared object or a compiled-in method is";
    if (&timed_kind(without_outside(study)) != &accuracy_kind) return "it times another problem";
  } else if (!is_kind(study, accuracy_kind)) {
    return fmt::format("it is of kind {}", suite::kind_of(study).id);
  }
  if (record.kind != suite::OutsideKind::answers && record.form != study.form)
    return fmt::format("its curves are in {} form, the method takes {} form", name(study.form), name(record.form));
  return std::ranges::count(study.scalar, suite::ScalarKind::float64) == 0 ? "it is in float only" : "";
}

std::unique_ptr<run::Job> outside_job(const suite::Study& study, const suite::OutsideMethod& record,
                                      const outside::Method* at_hand, const run::JobContext& context) {
  if (!why_unasked(study, record).empty()) return nullptr;
  if (is_kind(study, accuracy_kind)) return outside_accuracy_job(study, record, at_hand, context);
  return outside_timing_job(without_outside(study), record, at_hand, context);
}

}  // namespace bezierbench::studies
