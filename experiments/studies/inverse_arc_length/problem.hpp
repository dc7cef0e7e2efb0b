// SPDX-License-Identifier: MIT
// The parameter at a share of the length of a random curve, to a tolerance, against the true one. The share is the
// trial's t. An answer is right if the length up to it keeps the tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/arc_length/inverse/kernel.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/studies/promises.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/length/length_truth.hpp"

namespace bezierbench::studies {

// Points of one curve at equal steps of t and at equal steps of the length, for a picture of their spacing.

/// Adds the curve of the study's trial 0 in `cell` to spacing.csv: its outline, and 21 points from end to end, once at
/// equal steps of t (`parameter`) and once at equal steps of the true length (`arc_length`). `share` is the length up
/// to a point over the length of the curve; `gap` is the length from the point before, over the mean gap. Both are
/// empty for the outline and for a curve that is a point. Coordinates are exact values, rounded once.
void add_spacing(tables::Tables& tables, const suite::Study& study, const sample::Cell& cell, std::uint64_t seed);

struct ParameterErrors {
  metric::Tally error;        ///< |length up to t - target|, in coordinate units
  metric::Tally relative;     ///< error over the length of the curve
  metric::Tally t_error;      ///< |t - true parameter|
  metric::Tally iterations;   ///< iterations of the method
  std::uint64_t outside = 0;  ///< trials with t outside [0, 1]
  Promises promises;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.relative, self.t_error, self.iterations, self.outside, self.promises);
  }
};

class InverseArcLengthProblem {
 public:
  static constexpr Problem problem = Problem::inverse_arc_length;
  static constexpr judge::CaseAxes axes{.tolerance = true};
  static constexpr std::string_view table = "inverse_arc_length";
  static constexpr std::int64_t block_trials = 16;

  using Kernel = InverseArcLengthKernel;
  using Answer = InverseArcLength;
  using Errors = ParameterErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    std::optional<reference::AlongTruth> truth;  ///< empty for a rational curve with a pole
    double target = 0;                           ///< the length to find the parameter of
  };

  static constexpr std::array case_columns{judge::case_column::tolerance};
  static constexpr std::array columns{
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
      TrialColumn<Row>{"p99_error", column::statistic<tables::p99, &Errors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"mean_relative", column::statistic<tables::mean, &Errors::relative>},
      TrialColumn<Row>{"max_relative", column::statistic<tables::largest, &Errors::relative>},
      TrialColumn<Row>{"mean_t_error", column::statistic<tables::mean, &Errors::t_error>},
      TrialColumn<Row>{"p50_t_error", column::statistic<tables::median, &Errors::t_error>},
      TrialColumn<Row>{"max_t_error", column::statistic<tables::largest, &Errors::t_error>},
      TrialColumn<Row>{"mean_iterations", column::statistic<tables::mean, &Errors::iterations>},
      TrialColumn<Row>{"max_iterations", column::statistic<tables::largest, &Errors::iterations>},
      TrialColumn<Row>{"mean_evaluations",
                       column::per_trial<&Errors::promises, &Promises::evaluations, &metric::Total::sum>},
      TrialColumn<Row>{"max_evaluations",
                       column::count<&Errors::promises, &Promises::evaluations, &metric::Total::largest>},
      TrialColumn<Row>{"non_converged", column::count<&Errors::promises, &Promises::non_converged>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::promises, &Promises::broken>},
      TrialColumn<Row>{"outside", column::count<&Errors::outside>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::promises, &Promises::non_finite>},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"", column::trials<&Errors::promises, &Promises::broken>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int dimension) { return inverse_arc_length_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 32; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t /*methods*/) {
    const double n = part.cell.degree + 1.0;
    return 1e5 * n * n;
  }

  InverseArcLengthProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part,
                          reference::Tier tier = reference::Tier::certified)
      : curves_(study, seed, part.cell), tier_(tier) {}

  void draw(std::uint64_t number, Drawn& drawn) const;
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& answer) {
    answer = method.solve(drawn.curve, drawn.target, tolerance);
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {std::span(&answer.t, 1)}; }
  static void judge(const Kernel& method, Drawn& drawn, double tolerance, const Answer& answer, std::uint64_t number,
                    Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

  /// Adds the example of the study to spacing.csv.
  static void write_example(tables::Tables& tables, const suite::Study& study, std::uint64_t seed) {
    add_spacing(tables, study, sample::cells(study).front(), seed);
  }

 private:
  judge::CurveSampler curves_;
  reference::Tier tier_;
};

}  // namespace bezierbench::studies
