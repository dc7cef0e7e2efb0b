// SPDX-License-Identifier: MIT
// A point, placed in one of several ways, projected onto a random curve: the foot point against the exact one. An
// answer is right if it does not miss the nearest point. Methods that state a bound of the residual |(C - P).C'| promise
// a t that keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "experiments/external/method.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/sample/placement.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/projection.hpp"

namespace bezierbench::studies {

/// A foot point misses the nearest point if it is farther away than that by more than this times the largest coordinate
/// of the control points and the point. No method is that inaccurate about a minimum that it found.
inline constexpr double missed_tolerance = 0x1p-20;

struct ProjectionErrors {
  metric::Tally error;                 ///< error of the distance, in coordinate units
  metric::Tally error_unit;            ///< error of the distance, in 2^-52 times the largest coordinate
  metric::Tally t_error;               ///< distance from t to the nearest parameter of a nearest point
  metric::Largest<double> residual;    ///< of t, in units of reference::foot_residual
  metric::TrialCount broken_promises;  ///< trials with a residual above its bound, in which the method did not give up
  std::uint64_t missed = 0;
  metric::Total candidates;
  std::uint64_t non_converged = 0;
  std::uint64_t non_finite = 0;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_unit, self.t_error, self.residual, self.broken_promises, self.missed,
                 self.candidates, self.non_converged, self.non_finite);
  }
};

class ProjectionProblem {
 public:
  static constexpr Problem problem = Problem::projection;
  static constexpr judge::CaseAxes axes{.placement = true};
  static constexpr std::string_view table = "projection";
  static constexpr std::int64_t block_trials = 100;

  using Kernel = ProjectionKernel;
  using Answer = FootPoint;
  using Errors = ProjectionErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn {
    sample::ProjectionCase placed;
    reference::ExactProjection exact;
  };

  static constexpr std::array case_columns{judge::case_column::placement};
  static constexpr std::array columns{
      TrialColumn<Row>{"missed", column::count<&Errors::missed>},
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
      TrialColumn<Row>{"p99_error", column::statistic<tables::p99, &Errors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"mean_error_eps", column::statistic<tables::mean, &Errors::error_unit>},
      TrialColumn<Row>{"max_error_eps", column::statistic<tables::largest, &Errors::error_unit>},
      TrialColumn<Row>{"mean_t_error", column::statistic<tables::mean, &Errors::t_error>},
      TrialColumn<Row>{"p50_t_error", column::statistic<tables::median, &Errors::t_error>},
      TrialColumn<Row>{"max_t_error", column::statistic<tables::largest, &Errors::t_error>},
      TrialColumn<Row>{"max_residual",
                       [](const Row& row) {
                         return row.method.info->form == Form::rational ? tables::Field()
                                                                        : tables::field(row.errors.residual);
                       }},
      TrialColumn<Row>{"residual_bound",
                       [](const Row& row) {
                         const auto bound = row.method.residual_bound;
                         return bound == nullptr ? tables::Field()
                                                 : tables::Field(bound(row.cell.degree, row.cell.dimension));
                       }},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::broken_promises>},
      TrialColumn<Row>{"candidates", column::count<&Errors::candidates, &metric::Total::sum>},
      TrialColumn<Row>{"max_candidates", column::count<&Errors::candidates, &metric::Total::largest>},
      TrialColumn<Row>{"non_converged", column::count<&Errors::non_converged>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"residual of t", column::trials<&Errors::broken_promises>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int dimension) { return judge::projection_methods(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 64; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t /*methods*/) {
    const double n = part.cell.degree;
    return n * n * (20'000 + 4 * n * n);  // integers grow with n
  }

  ProjectionProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part);

  void draw(std::uint64_t number, Drawn& drawn) const;
  static void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& foot);
  static void give(const Drawn& drawn, double tolerance, external::Batch& batch);
  static Kernel described(const MethodInfo& info, int dimension) { return {&info, dimension, nullptr}; }
  static std::array<std::span<double>, 2> numbers(Answer& foot) {
    return {std::span(&foot.t, 1), std::span(&foot.distance, 1)};
  }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& foot,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& foot);

 private:
  sample::Cell cell_;
  const sample::Placement& placement_;
  sample::Sampler sampler_;
};

}  // namespace bezierbench::studies
