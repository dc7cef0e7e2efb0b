// SPDX-License-Identifier: MIT
#include "experiments/studies/external/external.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/run/interruption.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/kind.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {
namespace {

/// The study without external methods.
suite::Study without_external(suite::Study study) {
  std::erase_if(study.methods, [](const auto& id) { return suite::is_external(id); });
  return study;
}

}  // namespace

JudgedExternal::JudgedExternal(suite::ExternalMethod record, Form form, const external::Method* given)
    : record_(std::move(record)),
      given_(given),
      info_{.id = record_.id,
            .label = record_.label,
            .form = form,
            .min_degree = record_.min_degree,
            .max_degree = record_.max_degree,
            .max_degree_float = record_.max_degree,
            .flops = {},
            .citation = {}} {
  const auto describe = [&](auto& kernels) {
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      kernels[k] = {};
      kernels[k].info = kernels[k].evaluator = &info_;
      kernels[k].dimension = static_cast<int>(k) + 1;
      kernels[k].evaluated_form = form;
    }
  };
  std::apply([&](auto&... of_scalar) { (describe(of_scalar), ...); }, described_);
}

const external::Method& JudgedExternal::method() const {
  if (given_ == nullptr) throw std::logic_error(record_.id + ": was not given");
  return *given_;
}

external::Answer JudgedExternal::ask(const suite::Study& study, std::size_t part, const external::Batch& batch) const {
  {
    const std::scoped_lock lock(mutex_);
    if (late_.contains(part)) return {external::Status::timed_out, {}, {}};
  }
  auto answer = method().ask(batch);
  if (run::interrupted()) return {};  // the engine drops unfinished blocks
  const auto lost = std::ranges::count_if(answer.numbers, [](double x) { return !std::isfinite(x); });
  if (answer.status == external::Status::ok && lost > 0)
    report(study, {external::Status::non_finite, {}, fmt::format("{} of {} coordinates", lost, answer.numbers.size())});
  if (answer.status == external::Status::ok) return answer;
  report(study, answer);
  const std::scoped_lock lock(mutex_);
  if (answer.status == external::Status::timed_out) late_.insert(part);
  answer.numbers.clear();
  return answer;
}

void JudgedExternal::report(const suite::Study& study, const external::Answer& answer) const {
  if (!reported_.test_and_set())
    run::note(fmt::format("{}: {} in study {}{}{}; the status of its rows says where", record_.id, name(answer.status),
                          study.id, answer.detail.empty() ? "" : ": ", answer.detail));
}

std::string why_unasked(const suite::Study& study, const suite::ExternalMethod& record) {
  const bool is_code = record.kind == suite::ExternalKind::own || record.kind == suite::ExternalKind::plugin;
  const auto& kind = study_kind(study);
  const auto problem = kind.asks.problem.value_or(Problem::evaluation);
  if (is_kind(study, timing_kind)) {
    if (!is_code) return "its methods are timed, and only a shared object or a compiled-in method can be timed";
    if (&timed_kind(without_external(study)) != &accuracy_kind) return "it times another problem";
  }
  if (kind.make_external == nullptr || std::ranges::count(record.problems, problem) == 0)
    return fmt::format("it is of kind {}", kind.asks.id);
  if (record.kind != suite::ExternalKind::answers && record.form != study.form)
    return fmt::format("its curves are in {} form, the method takes {} form", name(study.form), name(record.form));
  const auto takes = [&](int degree) { return degree >= record.min_degree && degree <= record.max_degree; };
  if ((study.curves.empty() || study.slice) && std::ranges::none_of(study.degree, takes))
    return fmt::format("its degrees are {}, the method takes {} to {}", fmt::join(study.degree, ", "),
                       record.min_degree, record.max_degree);
  if (problem != Problem::evaluation) return {};
  const auto answers_in = [&](suite::ScalarKind scalar) { return std::ranges::count(record.scalars, scalar) > 0; };
  return std::ranges::any_of(study.scalar, answers_in) ? ""
                                                       : fmt::format("it is in {} only", name(study.scalar.front()));
}

std::unique_ptr<run::Job> external_job(const suite::Study& study, const suite::ExternalMethod& record,
                                       const external::Method* given, const run::JobContext& context) {
  if (!why_unasked(study, record).empty()) return nullptr;
  return study_kind(study).make_external(without_external(study), record, given, context);
}

}  // namespace bezierbench::studies
