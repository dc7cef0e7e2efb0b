// SPDX-License-Identifier: MIT
// A random curve split at a random t: every control point of both halves against the exact one. An answer is right if
// every control point keeps its bound or, where none is proved, half of its digits are right.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/external/method.hpp"
#include "experiments/judge/trial_problem.hpp"
#include "experiments/metric/counts.hpp"
#include "experiments/studies/subdivision/split_truth.hpp"
#include "experiments/studies/trial/trial_columns.hpp"

namespace bezierbench::studies {

struct SubdivisionErrors {
  metric::Tally error;  ///< errors of control points
  metric::Tally error_u;
  metric::Largest<double> weight_error_u;
  metric::Largest<double> bound_u;     ///< bound / (u p~) of a control point
  std::uint64_t bounded = 0;           ///< control points for which a bound is proved
  metric::TrialCount violations;       ///< trials with a point or weight beyond its bound
  metric::TrialCount broken_promises;  ///< trials in which ends or a junction differ although the method promises them
  metric::TrialCount junctions_apart;  ///< trials whose halves do not share their junction bit for bit
  metric::TrialCount ends_moved;       ///< trials in which a half does not have its end of the curve bit for bit
  metric::TrialCount points_off;       ///< trials in which the middle of a half is not on the curve, within the bounds
  std::uint64_t middles = 0;           ///< trials in which the middles were compared
  std::uint64_t non_finite = 0;        ///< trials with a number that is not finite; nothing else is judged in these

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.weight_error_u, self.bound_u, self.bounded, self.violations,
                 self.broken_promises, self.junctions_apart, self.ends_moved, self.points_off, self.middles,
                 self.non_finite);
  }
};

class SubdivisionProblem {
 public:
  static constexpr Problem problem = Problem::subdivision;
  static constexpr judge::CaseAxes axes{};
  static constexpr std::string_view table = "subdivision";
  static constexpr std::int64_t block_trials = 64;

  using Kernel = SplitKernel;
  using Answer = std::vector<double>;  ///< the numbers of the left half, then those of the right one
  using Errors = SubdivisionErrors;
  using Row = TrialRow<Kernel, Errors>;
  struct Drawn : judge::DrawnCurve {
    std::optional<SplitTruth> truth;
  };

  static constexpr std::array<judge::CaseColumn, 0> case_columns{};
  static constexpr auto columns = joined(
      error_columns<Row>,
      std::array{
          TrialColumn<Row>{"max_weight_error_u",
                           [](const Row& row) {
                             const bool any = row.errors.error.count() > 0 && row.method.info->form == Form::rational;
                             return any ? tables::field(row.errors.weight_error_u) : tables::Field();
                           }},
          TrialColumn<Row>{"bound_u", column::where_bounded<&Errors::bound_u>},
          TrialColumn<Row>{"bound_violations", column::where_bounded<&Errors::violations>},
          TrialColumn<Row>{"junctions_apart", column::where_any<&Errors::junctions_apart>},
          TrialColumn<Row>{"ends_moved", column::where_any<&Errors::ends_moved>},
          TrialColumn<Row>{"broken_promises", column::where_any<&Errors::broken_promises>},
          TrialColumn<Row>{
              "points_off",
              [](const Row&
                     row) { return row.errors.middles > 0 ? tables::field(row.errors.points_off) : tables::Field(); }},
          TrialColumn<Row>{"non_finite", column::count<&Errors::non_finite>},
      });
  static constexpr std::array failures{
      TrialFailure<Row>{"control points", column::trials<&Errors::violations>},
      TrialFailure<Row>{"ends or junction", column::trials<&Errors::broken_promises>, run::Broken::promise},
      TrialFailure<Row>{"points of a half", column::trials<&Errors::points_off>},
  };

  static std::span<const Kernel> kernels(int dimension) { return split_kernels(dimension); }
  static std::size_t timed_trials(const judge::TrialPart& /*part*/) { return 64; }
  static double trial_nanoseconds(const judge::TrialPart& part, std::size_t methods) {
    const double n = part.cell.degree + 1.0;
    return n * (5000 + 500 * n + 1000 * static_cast<double>(methods));
  }

  SubdivisionProblem(const suite::Study& study, std::uint64_t seed, const judge::TrialPart& part)
      : curves_(study, seed, part.cell) {}

  void draw(std::uint64_t number, Drawn& drawn) const {
    curves_.draw(number, drawn);
    drawn.truth.emplace(drawn.curve, drawn.trial.t);
  }
  static void ask(const Kernel& method, const Drawn& drawn, double /*tolerance*/, Answer& answer) {
    compute_halves(method, drawn.curve, drawn.trial.t, answer);
  }
  static void give(const Drawn& drawn, double /*tolerance*/, external::Batch& batch) {
    batch.add(drawn.curve, std::span(&drawn.trial.t, 1));
  }
  static Kernel described(const MethodInfo& info, int dimension) {
    static constexpr SplitPromises none{};
    return {&info, &none, nullptr, dimension, nullptr};
  }
  static std::array<std::span<double>, 1> numbers(Answer& answer) { return {answer}; }
  static void judge(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer,
                    std::uint64_t number, Errors& errors);
  static bool is_right(const Kernel& method, const Drawn& drawn, double tolerance, const Answer& answer);

 private:
  judge::CurveSampler curves_;
};

}  // namespace bezierbench::studies
