// SPDX-License-Identifier: MIT
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"

#include <cmath>

#include "core/arc_length/inverse/kernel.hpp"
#include "experiments/studies/inverse_arc_length/spacing.hpp"
#include "experiments/studies/tolerance_study.hpp"
#include "reference/length_along.hpp"

namespace bezierbench::studies {
namespace {

using reference::LongReal;

struct ParameterErrors {
  metric::Tally error;        ///< of the length up to t, in coordinate units
  metric::Tally relative;     ///< that over the length of the curve
  metric::Tally t_error;      ///< of t
  metric::Tally iterations;   ///< their number
  std::uint64_t outside = 0;  ///< trials with t outside [0, 1]
  Promises promises;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.relative, self.t_error, self.iterations, self.outside, self.promises);
  }

  void merge(const ParameterErrors& other) {
    error.merge(other.error);
    relative.merge(other.relative);
    t_error.merge(other.t_error);
    iterations.merge(other.iterations);
    outside += other.outside;
    promises.merge(other.promises);
  }
};

double rounded(const LongReal& error) { return metric::to_24_bits(error.convert_to<double>()); }

void judge(const ToleranceTrial<InverseArcLengthKernel>& trial, std::vector<ParameterErrors>& rows) {
  const auto curve = trial.curve();
  const reference::LengthAlong truth(curve);
  const double length = truth.whole().convert_to<double>();
  const double target = LongReal(trial.drawn.t * truth.whole()).convert_to<double>();
  const LongReal exact = truth.parameter_at(target);
  auto* row = rows.data();
  for (const double tolerance : trial.tolerances)
    for (const auto* method : trial.methods) {
      ParameterErrors& errors = *row++;
      const auto result = method->solve(curve, target, tolerance);
      errors.promises.add(result.converged, result.evaluations);
      errors.iterations.add(static_cast<double>(result.iterations));
      if (!std::isfinite(result.t)) {
        ++errors.promises.non_finite;
        continue;
      }
      const double error = rounded(truth.distance(LongReal(result.t), target));
      errors.error.add(error);
      errors.relative.add(error == 0 ? 0 : metric::to_24_bits(error / length));
      errors.t_error.add(rounded(abs(LongReal(result.t) - exact)));
      errors.outside += result.t < 0 || result.t > 1 ? 1 : 0;
      errors.promises.judge(result.converged, error, tolerance * length, trial.number);
    }
}

using Fields = ToleranceFields<ParameterErrors>;

std::string outside(const ParameterErrors& row, std::int64_t /*trials*/) { return std::to_string(row.outside); }

constexpr ToleranceColumn<ParameterErrors> columns[]{
    {"mean_error", Fields::statistic<&ParameterErrors::error, Fields::mean>},
    {"p50_error", Fields::statistic<&ParameterErrors::error, Fields::median>},
    {"p99_error", Fields::statistic<&ParameterErrors::error, Fields::p99>},
    {"max_error", Fields::statistic<&ParameterErrors::error, Fields::largest>},
    {"mean_relative", Fields::statistic<&ParameterErrors::relative, Fields::mean>},
    {"max_relative", Fields::statistic<&ParameterErrors::relative, Fields::largest>},
    {"mean_t_error", Fields::statistic<&ParameterErrors::t_error, Fields::mean>},
    {"p50_t_error", Fields::statistic<&ParameterErrors::t_error, Fields::median>},
    {"max_t_error", Fields::statistic<&ParameterErrors::t_error, Fields::largest>},
    {"mean_iterations", Fields::statistic<&ParameterErrors::iterations, Fields::mean>},
    {"max_iterations", Fields::statistic<&ParameterErrors::iterations, Fields::largest>},
    {"mean_evaluations", Fields::mean_evaluations},
    {"max_evaluations", Fields::count<&Promises::most_evaluations>},
    {"non_converged", Fields::count<&Promises::non_converged>},
    {"broken_promises", Fields::count<&Promises::broken>},
    {"outside", outside},
    {"non_finite", Fields::count<&Promises::non_finite>},
};

constexpr ToleranceProblem<InverseArcLengthKernel, ParameterErrors> problem{.problem = Problem::inverse_arc_length,
                                                                            .table = "inverse_arc_length",
                                                                            .kernels = inverse_arc_length_kernels,
                                                                            .columns = columns,
                                                                            .judge = judge};

class InverseArcLengthJob final : public ToleranceJob<InverseArcLengthKernel, ParameterErrors> {
 public:
  using ToleranceJob::ToleranceJob;

  void write(tables::Tables& tables) const override {
    ToleranceJob::write(tables);
    add_spacing(tables, study(), cell(0), seed());
  }
};

}  // namespace

std::unique_ptr<run::Job> inverse_arc_length_job(const suite::Study& study, const run::JobContext& context) {
  return std::make_unique<InverseArcLengthJob>(study, context.seed, problem);
}

}  // namespace bezierbench::studies
