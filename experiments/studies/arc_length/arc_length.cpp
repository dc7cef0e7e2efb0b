// SPDX-License-Identifier: MIT
#include "experiments/studies/arc_length/arc_length.hpp"

#include <cmath>

#include "experiments/judge/methods.hpp"
#include "experiments/studies/tolerance_study.hpp"
#include "reference/true_length.hpp"

namespace bezierbench::studies {
namespace {

struct LengthErrors {
  metric::Tally error;     ///< in coordinate units
  metric::Tally relative;  ///< to the true length
  Promises promises;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.relative, self.promises);
  }

  void merge(const LengthErrors& other) {
    error.merge(other.error);
    relative.merge(other.relative);
    promises.merge(other.promises);
  }
};

void judge(const ToleranceTrial<ArcLengthKernel>& trial, std::vector<LengthErrors>& rows) {
  const auto curve = trial.curve();
  const auto [from, to] = trial.cell.t_interval;
  const reference::TrueLength truth(curve, from, to);
  const auto length = truth.value().convert_to<double>();
  auto* row = rows.data();
  for (const double tolerance : trial.tolerances)
    for (const auto* method : trial.methods) {
      LengthErrors& errors = *row++;
      const auto result = method->measure(curve, from, to, tolerance);
      errors.promises.add(result.converged, result.evaluations);
      const double error = metric::to_24_bits(truth.error_of(result.length));
      if (!std::isfinite(error)) {
        ++errors.promises.non_finite;
        continue;
      }
      errors.error.add(error);
      errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
      errors.promises.judge(result.converged, error, tolerance * length, trial.number);
    }
}

using Fields = ToleranceFields<LengthErrors>;

constexpr ToleranceColumn<LengthErrors> columns[]{
    {"mean_error", Fields::statistic<&LengthErrors::error, Fields::mean>},
    {"p50_error", Fields::statistic<&LengthErrors::error, Fields::median>},
    {"p99_error", Fields::statistic<&LengthErrors::error, Fields::p99>},
    {"max_error", Fields::statistic<&LengthErrors::error, Fields::largest>},
    {"mean_relative", Fields::statistic<&LengthErrors::relative, Fields::mean>},
    {"max_relative", Fields::statistic<&LengthErrors::relative, Fields::largest>},
    {"mean_evaluations", Fields::mean_evaluations},
    {"max_evaluations", Fields::count<&Promises::most_evaluations>},
    {"non_converged", Fields::count<&Promises::non_converged>},
    {"broken_promises", Fields::count<&Promises::broken>},
    {"non_finite", Fields::count<&Promises::non_finite>},
};

constexpr ToleranceProblem<ArcLengthKernel, LengthErrors> problem{.problem = Problem::arc_length,
                                                                  .table = "arc_length",
                                                                  .kernels = judge::arc_length_methods,
                                                                  .columns = columns,
                                                                  .judge = judge};

}  // namespace

std::unique_ptr<run::Job> arc_length_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<ToleranceJob<ArcLengthKernel, LengthErrors>>(study, context.seed, problem);
}

}  // namespace bezierbench::studies
