// SPDX-License-Identifier: MIT
// The length of a random curve over the interval of t, to a tolerance, against the true length. An answer is right if
// it keeps the tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "experiments/external/method.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/promises.hpp"
#include "experiments/studies/trial/trial_columns.hpp"
#include "reference/companion/exact_roots.hpp"
#include "reference/length/length_truth.hpp"

namespace bezierbench::studies {

struct LengthErrors {
  metric::Tally error;     ///< in coordinate units
  metric::Tally relative;  ///< divided by the true length
  Promises promises;

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.relative, self.promises);
  }
};

class ArcLengthProblem {
 public:
  static constexpr Problem problem = Problem::arc_length;
  static constexpr judge::CaseAxes axes{.tolerance = true};
  static constexpr std::string_view table = "arc_length";
  static constexpr std::int64_t block_trials = 16;

  using Kernel = ArcLengthKernel;
  using Answer = ArcLength;
  using Errors = LengthErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    std::optional<reference::LengthTruth> truth;  ///< empty across a pole of a rational curve
  };

  static constexpr std::array case_columns{judge::case_column::tolerance};
  static constexpr std::array columns{
      TrialColumn<Row>{"mean_error", column::statistic<tables::mean, &Errors::error>},
      TrialColumn<Row>{"p50_error", column::statistic<tables::median, &Errors::error>},
      TrialColumn<Row>{"p99_error", column::statistic<tables::p99, &Errors::error>},
      TrialColumn<Row>{"max_error", column::statistic<tables::largest, &Errors::error>},
      TrialColumn<Row>{"mean_relative", column::statistic<tables::mean, &Errors::relative>},
      TrialColumn<Row>{"max_relative", column::statistic<tables::largest, &Errors::relative>},
      TrialColumn<Row>{"mean_evaluations",
                       column::per_trial<&Errors::promises, &Promises::evaluations, &metric::Total::sum>},
      TrialColumn<Row>{"max_evaluations",
                       column::count<&Errors::promises, &Promises::evaluations, &metric::Total::largest>},
      TrialColumn<Row>{"non_converged", column::count<&Errors::promises, &Promises::non_converged>},
      TrialColumn<Row>{"broken_promises", column::count<&Errors::promises, &Promises::broken>},
      TrialColumn<Row>{"non_finite", column::count<&Errors::promises, &Promises::non_finite>},
  };
  static constexpr std::array failures{
      TrialFailure<Row>{"", column::trials<&Errors::promises, &Promises::broken>, run::Broken::promise}};

  static std::span<const Kernel> kernels(int dimension) { return judge::arc_length_methods(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 32; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t /*methods*/) {
    const double n = part.cell.degree + 1.0;
    return 5e4 * n * n;
  }

  ArcLengthProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part,
                   reference::Tier tier = reference::Tier::certified)
      : curves_(study, seed, part.cell), interval_(part.cell.t_interval), tier_(tier) {}

  void draw(std::uint64_t number, Drawn& drawn) const {
    curves_.draw(number, drawn);
    drawn.truth.reset();
    if (!reference::pole(drawn.curve, interval_.min, interval_.max))
      drawn.truth.emplace(drawn.curve, interval_.min, interval_.max, tier_);
  }
  void ask(const Kernel& method, const Drawn& drawn, double tolerance, Answer& answer) const {
    answer = method.measure(drawn.curve, interval_.min, interval_.max, tolerance);
  }
  void give(const Drawn& drawn, double tolerance, external::Batch& batch) const {
    batch.add(drawn.curve, std::array{interval_.min, interval_.max, tolerance});
  }
  static Kernel described(const MethodInfo& info, int dimension) { return {&info, dimension, nullptr}; }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {std::span(&answer.length, 1)}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  judge::CurveSampler curves_;
  suite::Interval interval_;
  reference::Tier tier_;
};

}  // namespace bezierbench::studies
